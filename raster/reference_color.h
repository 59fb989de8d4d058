// SPDX-License-Identifier: MIT
// The oracle's reading of fill_state.h and color_format.h: what becomes of a fragment's colour, one channel at a time.
// Colours are 0xAARRGGBB.
#pragma once

#include <array>
#include <cstdint>

#include "raster/fill_state.h"

namespace raster::reference {

// A covered pixel with everything that was interpolated and sampled for it.
struct FragmentColors {
    std::uint32_t diffuse = 0, specular = 0;
    std::array<std::uint32_t, kMaxTextures> texels{};
};

// Steps 2 to 4: stages, specular, fog.
std::uint32_t combined_color(const FillState& state, const FragmentColors& fragment);

bool passes(Compare func, std::uint32_t fragment, std::uint32_t reference);

// Steps 7 to 9: what stands at pixel (x, y) of the colour target afterwards.
std::uint32_t blended_color(const Blend& blend, const ColorFormat& format, std::uint32_t source, std::uint32_t dest,
                            int x, int y);

// What a target of `format` gives back of a colour written to it.
std::uint32_t stored_color(const ColorFormat& format, std::uint32_t argb);

}  // namespace raster::reference
