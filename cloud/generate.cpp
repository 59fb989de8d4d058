// SPDX-License-Identifier: MIT
#include "cloud/generate.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "cloud/particle_mesh.h"

namespace cloud {
namespace {

// A direction in the horizontal plane, turned by products alone: the C library's sin and cos differ between machines.
struct Azimuth {
    double cosine = 1.0, sine = 0.0;

    Azimuth turned_by(const Azimuth& other) const {
        return {cosine * other.cosine - sine * other.sine, sine * other.cosine + cosine * other.sine};
    }
};

// 137.508 degrees, the golden angle.
constexpr Azimuth kGoldenAngle{-0.7373688780783197, 0.6754902942615238};

// Within a tenth of a turn or so: sin and cos by their series, error below 1e-6 up to a quarter of a turn.
Azimuth small_turn(double turns) {
    const double a = turns * 6.283185307179586, a2 = a * a;
    const double sine = a * (1.0 - a2 / 6.0 * (1.0 - a2 / 20.0 * (1.0 - a2 / 42.0 * (1.0 - a2 / 72.0))));
    const double cosine =
        1.0 - a2 / 2.0 * (1.0 - a2 / 12.0 * (1.0 - a2 / 30.0 * (1.0 - a2 / 56.0 * (1.0 - a2 / 90.0))));
    return {cosine, sine};
}

// -1..1, another value for each step of `state`.
double next_signed(std::uint32_t& state) {
    state           = state * 1664525u + 1013904223u;
    std::uint32_t h = state;
    h               = (h ^ (h >> 16)) * 0x7feb352du;
    h               = (h ^ (h >> 15)) * 0x846ca68bu;
    h ^= h >> 16;
    return static_cast<double>(h) / 2147483648.0 - 1.0;
}

Vec3 direction(const Azimuth& azimuth, float sine_of_elevation) {
    const float e     = std::clamp(sine_of_elevation, -1.0f, 1.0f);
    const float level = std::sqrt(1.0f - e * e);
    return Vec3(level * static_cast<float>(azimuth.cosine), e, level * static_cast<float>(azimuth.sine));
}

// Children on parents [first, first + parent_count) of `particles`, taken in turn. Each parent's children are a golden
// angle apart, and neighbouring parents begin a golden angle apart.
void grow_generation(std::vector<Particle>& particles, std::size_t first, std::size_t parent_count,
                     const Generation& rule, int generation, float jitter, std::uint32_t& random) {
    constexpr int kTries = 6;
    std::vector<Azimuth> next(parent_count);
    for (std::size_t i = 1; i < parent_count; ++i) next[i] = next[i - 1].turned_by(kGoldenAngle);
    for (int i = 0; i < rule.count && parent_count > 0; ++i) {
        const float t           = (static_cast<float>(i) + 0.5f) / static_cast<float>(rule.count);
        const std::size_t which = static_cast<std::size_t>(i) % parent_count;
        const Particle& parent  = particles[first + which];
        const Azimuth turn      = small_turn(jitter * next_signed(random));
        const float swell       = 1.0f + jitter * static_cast<float>(next_signed(random));

        Particle child   = parent;
        child.generation = generation;
        child.radius     = parent.radius * (rule.first_radius + (rule.last_radius - rule.first_radius) * t) * swell;
        for (int tried = 0; tried < kTries; ++tried) {
            const Azimuth azimuth = next[which].turned_by(turn);
            next[which]           = next[which].turned_by(kGoldenAngle);
            child.center =
                parent.center + direction(azimuth, rule.lowest + rule.rise * t) * (parent.radius * rule.seat);
            if (buried_share(child, particles) <= rule.greatest_burial) {
                particles.push_back(child);
                break;
            }
        }
    }
}

}  // namespace

float buried_share(const Particle& particle, std::span<const Particle> others) {
    constexpr int kLevel = 1;
    int buried           = 0;
    for (std::uint32_t i = 0; i < icosphere_vertices(kLevel); ++i) {
        const Vec3 p = particle.center + icosphere().directions[i] * particle.radius;
        buried += std::any_of(others.begin(), others.end(), [&](const Particle& other) {
            const Vec3 d = p - other.center;
            return glm::dot(d, d) < other.radius * other.radius;
        });
    }
    return static_cast<float>(buried) / static_cast<float>(icosphere_vertices(kLevel));
}

std::vector<Particle> grow(std::span<const Particle> cores, const Growth& growth) {
    std::vector<Particle> particles(cores.begin(), cores.end());
    for (Particle& core : particles) core.generation = 0;
    // A child's parent must not move while it grows.
    particles.reserve(cores.size() + static_cast<std::size_t>(std::max(growth.crown.count, 0)) +
                      static_cast<std::size_t>(std::max(growth.rim.count, 0)));
    std::uint32_t random = growth.seed;
    grow_generation(particles, 0, cores.size(), growth.crown, 1, growth.jitter, random);
    grow_generation(particles, cores.size(), particles.size() - cores.size(), growth.rim, 2, growth.jitter, random);
    return particles;
}

}  // namespace cloud
