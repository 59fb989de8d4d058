// SPDX-License-Identifier: MIT
// Targets as small and as large as they may be, and larger.
#pragma once

#include <array>

#include "tests/extremes/coverage.h"
#include "tests/extremes/extremes.h"

namespace extremes {

// Two triangles and a rectangle over all of a target: each hits each pixel once.
Hits size_hits(int width, int height);

inline constexpr std::array<std::array<int, 2>, 9> kSizes{
    {{1, 1}, {1, 8192}, {8192, 1}, {3, 5}, {63, 33}, {65, 31}, {4097, 3}, {8191, 7}, {8192, 8192}}};
inline constexpr std::array<std::array<int, 2>, 4> kTooLarge{
    {{8193, 1}, {1, 8193}, {8193, 8193}, {2147483647, 2147483647}}};

// Is a target of that size refused, in words and before its memory is asked for?
bool is_refused(int width, int height);

}  // namespace extremes
