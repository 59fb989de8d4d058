// SPDX-License-Identifier: MIT
// Quotients for tests of byte arithmetic: by division of integers, and checked by multiplication, never by the
// kernels' shifts and reciprocals. And pixels by channel.
#pragma once

#include <array>
#include <cstdint>

namespace exact {

// The largest q with q * divisor <= n; the divisor is positive.
constexpr int floor_quotient(int n, int divisor) {
    const int q = n / divisor;
    return q * divisor > n ? q - 1 : q;
}
static_assert(floor_quotient(-1, 128) == -1 && floor_quotient(-128, 128) == -1 && floor_quotient(127, 128) == 0);

// The q with |2 * 255 * q - 2 * n| <= 255, that is n / 255 to the nearest; n >= 0. There is one, for 255 is odd.
constexpr int nearest_255th(int n) {
    return static_cast<int>(static_cast<unsigned>(2 * n + 255) / 510u);
}
static_assert(nearest_255th(127) == 0 && nearest_255th(128) == 1 && nearest_255th(65025) == 255);

// A factor of 0..255 as 0..256.
constexpr int to_256(int factor) {
    return factor < 128 ? factor : factor + 1;
}

struct Pixel {
    std::array<int, 4> c{};  // blue, green, red, alpha
    static constexpr Pixel of(std::uint32_t argb) {
        return {{static_cast<int>(argb & 255), static_cast<int>(argb >> 8 & 255), static_cast<int>(argb >> 16 & 255),
                 static_cast<int>(argb >> 24)}};
    }
    constexpr std::uint32_t argb() const {
        return static_cast<std::uint32_t>(c[0] | c[1] << 8 | c[2] << 16) | static_cast<std::uint32_t>(c[3]) << 24;
    }
};

// An order of the bytes for each channel, so that the channels of a pixel differ.
constexpr int shuffled(int channel, int i) {
    constexpr std::array kTurn{1, 255, 77, 205};
    return (kTurn[static_cast<std::size_t>(channel)] * i + 50 * channel) & 255;
}

}  // namespace exact
