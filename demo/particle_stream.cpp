// SPDX-License-Identifier: MIT
#include "demo/particle_stream.h"

#include <algorithm>
#include <cmath>

#include "demo/noise.h"
#include "demo/trigonometry.h"

namespace demo {
namespace {

constexpr double kGoldenAngle = 2.39996322972865332;
constexpr float kLeastRadius  = 0.01f;
constexpr float kBumpSeat     = 0.78f;  // of a bump's centre, in radii

// What stays the same about a particle, -1..1.
float habit(const ParticleStream& stream, int particle, int birth, int which) {
    return 2.0f * hash_unit(particle * 8 + which, birth, stream.seed) - 1.0f;
}

// In which of its lives a particle is, and how far; before its first and after its last it is not there.
struct Life {
    int birth    = 0;
    double age_s = 0.0;
    bool there   = false;
};

Life life_at(const ParticleStream& stream, int particle, double seconds) {
    using Birth        = ParticleStream::Birth;
    const double share = static_cast<double>(particle) / stream.count;
    double since       = seconds;
    if (stream.birth == Birth::Steady) since += share * stream.life_s;
    if (stream.birth == Birth::Fill) since -= share * stream.life_s;
    if (since < 0.0) return {};
    const double births = std::floor(since / stream.life_s);
    if (stream.birth == Birth::Burst && births > 0.0) return {};
    return {static_cast<int>(std::fmod(births, 1048576.0)), since - births * stream.life_s, true};
}

// Directions spread evenly over a sphere, turned by `turns` about the vertical and rolled by `roll_rad` about x.
Vec3 bump_direction(int bump, int count, double turn_rad, double roll_rad) {
    const double height = 1.0 - 2.0 * (bump + 0.5) / count, across = std::sqrt(1.0 - height * height);
    const double angle = bump * kGoldenAngle + turn_rad;
    const double x = across * cosine(angle), z = across * sine(angle);
    const double c = cosine(roll_rad), s = sine(roll_rad);
    return Vec3(static_cast<float>(x), static_cast<float>(c * height - s * z), static_cast<float>(s * height + c * z));
}

}  // namespace

std::vector<cloud::Particle> stream_particles(const ParticleStream& stream, double seconds) {
    std::vector<cloud::Particle> particles;
    for (int i = 0; i < stream.count; ++i) {
        const Life life                   = life_at(stream, i, seconds);
        const double age                  = life.age_s / stream.life_s;
        const ParticleStream::Stage stage = stream.stages.linear(age);
        const auto varied                 = [&](float value, int which) {
            return value * (1.0f + stream.irregularity * habit(stream, i, life.birth, which));
        };
        const double turn = i * kGoldenAngle + radians(std::fmod(stream.swirl_deg * life.age_s, 360.0));
        const float height =
            stream.in_ball ? 1.0f - 2.0f * (static_cast<float>(i) + 0.5f) / static_cast<float>(stream.count) : 0.0f;
        const float level = std::sqrt(1.0f - height * height), spread = varied(stage.spread, 0);
        cloud::Particle particle;
        particle.center =
            Vec3(spread * level * static_cast<float>(cosine(turn)), spread * height + varied(stage.height, 1),
                 spread * level * static_cast<float>(sine(turn)));
        particle.radius      = life.there ? std::max(varied(stage.radius, 2), kLeastRadius) : kLeastRadius;
        particle.alpha       = life.there ? std::clamp(stage.alpha, 0.0f, 1.0f) : 0.0f;
        // Some cool down sooner than others.
        const double hue_age = age * (1.0 + 0.35 * stream.irregularity * habit(stream, i, life.birth, 3));
        if (!stream.color.empty()) particle.color = stream.color.linear(hue_age);
        if (!stream.glow.empty()) particle.glow = stream.glow.linear(hue_age);
        particles.push_back(particle);

        // It rolls outwards as it rises, as smoke does.
        const double roll = 1.3 * age * (stream.birth == ParticleStream::Birth::Burst ? 1.0 : 2.0);
        for (int bump = 0; bump < stream.bumps; ++bump) {
            const Vec3 direction  = bump_direction(bump, stream.bumps, i * 1.7 + turn, roll);
            const float size      = stream.bump_radius * (0.75f + 0.5f * hash_unit(bump, i, stream.seed + 1));
            cloud::Particle child = particle;
            child.radius          = std::max(particle.radius * size, kLeastRadius);
            child.center += direction * (particle.radius * kBumpSeat);
            const double bump_age =
                hue_age * (1.0 + 0.5 * stream.irregularity * (2.0 * hash_unit(bump, i, stream.seed + 2) - 1.0));
            if (!stream.glow.empty()) child.glow = stream.glow.linear(bump_age);
            child.generation = 2;
            particles.push_back(child);
        }
    }
    return particles;
}

}  // namespace demo
