// SPDX-License-Identifier: MIT
#include "demo/bake_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "demo/noise.h"

namespace demo {
namespace {

// Tangent of the half angle of the sun's disc; far wider than the real one, so that a shadow's edge spans some
// vertices.
constexpr float kSunSpread = 0.022f;
constexpr float kLowestSun = 0.01f;  // sine of its elevation

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

// Along a ray to the sun, in metres: steps grow with the distance as the sun's cone does.
const std::vector<float>& sun_steps() {
    static const std::vector<float> steps = [] {
        std::vector<float> t;
        for (float at = 1.5f; at < 1500.0f; at = at * 1.16f + 0.8f) t.push_back(at);
        return t;
    }();
    return steps;
}

// From a point at height y; height_at(step): of the terrain below the ray.
template <class HeightAt>
float sun_over_heights(float y, float to_sun_y, float highest, HeightAt&& height_at) {
    const std::vector<float>& steps = sun_steps();
    float share                     = 1.0f;
    for (std::size_t step = 0; step < steps.size(); ++step) {
        const float t = steps[step], ray_y = y + t * to_sun_y;
        if (ray_y > highest) break;
        const float clearance = ray_y - height_at(step), whole = kSunSpread * t + 0.25f;
        if (clearance >= whole) continue;  // the share stays
        share = std::min(share, 0.5f + 0.5f * clearance / whole);
        if (share <= 0.0f) return 0.0f;
    }
    return smooth_step(0.0f, 1.0f, share);
}

constexpr float kDiagonal       = 0.70710678f;
constexpr float kAzimuths[8][2] = {{1, 0},  {kDiagonal, kDiagonal},   {0, 1},  {-kDiagonal, kDiagonal},
                                   {-1, 0}, {-kDiagonal, -kDiagonal}, {0, -1}, {kDiagonal, -kDiagonal}};
constexpr std::size_t kSkySteps = 6;
constexpr auto kSkyDistances    = [] {
    std::array<float, kSkySteps> t{3.0f};
    for (std::size_t i = 1; i < t.size(); ++i) t[i] = t[i - 1] * 2.2f;
    return t;
}();

// The mean over eight azimuths of 1 - sin(elevation of the horizon). height_at(azimuth, step): of the terrain there.
template <class HeightAt>
float sky_over_heights(float y, HeightAt&& height_at) {
    float open = 0.0f;
    for (std::size_t azimuth = 0; azimuth < std::size(kAzimuths); ++azimuth) {
        float slope = 0.0f;
        for (std::size_t step = 0; step < kSkySteps; ++step)
            slope = std::max(slope, (height_at(azimuth, step) - y) / kSkyDistances[step]);
        open += 1.0f - slope / std::sqrt(1.0f + slope * slope);
    }
    return open / 8.0f;
}

bool meets_cloud(const ShadowCloud& shadow, const Vec3& point, const Vec3& to_sun) {
    const Vec3 to_middle = shadow.center - point;
    const float nearest  = glm::dot(to_middle, to_sun);
    return !(glm::dot(to_middle, to_middle) - nearest * nearest > shadow.radius * shadow.radius);
}

// The optical depth is the sum of the chords, so that a puff's thin rim shades less than its middle; 1 / (1 + d +
// d^2/2) stands for exp(-d). A cloud scatters forwards, so its shadow never gets black.
float left_by_clouds(float depth) {
    constexpr float kDepthPerMeter = 0.035f, kLeast = 0.40f;
    const float d = depth * kDepthPerMeter;
    return kLeast + (1.0f - kLeast) / (1.0f + d + 0.5f * d * d);
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
    if (to_sun.y <= kLowestSun) return 0.0f;
    const HeightField* terrain = around.terrain;
    if (terrain == nullptr) return sun_past_columns(around, point, to_sun, 1.0f);
    const auto height_at = [&](std::size_t step) {
        const float t = sun_steps()[step];
        return terrain->height_at(point.x + t * to_sun.x, point.z + t * to_sun.z);
    };
    const float share = sun_over_heights(point.y, to_sun.y, terrain->max_height(), height_at);
    return sun_past_columns(around, point, to_sun, share);
}

float sun_past_columns(const Surroundings& around, const Vec3& point, const Vec3& to_sun, float share) {
    for (const ShadowColumn& column : around.columns) {
        if (share <= 0.0f) break;
        share = std::min(share, sun_past_column(column, point, to_sun));
    }
    return share;
}

float sun_past_clouds(const Surroundings& around, const Vec3& point, const Vec3& to_sun) {
    float depth = 0.0f;
    for (const ShadowCloud& shadow : around.clouds) {
        if (!meets_cloud(shadow, point, to_sun)) continue;
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
    return left_by_clouds(depth);
}

void shade_by_clouds(const Surroundings& around, std::span<const Vec3> points, const Vec3& to_sun,
                     std::span<float> shares) {
    constexpr std::size_t kTogether = 8;
    // As for the rays within clouds (cloud/shadows.cpp), and more than a direction that is a little too long adds.
    constexpr float kMargin         = 0.04f;
    for (std::size_t first = 0; first < points.size(); first += kTogether) {
        const std::size_t count = std::min(points.size() - first, kTogether);
        const std::span here    = points.subspan(first, count);
        if (std::none_of(&shares[first], &shares[first] + count, [](float share) { return share > 0.0f; })) continue;
        float x[kTogether], y[kTogether], z[kTogether], depth[kTogether] = {};
        Vec3 low = here[0], high = here[0];
        for (std::size_t i = 0; i < kTogether; ++i) {
            const Vec3& point = here[std::min(i, count - 1)];
            x[i] = point.x, y[i] = point.y, z[i] = point.z;
            low = glm::min(low, point), high = glm::max(high, point);
        }
        const Vec3 middle   = 0.5f * (low + high);
        const float radius  = 0.501f * glm::length(high - low);
        const auto may_meet = [&](const Vec3& center, float its_radius) {
            const Vec3 offset = center - middle;
            const float size  = radius + its_radius;
            const float reach = size + kMargin * (std::abs(offset.x) + std::abs(offset.y) + std::abs(offset.z) + size);
            const float along = glm::dot(offset, to_sun);
            return !(glm::dot(offset, offset) - along * along > reach * reach) && !(along + reach < 0.0f);
        };
        for (const ShadowCloud& shadow : around.clouds) {
            if (!may_meet(shadow.center, shadow.radius)) continue;
            const cloud::Cloud& cloud = *shadow.cloud;
            bool meets[kTogether];
            for (std::size_t i = 0; i < kTogether; ++i) meets[i] = meets_cloud(shadow, Vec3(x[i], y[i], z[i]), to_sun);
            for (const cloud::Particle& particle : cloud.particles) {
                if (!may_meet(particle.center, particle.radius)) continue;
                const Vec3 c        = particle.center;
                const float radius2 = particle.radius * particle.radius;
                for (std::size_t i = 0; i < kTogether; ++i) {
                    const float to_x = c.x - x[i], to_y = c.y - y[i], to_z = c.z - z[i];
                    const float along  = to_x * to_sun.x + to_y * to_sun.y + to_z * to_sun.z;
                    const float miss   = to_x * to_x + to_y * to_y + to_z * to_z - along * along;
                    const float inside = radius2 - miss;
                    const float chord  = 2.0f * std::sqrt(inside > 0.0f ? inside : 0.0f);
                    const float adds   = chord * particle.alpha * cloud.absorption * cloud.opacity;
                    depth[i] += (meets[i] & (along > 0.0f)) ? adds : 0.0f;
                }
            }
        }
        for (std::size_t i = 0; i < count; ++i)
            if (shares[first + i] > 0.0f) shares[first + i] *= left_by_clouds(depth[i]);
    }
}

float open_sky(const HeightField& terrain, const Vec3& point) {
    return sky_over_heights(point.y, [&](std::size_t azimuth, std::size_t step) {
        const float t = kSkyDistances[step];
        return terrain.height_at(point.x + t * kAzimuths[azimuth][0], point.z + t * kAzimuths[azimuth][1]);
    });
}

GridLight::GridLight(const HeightField& terrain, const Vec3& to_sun) : terrain_(terrain), to_sun_(to_sun) {
    for (int column = 0; column < HeightField::kPoints; ++column)
        columns_.push_back(ways(terrain.x_at(column), to_sun.x, 0, [&](float x) { return terrain.along_x(x); }));
}

template <class Along>
GridLight::Ways GridLight::ways(float from, float to_sun, std::size_t axis, Along&& along) {
    Ways ways;
    for (const float t : sun_steps()) ways.to_sun.push_back(along(from + t * to_sun));
    for (const auto& azimuth : kAzimuths)
        for (const float t : kSkyDistances) ways.around.push_back(along(from + t * azimuth[axis]));
    return ways;
}

GridLight::Row::Row(const GridLight& light, int row)
    : light_(light),
      ways_(ways(light.terrain_.z_at(row), light.to_sun_.z, 1, [&](float z) { return light.terrain_.along_z(z); })) {}

float GridLight::Row::sun_past_terrain(int column, float y) const {
    if (light_.to_sun_.y <= kLowestSun) return 0.0f;
    const HeightField& terrain = light_.terrain_;
    const auto *x = light_.columns_[static_cast<std::size_t>(column)].to_sun.data(), *z = ways_.to_sun.data();
    return sun_over_heights(y, light_.to_sun_.y, terrain.max_height(),
                            [=, &terrain](std::size_t step) { return terrain.height_at(x[step], z[step]); });
}

float GridLight::Row::open_sky(int column, float y) const {
    const HeightField& terrain = light_.terrain_;
    const auto *x = light_.columns_[static_cast<std::size_t>(column)].around.data(), *z = ways_.around.data();
    return sky_over_heights(y, [=, &terrain](std::size_t azimuth, std::size_t step) {
        const std::size_t at = azimuth * kSkySteps + step;
        return terrain.height_at(x[at], z[at]);
    });
}

Vec3 light_of_day(const cloud::Daylight& light, const Vec3& normal, float sun, float sky) {
    const float facing = std::max(glm::dot(normal, light.to_sun), 0.0f);
    const float up     = 0.5f + 0.5f * normal.y;
    return light.sun * (sun * facing) + light.sky * (sky * up) +
           light.bounce * ((0.35f + 0.65f * sky) * (1.0f - 0.6f * up));
}

}  // namespace demo
