// SPDX-License-Identifier: MIT
// The instruction sets that the kernels are compiled for and this processor has.
#pragma once

#include <string>
#include <vector>

namespace raster {

std::vector<std::string> simd_targets();  // Highway's names, best first

// All later fills use this one; "" goes back to the best. False if there is no such target here.
bool force_simd_target(const std::string& name);

}  // namespace raster
