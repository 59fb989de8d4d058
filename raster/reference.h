// SPDX-License-Identifier: MIT
// The oracle: the same fill as raster/fill_pass.h, one pixel and one primitive at a time, in plain scalar C++ written
// from the rules in primitives.h, sampling_rules.h, fill_state.h and color_format.h. It shares no arithmetic with the
// kernels, and no speed.
#pragma once

#include "raster/fill_pass.h"

namespace raster {

FillCounts reference_fill_pass(const PassFill& pass);

// What is there once a colour has been written to a target (raster/color_format.h).
std::uint32_t reference_stored(const ColorFormat& format, std::uint32_t argb);

}  // namespace raster
