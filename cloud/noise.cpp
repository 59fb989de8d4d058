// SPDX-License-Identifier: MIT
#include "cloud/noise.h"

#include <algorithm>
#include <cmath>

#include "cloud/wide_loops.h"

namespace cloud {
namespace {

// Hashes one more coordinate of a lattice point into h.
inline std::uint32_t mix(std::uint32_t h, std::int32_t coordinate) {
    h = (h ^ static_cast<std::uint32_t>(coordinate)) * 0x85ebca6bu;
    return h ^ (h >> 15);
}

// The dot product of (x, y, z) with one of the 12 directions to the edges of a cube; 4 of them serve twice. Two of a
// direction's coordinates are 1 or -1 and one is 0; choices in place of a table let several be computed at once.
inline float lattice_gradient(std::uint32_t hash, float x, float y, float z) {
    const std::uint32_t edge = (hash * 0xc2b2ae35u) >> 28;
    const float first        = edge < 8 ? x : y;
    const float xz           = (edge & 13u) == 12u ? x : z;
    const float second       = edge < 4 ? y : xz;
    return (edge & 1u ? -first : first) + (edge & 2u ? -second : second);
}

inline std::int32_t floor_to_int(float v) {
    const auto truncated = static_cast<std::int32_t>(v);
    return truncated - (v < static_cast<float>(truncated) ? 1 : 0);
}

// 6t^5 - 15t^4 + 10t^3: no jump in slope or curvature where cells meet.
inline float fade(float t) {
    return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
}

inline float lerp(float a, float b, float t) {
    return a + (b - a) * t;
}

// Shifted, so that the octaves' zeros at integer points do not coincide.
constexpr Vec3 kOctaveShift(0.371f, 0.613f, 0.137f);

inline std::uint32_t start_hash(std::uint32_t seed) {
    return seed * 0x9e3779b1u + 0x7f4a7c15u;
}

// In a cell, f along each axis, with the weights u, v, w of the far ends. seeded: start_hash of the seed.
inline float noise_in_cell(std::int32_t x, std::int32_t y, std::int32_t z, float fx, float fy, float fz, float u,
                           float v, float w, std::uint32_t seeded) {
    const auto along_z = [&](std::uint32_t hash_y, float from_x, float from_y) {
        return lerp(lattice_gradient(mix(hash_y, z), from_x, from_y, fz),
                    lattice_gradient(mix(hash_y, z + 1), from_x, from_y, fz - 1.0f), w);
    };
    const auto along_y = [&](std::uint32_t hash_x, float from_x) {
        return lerp(along_z(mix(hash_x, y), from_x, fy), along_z(mix(hash_x, y + 1), from_x, fy - 1.0f), v);
    };
    const float noise = lerp(along_y(mix(seeded, x), fx), along_y(mix(seeded, x + 1), fx - 1.0f), u);
    return least(greatest(noise, -1.0f), 1.0f);
}

inline float noise_at(float px, float py, float pz, std::uint32_t seeded) {
    const std::int32_t x = floor_to_int(px), y = floor_to_int(py), z = floor_to_int(pz);
    const float fx = px - static_cast<float>(x), fy = py - static_cast<float>(y), fz = pz - static_cast<float>(z);
    return noise_in_cell(x, y, z, fx, fy, fz, fade(fx), fade(fy), fade(fz), seeded);
}

inline float billow_of(float noise) {
    return 1.0f - 2.0f * std::abs(noise);
}

template <class Octave>
float sum_octaves(Vec3 p, int octaves, float gain, std::uint32_t seed, Octave&& octave) {
    float sum = 0.0f, amplitude = 1.0f, total = 0.0f;
    for (int i = 0; i < octaves; ++i) {
        sum += amplitude * octave(gradient_noise(p, seed + static_cast<std::uint32_t>(i)));
        total += amplitude;
        amplitude *= gain;
        p = p * 2.0f + kOctaveShift;
    }
    return total > 0.0f ? sum / total : 0.0f;
}

}  // namespace

float gradient_noise(Vec3 p, std::uint32_t seed) {
    return noise_at(p.x, p.y, p.z, start_hash(seed));
}

float fbm(Vec3 p, int octaves, float gain, std::uint32_t seed) {
    return sum_octaves(p, octaves, gain, seed, [](float noise) { return noise; });
}

void fbm(std::span<const Vec3> points, int octaves, float gain, std::uint32_t seed, std::span<float> sums) {
    constexpr std::size_t kTogether = 64;
    with_wide_loops([&] {
        for (std::size_t first = 0; first < points.size(); first += kTogether) {
            const std::size_t count = std::min(points.size() - first, kTogether);
            float x[kTogether], y[kTogether], z[kTogether], sum[kTogether];
            for (std::size_t i = 0; i < kTogether; ++i) {
                const Vec3& p = points[first + std::min(i, count - 1)];
                x[i] = p.x, y[i] = p.y, z[i] = p.z, sum[i] = 0.0f;
            }
            float amplitude = 1.0f, total = 0.0f;
            for (int octave = 0; octave < octaves; ++octave) {
                const std::uint32_t seeded = start_hash(seed + static_cast<std::uint32_t>(octave));
                for (std::size_t i = 0; i < kTogether; ++i) {
                    sum[i] += amplitude * noise_at(x[i], y[i], z[i], seeded);
                    x[i] = x[i] * 2.0f + kOctaveShift.x;
                    y[i] = y[i] * 2.0f + kOctaveShift.y;
                    z[i] = z[i] * 2.0f + kOctaveShift.z;
                }
                total += amplitude;
                amplitude *= gain;
            }
            for (std::size_t i = 0; i < count; ++i) sums[first + i] = total > 0.0f ? sum[i] / total : 0.0f;
        }
    });
}

float billow(Vec3 p, int octaves, float gain, std::uint32_t seed) {
    return sum_octaves(p, octaves, gain, seed, billow_of);
}

NoiseLattice::NoiseLattice(const std::array<std::vector<float>, 3>& coordinates, int octaves)
    : octaves_(static_cast<std::size_t>(octaves)) {
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<float> points = coordinates[static_cast<std::size_t>(axis)];
        for (Octave& octave : octaves_) {
            Axis& seen = octave[static_cast<std::size_t>(axis)];
            for (std::size_t i = 0; i < points.size(); ++i) {
                const std::int32_t cell = floor_to_int(points[i]);
                seen.cells.push_back(cell);
                seen.places.push_back(points[i] - static_cast<float>(cell));
                seen.weights.push_back(fade(seen.places.back()));
            }
            for (float& point : points) point = point * 2.0f + kOctaveShift[axis];
        }
    }
}

