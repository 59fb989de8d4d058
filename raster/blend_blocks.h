// SPDX-License-Identifier: MIT
// Kernels: batch.color into the colour target where batch.mask is set: div255(min(65025, source * Fs + dest * Fd)), then only
// the channels of the write mask.
#pragma once

#include <cstdint>

#include "raster/fill_state.h"
#include "raster/fragment_batch.h"
#include "raster/image.h"

namespace raster {

struct BlendConstants {
    BlendFactor source, dest;
    std::uint32_t write_mask = 0xffffffff;
};

using BlendKernel = void (*)(const BlendConstants& constants, Image& target, const FragmentBatch& batch);

// This processor's kernel for these factors: a fused one where there is one, else the one that works for all. `generic`
// asks for the latter, so that tests can compare the two.
BlendKernel blend_kernel(const BlendConstants& constants, bool generic = false);

}  // namespace raster
