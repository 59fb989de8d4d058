// SPDX-License-Identifier: MIT
// The oracle's copy_pixels, in the words of copy_pixels.h.
#include <cstdint>

#include "raster/copy_pixels.h"
#include "raster/reference_color.h"

namespace raster {

namespace {

// The pixels (x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1) as one.
std::uint32_t mean_of_four(const Image& image, const ColorFormat& format, int x, int y) {
    std::uint32_t color = 0;
    for (int c = 0; c < 4; ++c) {
        const bool six_bits = channel_bits(format, c) == 6;
        std::uint32_t sum   = 0;
        for (int k = 0; k < 4; ++k) {
            const std::uint32_t byte = (image.row(y + k / 2)[x + k % 2] >> (8 * c)) & 255;
            sum += six_bits ? byte >> 2 : byte;
        }
        color |= (six_bits ? sum + (sum >> 6) : sum >> 2) << (8 * c);
    }
    return color;
}

// Channel c of what `to` becomes.
std::uint32_t moved_channel(CopyChannels channels, std::uint32_t from, std::uint32_t to, int c) {
    const auto channel = [](std::uint32_t color, int i) { return (color >> (8 * i)) & 255; };
    if (channels == CopyChannels::AlphaToColor) return c == 3 ? channel(to, 3) : channel(from, 3);
    if (channels == CopyChannels::GreenToAlpha) return c == 3 ? channel(from, 1) : channel(to, c);
    return channel(from, c);
}

}  // namespace

void reference_copy_pixels(const CopyFill& copy) {
    const int scale = copy.halve ? 2 : 1;
    for (int y = copy.from.y0; y < copy.from.y1; y += scale) {
        for (int x = copy.from.x0; x < copy.from.x1; x += scale) {
            const std::uint32_t from =
                copy.halve ? mean_of_four(*copy.source, copy.source_format, x, y) : copy.source->row(y)[x];
            std::uint32_t& to =
                copy.target->row(copy.y + (y - copy.from.y0) / scale)[copy.x + (x - copy.from.x0) / scale];
            std::uint32_t color = 0;
            for (int c = 0; c < 4; ++c) color |= moved_channel(copy.channels, from, to, c) << (8 * c);
            to = reference::stored_color(copy.target_format, color);
        }
    }
}

}  // namespace raster
