// SPDX-License-Identifier: MIT
// Kernels: batch.color into the colour target where batch.mask has bits: steps 7 to 9 of raster/fill_state.h. A bit that is not
// set in the mask of a lane, or in the write mask, stays as it is in the target.
#pragma once

#include <array>
#include <cstdint>

#include "raster/fill_state.h"
#include "raster/fragment_batch.h"
#include "raster/image.h"

namespace raster {

struct alignas(64) BlendPlan {
    Blend blend;
    StoreMasks store;
    std::uint32_t source_mask = 0xffffffff;  // what the blender sees of the fragment
    // Of the pixels of a block in row y & 3, as pairs of 16-bit numbers.
    alignas(64) std::array<std::array<std::uint32_t, kBlockWidth>, 4> dither{};
};
BlendPlan plan_blend(const Blend& blend, const ColorFormat& format);

using BlendKernel = void (*)(const BlendPlan& plan, Image& target, const FragmentBatch& batch);

// This processor's kernel for this plan: a fused one where there is one, else the one that works for all states of its rule.
// `generic` asks for the latter, so that tests can compare the two.
BlendKernel blend_kernel(const BlendPlan& plan, bool generic = false);

}  // namespace raster
