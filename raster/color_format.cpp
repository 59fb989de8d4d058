// SPDX-License-Identifier: MIT
#include "raster/color_format.h"

namespace raster {

StoreMasks store_masks(const ColorFormat& format) {
    StoreMasks masks;
    masks.keep = 0;
    for (int channel = 0; channel < 4; ++channel) {
        const int shift = 8 * channel, bits = channel_bits(format, channel);
        masks.keep |= (0xffu & (0xffu << (8 - bits))) << shift;
        if (bits == 0) masks.set |= (format.zero_fill ? 0x80u : 0xffu) << shift;
        if (format.zero_fill) continue;
        if (bits == 5) masks.repeat5 |= 0x07u << shift;
        if (bits == 6) masks.repeat6 |= 0x03u << shift;
        if (bits == 1) masks.repeat1 |= 0x7fu << shift;  // only alpha: its bit is the sign
    }
    return masks;
}

std::uint32_t stored(const StoreMasks& masks, std::uint32_t argb) {
    const auto sign = static_cast<std::uint32_t>(static_cast<std::int32_t>(argb) >> 31);
    return (argb & masks.keep) | (argb >> 5 & masks.repeat5) | (argb >> 6 & masks.repeat6) | (sign & masks.repeat1) |
           masks.set;
}

std::uint32_t stored(const ColorFormat& format, std::uint32_t argb) {
    return stored(store_masks(format), argb);
}

}  // namespace raster