// The other two coordinates are the same all along the row.
template <std::size_t kAlong, class Add>
void NoiseLattice::for_each_noise(const Octave& axes, Point point, std::uint32_t seed, Add&& add) {
    const std::uint32_t start = start_hash(seed);
    std::int32_t cell[3];
    float place[3], weight[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t at = axis == kAlong ? 0 : point[axis];
        cell[axis]           = axes[axis].cells[at];
        place[axis] = axes[axis].places[at], weight[axis] = axes[axis].weights[at];
    }
    const std::size_t size          = axes[kAlong].cells.size();
    const std::int32_t* const cells = axes[kAlong].cells.data();
    const float *const places = axes[kAlong].places.data(), *const weights = axes[kAlong].weights.data();
    for (std::size_t i = 0; i < size; ++i) {
        const auto cell_of   = [&](std::size_t axis) { return axis == kAlong ? cells[i] : cell[axis]; };
        const auto place_of  = [&](std::size_t axis) { return axis == kAlong ? places[i] : place[axis]; };
        const auto weight_of = [&](std::size_t axis) { return axis == kAlong ? weights[i] : weight[axis]; };
        add(i, noise_in_cell(cell_of(0), cell_of(1), cell_of(2), place_of(0), place_of(1), place_of(2), weight_of(0),
                             weight_of(1), weight_of(2), start));
    }
}

template <class OfNoise>
std::vector<float> NoiseLattice::row(std::size_t along, Point point, float gain, std::uint32_t seed,
                                     OfNoise&& of_noise) const {
    std::vector<float> sums(octaves_.empty() ? 0 : octaves_[0][along].places.size(), 0.0f);
    float* const values = sums.data();
    float amplitude = 1.0f, total = 0.0f;
    with_wide_loops([&] {
        for (const Octave& axes : octaves_) {
            const auto add = [=](std::size_t i, float noise) { values[i] += amplitude * of_noise(noise); };
            switch (along) {
                case 0:
                    for_each_noise<0>(axes, point, seed, add);
                    break;
                case 1:
                    for_each_noise<1>(axes, point, seed, add);
                    break;
                default:
                    for_each_noise<2>(axes, point, seed, add);
            }
            ++seed;
            total += amplitude;
            amplitude *= gain;
        }
    });
    for (float& sum : sums) sum = sum / total;
    return sums;
}

std::vector<float> NoiseLattice::fbm_row(std::size_t along, Point point, float gain, std::uint32_t seed) const {
    return row(along, point, gain, seed, [](float noise) { return noise; });
}

std::vector<float> NoiseLattice::billow_row(std::size_t along, Point point, float gain, std::uint32_t seed) const {
    return row(along, point, gain, seed, [](float noise) { return billow_of(noise); });
}

}  // namespace cloud
