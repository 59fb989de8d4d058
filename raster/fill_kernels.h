// SPDX-License-Identifier: MIT
// The fill loop, compiled: for each program of raster/special_programs.h, and once for all others.
#pragma once

#include "raster/fill_plan.h"
#include "raster/fill_program.h"

namespace raster {

// This processor's kernel for the program. general: the one for all programs, so that tests can compare the two.
FillKernel fill_kernel(const FillProgram& program, bool general = false);

// Null if there is none for this program.
FillKernel::Triangle special_triangle_kernel(const FillProgram& program);
FillKernel::Rectangle special_rectangle_kernel(const FillProgram& program);

}  // namespace raster
