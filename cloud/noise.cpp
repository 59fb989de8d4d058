// SPDX-License-Identifier: MIT
#include "cloud/noise.h"

#include <algorithm>
#include <cmath>

namespace cloud {
namespace {

// Hashes one more coordinate of a lattice point into h.
std::uint32_t mix(std::uint32_t h, std::int32_t coordinate) {
    h = (h ^ static_cast<std::uint32_t>(coordinate)) * 0x85ebca6bu;
    return h ^ (h >> 15);
}

// The dot product of (x, y, z) with one of the 12 directions to the edges of a cube; 4 of them serve twice.
float lattice_gradient(std::uint32_t hash, float x, float y, float z) {
    static constexpr float kEdges[16][3] = {
        {1, 1, 0}, {-1, 1, 0}, {1, -1, 0}, {-1, -1, 0}, {1, 0, 1}, {-1, 0, 1}, {1, 0, -1}, {-1, 0, -1},
        {0, 1, 1}, {0, -1, 1}, {0, 1, -1}, {0, -1, -1}, {1, 1, 0}, {0, -1, 1}, {-1, 1, 0}, {0, -1, -1},
    };
    const auto& edge = kEdges[(hash * 0xc2b2ae35u) >> 28];
    return edge[0] * x + edge[1] * y + edge[2] * z;
}

std::int32_t floor_to_int(float v) {
    const auto truncated = static_cast<std::int32_t>(v);
    return truncated - (v < static_cast<float>(truncated) ? 1 : 0);
}

// 6t^5 - 15t^4 + 10t^3: no jump in slope or curvature where cells meet.
float fade(float t) {
    return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
}

float lerp(float a, float b, float t) {
    return a + (b - a) * t;
}

template <class Octave>
float sum_octaves(Vec3 p, int octaves, float gain, std::uint32_t seed, Octave&& octave) {
    float sum = 0.0f, amplitude = 1.0f, total = 0.0f;
    for (int i = 0; i < octaves; ++i) {
        sum += amplitude * octave(gradient_noise(p, seed + static_cast<std::uint32_t>(i)));
        total += amplitude;
        amplitude *= gain;
        // Shifted, so that the octaves' zeros at integer points do not coincide.
        p = p * 2.0f + Vec3(0.371f, 0.613f, 0.137f);
    }
    return total > 0.0f ? sum / total : 0.0f;
}

}  // namespace

float gradient_noise(Vec3 p, std::uint32_t seed) {
    const std::int32_t x = floor_to_int(p.x), y = floor_to_int(p.y), z = floor_to_int(p.z);
    const float fx = p.x - static_cast<float>(x), fy = p.y - static_cast<float>(y), fz = p.z - static_cast<float>(z);
    const float u = fade(fx), v = fade(fy), w = fade(fz);
    const std::uint32_t seeded = seed * 0x9e3779b1u + 0x7f4a7c15u;
    float at_x[2], at_y[2];
    for (int dx : {0, 1}) {
        const std::uint32_t hash_x = mix(seeded, x + dx);
        for (int dy : {0, 1}) {
            const std::uint32_t hash_y = mix(hash_x, y + dy);
            const float from_x = fx - static_cast<float>(dx), from_y = fy - static_cast<float>(dy);
            at_y[dy] = lerp(lattice_gradient(mix(hash_y, z), from_x, from_y, fz),
                            lattice_gradient(mix(hash_y, z + 1), from_x, from_y, fz - 1.0f), w);
        }
        at_x[dx] = lerp(at_y[0], at_y[1], v);
    }
    return std::clamp(lerp(at_x[0], at_x[1], u), -1.0f, 1.0f);
}

float fbm(Vec3 p, int octaves, float gain, std::uint32_t seed) {
    return sum_octaves(p, octaves, gain, seed, [](float noise) { return noise; });
}

float billow(Vec3 p, int octaves, float gain, std::uint32_t seed) {
    return sum_octaves(p, octaves, gain, seed, [](float noise) { return 1.0f - 2.0f * std::abs(noise); });
}

}  // namespace cloud
