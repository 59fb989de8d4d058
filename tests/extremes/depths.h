// SPDX-License-Identifier: MIT
// The same geometry drawn again: where its depth is what it was. By primitives.h a triangle's plane depends on its corners, and
// on which of them comes first, but not on the way round.
#pragma once

#include "tests/extremes/extremes.h"

namespace extremes {

// How the second drawing differs: not at all; corners 0 2 1; corners 1 2 0; the other diagonal of the square.
enum class Again : std::uint8_t { Same, WayRound, FirstCorner, Diagonal };

// What the triangles are: as they are, or such that the guard band cuts them.
enum class Size : std::uint8_t { Whole, Cut };

// Of coplanar triangles drawn again. Pixels that fail EQUAL, and LESSEQUAL.
struct Ties {
    std::uint64_t pixels = 0, not_equal = 0, not_less_equal = 0;
};
Ties depth_ties(int depth_bits, Size size, Again again);

// The greatest difference of depth between triangles with 0 1 2 and 1 2 0, up to the longest sides there are, in units of 2^-30.
// Both have the same gradients, each less than one unit of 2^-12 short, so that the planes differ by less than |dx| + |dy| <
// 2^20 of these units; each is rounded once.
std::uint32_t first_corner_difference();
inline constexpr std::uint32_t kFirstCornerBound = (1 << 20) / 4096 + 1;

}  // namespace extremes
