// SPDX-License-Identifier: MIT
// Which lanes of eight a mask has, as bytes: the first in the lowest byte of a word.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace raster {

static_assert(std::endian::native == std::endian::little);

// For each mask of 8 bits: its set bits' numbers, in order, then zeros.
inline constexpr std::array<std::uint64_t, 256> kLanesOfMask = [] {
    std::array<std::uint64_t, 256> table{};
    for (unsigned mask = 0; mask < 256; ++mask)
        for (int lane = 7; lane >= 0; --lane)
            if (mask >> lane & 1) table[mask] = table[mask] << 8 | static_cast<std::uint64_t>(lane);
    return table;
}();

// For each mask of 8 bits and each lane: how many bits are set below it, 7 at most.
inline constexpr std::array<std::uint64_t, 256> kRanks = [] {
    std::array<std::uint64_t, 256> table{};
    for (unsigned mask = 0; mask < 256; ++mask)
        for (int lane = 7; lane >= 0; --lane)
            table[mask] = table[mask] << 8 | static_cast<std::uint64_t>(std::popcount(mask & ((1u << lane) - 1)));
    return table;
}();

}  // namespace raster
