// SPDX-License-Identifier: MIT
// A level of a texture that has nothing but alpha, as words of 2x2 alphas: what a bilinear sample reads, in one piece. Word
// (i + 1, j + 1), with i in -1..width-1 and j in -1..height-1, holds the alphas at (i, j), (i+1, j), (i, j+1), (i+1, j+1), the
// first in the lowest byte, indices clamped to the level. So it serves clamped addresses.
#pragma once

#include <cstddef>
#include <cstdint>

namespace raster {

constexpr std::size_t alpha_quad_count(int width, int height) {
    return static_cast<std::size_t>(width + 1) * static_cast<std::size_t>(height + 1);
}

// alphas: rows from the top, without padding. out: rows of width + 1 words.
void pack_alpha_quads(const std::uint8_t* alphas, int width, int height, std::uint32_t* out);

}  // namespace raster
