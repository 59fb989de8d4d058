// SPDX-License-Identifier: MIT
// The general kernels draw every state, by the code that the special ones are compiled from, and are soon compiled with
// sanitizers; that both draw the same is tested elsewhere.
#include "raster/fill_kernels.h"

namespace raster {

FillKernel::Triangle special_triangle_kernel(const FillProgram&) {
    return nullptr;
}
FillKernel::Rectangle special_rectangle_kernel(const FillProgram&) {
    return nullptr;
}

}  // namespace raster
