// SPDX-License-Identifier: MIT
#include "demo/bake_light.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "demo/noise.h"

namespace demo {
namespace {

// Tangent of the half angle of the sun's disc; far wider than the real one, so that a shadow's edge spans some
// vertices.
constexpr float kSunSpread = 0.022f;

// Is the ray's horizontal passage through the ellipse below the column's top? The share is how deep it passes, softened
// over half a metre, since a column's shadow is narrower than the grid resolves.
float sun_past_column(const ShadowColumn& column, const Vec3& point, const Vec3& to_sun) {
    const float px = (point.x - column.center.x) / column.radius_x, dx = to_sun.x / column.radius_x;
    const float pz = (point.z - column.center.z) / column.radius_z, dz = to_sun.z / column.radius_z;
    const float a = dx * dx + dz * dz;
    if (a < 1e-12f) return 1.0f;
    const float nearest = -(px * dx + pz * dz) / a;
    const float miss_x = px + nearest * dx, miss_z = pz + nearest * dz;
    const float miss = miss_x * miss_x + miss_z * miss_z;
    if (miss >= 1.0f) return 1.0f;
    const float half = std::sqrt((1.0f - miss) / a);
    if (nearest + half <= 0.0f) return 1.0f;
    const float y         = point.y + std::max(nearest, 0.0f) * to_sun.y;
    const float above_top = smooth_step(-1.0f, 1.0f, y - column.top_y);
    return std::max(above_top, smooth_step(0.75f, 1.0f, miss));
}

float sun_past_terrain(const HeightField& terrain, const Vec3& point, const Vec3& to_sun) {
    float share = 1.0f;
    // Steps grow with the distance as the sun's cone does.
    for (float t = 1.5f; t < 1500.0f; t = t * 1.16f + 0.8f) {
        const Vec3 p = point + t * to_sun;
        if (p.y > terrain.max_height()) break;
        const float clearance = p.y - terrain.height_at(p.x, p.z);
        share                 = std::min(share, 0.5f + 0.5f * clearance / (kSunSpread * t + 0.25f));
        if (share <= 0.0f) return 0.0f;
    }
    return smooth_step(0.0f, 1.0f, share);
}

}  // namespace

ShadowCloud::ShadowCloud(const cloud::Cloud& casts) : cloud(&casts), center(0.0f), radius(0.0f) {
    for (const cloud::Particle& particle : casts.particles) center += particle.center;
    center /= static_cast<float>(std::max<std::size_t>(casts.particles.size(), 1));
    for (const cloud::Particle& particle : casts.particles)
        radius = std::max(radius, glm::length(particle.center - center) + particle.radius);
    radius *= 1.001f;  // for rounding
}

float sun_past_solids(const Surroundings& around, const Vec3& point, const Vec3& to_sun) {
    if (to_sun.y <= 0.01f) return 0.0f;
    float share = around.terrain == nullptr ? 1.0f : sun_past_terrain(*around.terrain, point, to_sun);
    for (const ShadowColumn& column : around.columns) {
        if (share <= 0.0f) break;
        share = std::min(share, sun_past_column(column, point, to_sun));
    }
    return share;
}

// The optical depth is the sum of the chords, so that a puff's thin rim shades less than its middle; 1 / (1 + d +
// d^2/2) stands for exp(-d). A cloud scatters forwards, so its shadow never gets black.
float sun_past_clouds(const Surroundings& around, const Vec3& point, const Vec3& to_sun) {
    float depth = 0.0f;
    for (const ShadowCloud& shadow : around.clouds) {
        const Vec3 to_middle = shadow.center - point;
        const float nearest  = glm::dot(to_middle, to_sun);
        if (glm::dot(to_middle, to_middle) - nearest * nearest > shadow.radius * shadow.radius) continue;
        const cloud::Cloud& cloud = *shadow.cloud;
        for (const cloud::Particle& particle : cloud.particles) {
            const Vec3 to_center = particle.center - point;
            const float along    = glm::dot(to_center, to_sun);
            const float miss     = glm::dot(to_center, to_center) - along * along;
            const float inside   = particle.radius * particle.radius - miss;
            if (inside <= 0.0f || along <= 0.0f) continue;
            depth += 2.0f * std::sqrt(inside) * particle.alpha * cloud.absorption * cloud.opacity;
        }
    }
    constexpr float kDepthPerMeter = 0.035f, kLeast = 0.40f;
    const float d = depth * kDepthPerMeter;
    return kLeast + (1.0f - kLeast) / (1.0f + d + 0.5f * d * d);
}

// The mean over eight azimuths of 1 - sin(elevation of the horizon).
float open_sky(const HeightField& terrain, const Vec3& point) {
    constexpr float d              = 0.70710678f;
    constexpr float kAzimuth[8][2] = {{1, 0}, {d, d}, {0, 1}, {-d, d}, {-1, 0}, {-d, -d}, {0, -1}, {d, -d}};
    float open                     = 0.0f;
    for (const auto& azimuth : kAzimuth) {
        float slope = 0.0f;
        for (float t = 3.0f; t < 200.0f; t *= 2.2f) {
            const float rise = terrain.height_at(point.x + t * azimuth[0], point.z + t * azimuth[1]) - point.y;
            slope            = std::max(slope, rise / t);
        }
        open += 1.0f - slope / std::sqrt(1.0f + slope * slope);
    }
    return open / 8.0f;
}

Vec3 light_of_day(const cloud::Daylight& light, const Vec3& normal, float sun, float sky) {
    const float facing = std::max(glm::dot(normal, light.to_sun), 0.0f);
    const float up     = 0.5f + 0.5f * normal.y;
    return light.sun * (sun * facing) + light.sky * (sky * up) +
           light.bounce * ((0.35f + 0.65f * sky) * (1.0f - 0.6f * up));
}

}  // namespace demo
