// SPDX-License-Identifier: MIT
#include "demo/noise.h"

#include <cmath>

namespace demo {
namespace {

struct Direction {
    float x, y;
};
// Eight directions of equal length, sqrt(2), which makes the noise span about -1..1.
constexpr Direction kGradients[8] = {{1.4142135f, 0.0f},  {1.0f, 1.0f},   {0.0f, 1.4142135f},  {-1.0f, 1.0f},
                                     {-1.4142135f, 0.0f}, {-1.0f, -1.0f}, {0.0f, -1.4142135f}, {1.0f, -1.0f}};

// The largest integer not above `value`; std::floor is a call where SSE4.1 is not assumed.
std::int32_t cell_of(float value) {
    const auto truncated = static_cast<std::int32_t>(value);
    return value < static_cast<float>(truncated) ? truncated - 1 : truncated;
}

std::int32_t wrap(std::int32_t cell, std::int32_t period) {
    if (period == 0) return cell;
    const std::int32_t rest = cell % period;
    return rest < 0 ? rest + period : rest;
}

float slope(std::int32_t cell_x, std::int32_t cell_y, float dx, float dy, std::uint32_t seed, Period period) {
    const Direction& g = kGradients[hash_lattice(wrap(cell_x, period.x), wrap(cell_y, period.y), seed) >> 29];
    return g.x * dx + g.y * dy;
}

float fade(float t) {
    return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
}

}  // namespace

std::uint32_t hash_lattice(std::int32_t x, std::int32_t y, std::uint32_t seed) {
    std::uint32_t h =
        static_cast<std::uint32_t>(x) * 0x9e3779b1u ^ static_cast<std::uint32_t>(y) * 0x85ebca77u ^ seed * 0xc2b2ae3du;
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    h ^= h >> 12;
    h *= 0x297a2d39u;
    h ^= h >> 15;
    return h;
}

float hash_unit(std::int32_t x, std::int32_t y, std::uint32_t seed) {
    return static_cast<float>(hash_lattice(x, y, seed) >> 8) * (1.0f / 16777216.0f);
}

float noise(float x, float y, std::uint32_t seed, Period period) {
    const std::int32_t cell_x = cell_of(x), cell_y = cell_of(y);
    const float dx = x - static_cast<float>(cell_x), dy = y - static_cast<float>(cell_y);
    const float u = fade(dx), v = fade(dy);
    const float top =
        mix(slope(cell_x, cell_y, dx, dy, seed, period), slope(cell_x + 1, cell_y, dx - 1.0f, dy, seed, period), u);
    const float bottom = mix(slope(cell_x, cell_y + 1, dx, dy - 1.0f, seed, period),
                             slope(cell_x + 1, cell_y + 1, dx - 1.0f, dy - 1.0f, seed, period), u);
    return mix(top, bottom, v);
}

float fractal_noise(float x, float y, int octaves, std::uint32_t seed, Period period) {
    float sum = 0.0f, amplitude = 0.5f;
    for (int octave = 0; octave < octaves; ++octave) {
        sum += amplitude * noise(x, y, seed + static_cast<std::uint32_t>(octave), period);
        x *= 2.0f;
        y *= 2.0f;
        period = {period.x * 2, period.y * 2};
        amplitude *= 0.5f;
    }
    return sum * 1.3f;
}

float ridged_noise(float x, float y, int octaves, std::uint32_t seed, Period period) {
    float sum = 0.0f, amplitude = 1.0f, total = 0.0f;
    for (int octave = 0; octave < octaves; ++octave) {
        const float ridge = 1.0f - std::abs(noise(x, y, seed + static_cast<std::uint32_t>(octave), period));
        sum += amplitude * ridge * ridge;
        total += amplitude;
        x *= 2.0f;
        y *= 2.0f;
        period = {period.x * 2, period.y * 2};
        amplitude *= 0.5f;
    }
    return sum / total;
}

}  // namespace demo
