// SPDX-License-Identifier: MIT
// Texture coordinates far from 0: where a texture is read, against double.
#pragma once

#include <algorithm>
#include <cstdint>

#include "raster/sampling_rules.h"
#include "tests/extremes/extremes.h"

namespace extremes {

// What the corners of the triangles have for 1/w: one, as far from the eye as the other, or 1 to 4.
enum class Depths : std::uint8_t { Equal, OneToFour };

// The greatest error of the position in texels, and how far it lies ahead, over two triangles of 256x16 pixels that show a
// texture of 256x256 texels, one texel to the pixel, up to 2^exponent texels left or right; and the pixels whose texel is
// none that the bound allows.
struct PositionError {
    double texels              = 0.0;
    double ahead               = 0.0;
    std::uint64_t pixels       = 0;
    std::uint64_t wrong_texels = 0;
};
PositionError position_error(int exponent, Depths depths, raster::Address address);

// What sampling_rules.h allows at 2^exponent texels: relative to the coordinate, of s (F = 12, S = 12; 2^13 subpixels at
// most, so less than 2 + 8 + 1/2 units of 2^-28 and 2^-29 for the corner) and, where 1/w varies, of q, at a pixel a quarter
// of its greatest; 2^-24 for each of the products at a corner, for float(s), float(q), r, u, u * ku; and 1/256 texel to floor.
constexpr double position_bound(int exponent, Depths depths) {
    const double plane    = 10.5 * 0x1p-28 + 0x1p-29,
                 texels   = std::max(512.0, static_cast<double>(std::uint64_t{1} << exponent));
    const double relative = depths == Depths::Equal ? plane + 4 * 0x1p-24 : 4 * (plane + plane) + 7 * 0x1p-24;
    return texels * relative + 1.0 / 256.0;
}

// A position is floored: it lies ahead by less than the floor takes.
constexpr double ahead_bound(int exponent, Depths depths) {
    return position_bound(exponent, depths) - 1.0 / 256.0;
}

inline constexpr int kLastExponent = 22;  // of texels: 2^30 in 1/256 texel, where the rules clamp

}  // namespace extremes
