// SPDX-License-Identifier: MIT
// By which fill kernels a frame is drawn: those compiled for one state, by the names that raster/special_names.h gives
// them, and the two for all states. The least instruction set (SCALAR) has the latter alone.
#pragma once

#include <string_view>
#include <vector>

#include "pipeline/frame/frame.h"

namespace pipeline {

// name: "general" if it is for all states.
struct FillKernelName {
    std::string_view primitive;  // "triangles" or "rectangles"
    std::string_view name;
    bool is_special                              = false;
    bool operator==(const FillKernelName&) const = default;
};

// All there are.
std::vector<FillKernelName> fill_kernel_names();

// One for each draw of a valid frame that is no copy, in order.
std::vector<FillKernelName> fill_kernels_of(const Frame& frame);

}  // namespace pipeline
