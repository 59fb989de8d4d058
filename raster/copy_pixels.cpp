// SPDX-License-Identifier: MIT
#include "raster/copy_pixels.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

namespace raster {
namespace {

// One channel of the sum of four pixels: a byte of the halved picture.
struct HalveChannel {
    int shift;
    bool six_bits;
    std::uint32_t operator()(const std::array<std::uint32_t, 4>& pixels) const {
        std::uint32_t sum = 0;
        for (const std::uint32_t pixel : pixels) sum += (pixel >> shift & 255) >> (six_bits ? 2 : 0);
        return (six_bits ? sum + (sum >> 6) : sum >> 2) << shift;
    }
};

std::uint32_t moved(CopyChannels channels, std::uint32_t from, std::uint32_t to) {
    switch (channels) {
        case CopyChannels::All:
            return from;
        case CopyChannels::AlphaToColor:
            return (to & 0xff000000) | (from >> 24) * 0x010101;
        case CopyChannels::GreenToAlpha:
            return (to & 0x00ffffff) | (from << 16 & 0xff000000);
    }
    return to;
}

}  // namespace

void copy_pixels(const CopyFill& copy) {
    const StoreMasks masks = store_masks(copy.target_format);
    std::array<HalveChannel, 4> halve_channel{};
    for (int channel = 0; channel < 4; ++channel)
        halve_channel[channel] = {8 * channel, channel_bits(copy.source_format, channel) == 6};
    const int step  = copy.halve ? 2 : 1;
    const int width = (copy.from.x1 - copy.from.x0) / step, height = (copy.from.y1 - copy.from.y0) / step;
    tbb::parallel_for(0, height, [&](int row) {
        const std::uint32_t* const from = copy.source->row(copy.from.y0 + step * row) + copy.from.x0;
        std::uint32_t* const to         = copy.target->row(copy.y + row) + copy.x;
        if (!copy.halve) {
            std::transform(from, from + width, to, to, [&](std::uint32_t pixel, std::uint32_t there) {
                return stored(masks, moved(copy.channels, pixel, there));
            });
            return;
        }
        const std::uint32_t* const below = from + copy.source->stride();
        for (int x = 0; x < width; ++x) {
            const std::array<std::uint32_t, 4> pixels{from[2 * x], from[2 * x + 1], below[2 * x], below[2 * x + 1]};
            std::uint32_t halved = 0;
            for (const HalveChannel& channel : halve_channel) halved |= channel(pixels);
            to[x] = stored(masks, halved);
        }
    });
}

}  // namespace raster
