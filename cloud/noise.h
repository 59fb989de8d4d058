// SPDX-License-Identifier: MIT
// Seeded gradient noise in three dimensions, and sums of its octaves. Values are -1..1 and have no preferred sign.
// Equal points give equal bits on every machine: only + - * and integers are used. Method: K. Perlin, "Improving
// Noise", SIGGRAPH 2002, with a hash in place of the permutation table.
#pragma once

#include <cstdint>

#include "cloud/cloud.h"

namespace cloud {

// One feature a unit; 0 at integer points. |p| below 2^30.
float gradient_noise(Vec3 p, std::uint32_t seed);

// Each octave has twice the frequency of the one before and `gain` times its amplitude.
float fbm(Vec3 p, int octaves, float gain, std::uint32_t seed);

// Octaves of 1 - 2|noise|: round lumps between sharp folds.
float billow(Vec3 p, int octaves, float gain, std::uint32_t seed);

}  // namespace cloud
