// SPDX-License-Identifier: MIT
// Copies the pixels of `from` to the place with top left corner (x, y), or each 2x2 of them as one: both must lie within the
// images, which are two. What is written goes through the target's format. Each channel of four pixels a, b, c, d becomes, by the
// source's format,
//   8 bits, or none   (a + b + c + d) >> 2
//   6 bits            S + (S >> 6), S the sum of the four 6-bit values
// and sources with other channels are not halved. What moves from one channel to another leaves the others as they are.
#pragma once

#include <cstdint>

#include "raster/color_format.h"
#include "raster/image.h"
#include "raster/tile.h"

namespace raster {

enum class CopyChannels : std::uint8_t { All, AlphaToColor, GreenToAlpha };

struct CopyFill {
    const Image* source = nullptr;
    ColorFormat source_format;
    Rect from;  // if halved, of even size
    Image* target = nullptr;
    ColorFormat target_format;
    int x = 0, y = 0;
    bool halve            = false;
    CopyChannels channels = CopyChannels::All;  // others only if not halved
};
void copy_pixels(const CopyFill& copy);
void reference_copy_pixels(const CopyFill& copy);

}  // namespace raster
