// SPDX-License-Identifier: MIT
// The numbers of a blend, as the fill loop wants them.
#pragma once

#include <array>
#include <cstdint>

#include "raster/color_format.h"
#include "raster/fill_state.h"
#include "raster/tile.h"

namespace raster {

struct alignas(64) BlendPlan {
    // Of the pixels of a block in row y & 3, as pairs of 16-bit numbers.
    alignas(64) std::array<std::array<std::uint32_t, kBlockWidth>, 4> dither{};
    StoreMasks store;
    std::uint32_t write_mask     = 0xffffffff;
    std::uint32_t source_mask    = 0xffffffff;  // what the blender sees of the fragment
    std::uint8_t shift7_constant = 0;
};
BlendPlan plan_blend(const Blend& blend, const ColorFormat& format);

}  // namespace raster
