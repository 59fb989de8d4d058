// SPDX-License-Identifier: MIT
// Kernels: the alpha tests, and the depth test with depth write. All clear lanes of the mask and drop blocks that have none left.
#pragma once

#include <cstdint>

#include "raster/fill_state.h"
#include "raster/fragment_batch.h"
#include "raster/image.h"

namespace raster {

// All return how many fragments go on.
struct TestKernels {
    // Of batch.color. Unless `fail` is Keep all lanes go on, and batch.passed has those that passed.
    std::uint64_t (*alpha)(Compare func, std::uint8_t reference, AlphaFail fail, FragmentBatch& batch);
    std::uint64_t (*dest_alpha)(DestAlphaTest test, const Image& target, FragmentBatch& batch);
    // `passed_only`: depth is written only where batch.passed is set. Counts what it writes in `written`.
    std::uint64_t (*depth)(Compare func, bool write, bool passed_only, Image& target, FragmentBatch& batch,
                           std::uint64_t& written);
    // Leaves of batch.mask only these bits where batch.passed is not set.
    std::uint64_t (*limit_color)(std::uint32_t bits_if_failed, FragmentBatch& batch);
};
TestKernels test_kernels();  // for this processor

}  // namespace raster
