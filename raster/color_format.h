// SPDX-License-Identifier: MIT
// How a colour target keeps what is written to it. An Image holds what reading it gives back, four bytes 0xAARRGGBB, so a
// format is a function from the colour written to that. Of each channel the top n = 8, 6, 5 or 1 bits are kept:
//   kept = v >> (8 - n)
//   read = kept << (8 - n)                            if `zero_fill`
//          the bits of `kept`, repeated until there are 8   if not: 6 bits give kept << 2 | kept >> 4, one bit gives 0 or 255
// A channel with 0 bits keeps nothing and reads as 255, or as 128 if `zero_fill`.
#pragma once

#include <cstdint>

namespace raster {

struct ColorFormat {
    int red = 8, green = 8, blue = 8, alpha = 8;
    bool zero_fill                            = false;
    bool operator==(const ColorFormat&) const = default;
};

constexpr int channel_bits(const ColorFormat& format, int channel) {  // blue, green, red, alpha
    return channel == 0 ? format.blue : channel == 1 ? format.green : channel == 2 ? format.red : format.alpha;
}

// A format as a formula without branches, for four channels at once:
//   (v & keep) | ((v >> 5) & repeat5) | ((v >> 6) & repeat6) | ((v >> 31, arithmetic) & repeat1) | set
struct StoreMasks {
    std::uint32_t keep = 0xffffffff, repeat5 = 0, repeat6 = 0, repeat1 = 0, set = 0;
    bool operator==(const StoreMasks&) const = default;
};
StoreMasks store_masks(const ColorFormat& format);
std::uint32_t stored(const StoreMasks& masks, std::uint32_t argb);

// What is there once a colour has been written.
std::uint32_t stored(const ColorFormat& format, std::uint32_t argb);

}  // namespace raster
