// SPDX-License-Identifier: MIT
// A pass as a function of the Direct3D 7 program.
#pragma once

#include <string>

#include "pipeline/emit/dx7_data.h"
#include "pipeline/emit/dx7_surfaces.h"

namespace pipeline::dx7 {

// static void pass_3() { ... }
std::string pass_function(const Frame& frame, std::size_t pass, const Surfaces& surfaces, const Data& data);

}  // namespace pipeline::dx7
