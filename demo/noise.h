// SPDX-License-Identifier: MIT
// Gradient noise in the plane, from an integer hash and + - * alone: the same bits on every machine. Values are about
// -1..1 with mean 0; one lattice cell is one unit. A period (in cells, 0: none) makes the noise repeat, for textures
// that tile.
#pragma once

#include <cstdint>

namespace demo {

std::uint32_t hash_lattice(std::int32_t x, std::int32_t y, std::uint32_t seed);

// 0..1, by the same hash.
float hash_unit(std::int32_t x, std::int32_t y, std::uint32_t seed);

struct Period {
    std::int32_t x = 0, y = 0;
};

float noise(float x, float y, std::uint32_t seed, Period period = {});

// Sum of `octaves` noises, each at twice the frequency and half the amplitude of the one before, about -1..1.
float fractal_noise(float x, float y, int octaves, std::uint32_t seed, Period period = {});

// 1 on the creases where noise is zero, falling to 0: cracks, ridges, gullies. Octaves as above; 0..1.
float ridged_noise(float x, float y, int octaves, std::uint32_t seed, Period period = {});

// 0 below `low`, 1 above `high`, a cubic between.
constexpr float smooth_step(float low, float high, float value) {
    const float t = value <= low ? 0.0f : value >= high ? 1.0f : (value - low) / (high - low);
    return t * t * (3.0f - 2.0f * t);
}

constexpr float mix(float a, float b, float t) {
    return a + (b - a) * t;
}

}  // namespace demo
