// SPDX-License-Identifier: MIT
// Kernels: the alpha test and the depth test with depth write. Both clear lanes of the mask and drop blocks that have none left.
#pragma once

#include <cstdint>

#include "raster/fill_state.h"
#include "raster/fragment_batch.h"
#include "raster/image.h"

namespace raster {

// Both return the fragments that pass.
struct TestKernels {
    std::uint64_t (*alpha)(Compare func, std::uint8_t reference, FragmentBatch& batch);  // of batch.color
    std::uint64_t (*depth)(Compare func, bool write, Image& target, FragmentBatch& batch);
};
TestKernels test_kernels();  // for this processor

}  // namespace raster
