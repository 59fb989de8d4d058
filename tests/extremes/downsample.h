// SPDX-License-Identifier: MIT
// Odd sizes halved down to one texel by bilinear blits: each size n becomes (n + 1) / 2, whose pixels' centres fall on the
// corners that four texels share, the last row and column of an odd size being counted twice.
#pragma once

#include <array>

#include "pipeline/frame/frame.h"
#include "tests/extremes/extremes.h"

namespace extremes {

// The chain's one texel: of all levels the last. `texture` is the frame's texture 0, of width x height.
pipeline::Frame downsample_frame(pipeline::FilterRule filter, int width, int height,
                                 const std::vector<std::uint8_t>& texels);
int halvings(int width, int height);

inline constexpr std::array<std::array<int, 2>, 12> kChains{{{1, 1},
                                                             {3, 1},
                                                             {1, 3},
                                                             {5, 3},
                                                             {7, 7},
                                                             {33, 17},
                                                             {101, 99},
                                                             {255, 257},
                                                             {1025, 1},
                                                             {4097, 3},
                                                             {3, 4097},
                                                             {4095, 5}}};

// Constants that a chain has changed, of bytes 0, 1, 127, 128, 254, 255 in all channels.
std::uint64_t changed_constants(pipeline::FilterRule filter, int width, int height);

// The last texel of noise less that of the same chain in double, in 255ths, and that over the number of halvings.
struct Energy {
    double least = 0.0, greatest = 0.0;
    int halvings = 0;
};
Energy energy_drift(pipeline::FilterRule filter, int width, int height, std::uint32_t seed);

// What one halving may take from, or add to, the exact mean of four bytes: a multiple of 1/4 rounded, once or twice.
struct HalvingError {
    double least = 0.0, greatest = 0.0;
};
HalvingError halving_error(pipeline::FilterRule filter);

}  // namespace extremes
