// SPDX-License-Identifier: MIT
#include "cloud/shadows.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "cloud/bounds.h"
#include "cloud/exp_of_minus.h"
#include "cloud/wide_loops.h"

namespace cloud {
namespace {

// What a ray misses by less than this share of the distance may be met, by rounding: along^2 - distance^2 + radius^2 is
// right to some 5e-7 of the distance's square, whose root is 7e-4 of the distance; the search itself rounds as much.
constexpr float kMargin = 4e-3f;

// As greatest_radius: at most this much longer does a vector get.
float greatest_stretch(const Mat3& matrix) {
    return greatest_radius({.radius = 1.0f, .shape = matrix});
}

}  // namespace

void Obstacles::resize(std::size_t size) {
    particle.resize(size);
    for (auto* values : {&x, &y, &z, &radius, &margin}) values->resize(size);
}

Shadows::Shadows(const Cloud& cloud) : base_y_(cloud.base_y) {
    float core_radius = 0.0f;
    all_.resize(cloud.particles.size());
    for (std::size_t i = 0; i < cloud.particles.size(); ++i) {
        const Particle& particle = cloud.particles[i];
        const float radius       = particle.alpha > 0.0f ? particle.radius : 0.0f;  // else it is not there
        core_radius              = std::max(core_radius, radius);
        spheres_.emplace_back(particle.center, radius * radius);
        to_ball_.push_back(glm::inverse(particle.shape));
        is_ball_.push_back(particle.shape == Mat3(1.0f));
        all_.particle[i] = static_cast<std::uint32_t>(i);
        all_.x[i] = particle.center.x, all_.y[i] = particle.center.y, all_.z[i] = particle.center.z;
        all_.radius[i] = particle.alpha > 0.0f ? greatest_radius(particle) : 0.0f;
        // An ellipsoid's rounding is that of its ball, as much larger as its shape is uneven.
        all_.margin[i] =
            is_ball_.back()
                ? kMargin
                : kMargin * std::max(greatest_stretch(particle.shape) * greatest_stretch(to_ball_[i]), 1.0f);
    }
    // Behind a core's diameter 0.15 + 0.85 exp(-2.14) = 1/4 is left.
    per_metre_ = core_radius > 0.0f ? 2.14f * std::max(cloud.absorption, 0.0f) / (2.0f * core_radius) : 0.0f;
}

std::vector<std::uint32_t> Shadows::touching(Vec3 center, float radius) const {
    std::vector<std::uint32_t> found;
    for (std::size_t i = 0; i < all_.size(); ++i) {
        const float distance = glm::length(Vec3(spheres_[i]) - center), reach = radius + all_.radius[i];
        if (distance < reach + all_.margin[i] * (distance + reach)) found.push_back(static_cast<std::uint32_t>(i));
    }
    return found;
}

void Shadows::depths(std::span<const Vec3> points, std::span<const std::uint32_t> particles,
                     std::span<float> deepest) const {
    std::fill(deepest.begin(), deepest.end(), 0.0f);
    with_wide_loops([&] {
        for (const std::uint32_t particle : particles) {
            const Vec3 center(spheres_[particle]);
            const float radius = std::sqrt(spheres_[particle].w);
            const Mat3 to_ball = to_ball_[particle];
            if (is_ball_[particle])
                for (std::size_t i = 0; i < points.size(); ++i)
                    deepest[i] = greatest(deepest[i], radius - glm::length(points[i] - center));
            else
                for (std::size_t i = 0; i < points.size(); ++i)
                    deepest[i] = greatest(deepest[i], radius - glm::length(to_ball * (points[i] - center)));
        }
    });
}

// A ray passes the centre of a sphere, d away from that of the bundle, at a distance of at least sqrt(d^2 - (d.u)^2) - R,
// u being its direction and R the bundle's radius.
std::size_t Shadows::find_in_reach(const Obstacles& among, std::size_t count, const Bundle& bundle,
                                   std::uint32_t* found) {
    const Vec3 c = bundle.center, u = bundle.direction;
    const float *x = among.x.data(), *y = among.y.data(), *z = among.z.data();
    const float *radius = among.radius.data(), *margin = among.margin.data();
    for (std::size_t j = 0; j < count; ++j) {
        const float dx = x[j] - c.x, dy = y[j] - c.y, dz = z[j] - c.z;
        const float size    = bundle.radius + radius[j];
        // No distance exceeds the sum of its coordinates.
        const float reach   = size + (margin[j] + bundle.margin) * (std::abs(dx) + std::abs(dy) + std::abs(dz) + size);
        const float along   = dx * u.x + dy * u.y + dz * u.z;
        const float squared = dx * dx + dy * dy + dz * dz;
        found[j]            = (squared - along * along > reach * reach ? 0u : 1u) & (along + reach < 0.0f ? 0u : 1u);
    }
    std::size_t size = 0;
    for (std::uint32_t j = 0; j < count; ++j) {
        const std::uint32_t is_found = found[j];
        found[size]                  = j;
        size += is_found;
    }
    return size;
}

// A ray that misses the sphere, or leaves it before it starts, adds 0.
inline void Shadows::add_chords(Rays& rays, std::size_t first, Vec3 direction, std::uint32_t particle) const {
    const Vec4 sphere   = spheres_[particle];
    float* const metres = rays.metres_.data() + first;
    const float *x = rays.x_.data() + first, *y = rays.y_.data() + first, *z = rays.z_.data() + first;
    const float* const base = rays.base_.data() + first;
    if (is_ball_[particle]) {
        for (std::size_t i = 0; i < Rays::kTogether; ++i) {
            const float to_x = sphere.x - x[i], to_y = sphere.y - y[i], to_z = sphere.z - z[i];
            const float along        = to_x * direction.x + to_y * direction.y + to_z * direction.z;
            const float half_chord_2 = along * along - (to_x * to_x + to_y * to_y + to_z * to_z) + sphere.w;
            const float half_chord   = std::sqrt(greatest(half_chord_2, 0.0f));
            const float leaves       = least(along + half_chord, base[i]);
            const float enters       = greatest(along - half_chord, 0.0f);
            metres[i] += greatest(leaves - enters, 0.0f);
        }
        return;
    }
    // The same where the ray is a ray through a ball, at another speed.
    const Mat3 ball   = to_ball_[particle];
    const Vec3 step   = ball * direction;
    const float speed = glm::length(step);
    const Vec3 unit   = step / speed;
    for (std::size_t i = 0; i < Rays::kTogether; ++i) {
        const float x_m = sphere.x - x[i], y_m = sphere.y - y[i], z_m = sphere.z - z[i];
        const float to_x         = ball[0][0] * x_m + ball[1][0] * y_m + ball[2][0] * z_m;
        const float to_y         = ball[0][1] * x_m + ball[1][1] * y_m + ball[2][1] * z_m;
        const float to_z         = ball[0][2] * x_m + ball[1][2] * y_m + ball[2][2] * z_m;
        const float along        = to_x * unit.x + to_y * unit.y + to_z * unit.z;
        const float half_chord_2 = along * along - (to_x * to_x + to_y * to_y + to_z * to_z) + sphere.w;
        const float half_chord   = std::sqrt(greatest(half_chord_2, 0.0f));
        const float leaves       = least((along + half_chord) / speed, base[i]);
        const float enters       = greatest((along - half_chord) / speed, 0.0f);
        metres[i] += greatest(leaves - enters, 0.0f);
    }
}

void Shadows::trace(Rays& rays, Vec3 direction, float density, Vec3 center, float radius) const {
    if (rays.count_ == 0) return;
    const double excess   = std::max(glm::length(glm::dvec3(direction)) - 1.0, 0.0);
    const auto margin     = static_cast<float>(std::sqrt(2.0 * excess * (1.0 + excess)) * 1.001);
    const std::size_t end = (rays.count_ + Rays::kTogether - 1) / Rays::kTogether * Rays::kTogether;
    for (std::size_t i = rays.count_; i < end; ++i)  // the last once more
        rays.x_[i] = rays.x_[i - 1], rays.y_[i] = rays.y_[i - 1], rays.z_[i] = rays.z_[i - 1];

    Obstacles& near = rays.near_;
    near.resize(all_.size());
    rays.found_.resize(all_.size());
    std::uint32_t* const found = rays.found_.data();
    with_wide_loops([&] {
        const std::size_t near_count = find_in_reach(all_, all_.size(), {center, radius, direction, margin}, found);
        for (std::size_t j = 0; j < near_count; ++j) {
            const std::uint32_t i = found[j];
            near.particle[j]      = i;
            near.x[j] = all_.x[i], near.y[j] = all_.y[i], near.z[j] = all_.z[i];
            near.radius[j] = all_.radius[i], near.margin[j] = all_.margin[i];
        }
        for (std::size_t first = 0; first < end; first += Rays::kTogether) {
            const float *x = rays.x_.data() + first, *y = rays.y_.data() + first, *z = rays.z_.data() + first;
            float *base = rays.base_.data() + first, *metres = rays.metres_.data() + first;
            Vec3 low(x[0], y[0], z[0]), high                 = low;
            for (std::size_t i = 0; i < Rays::kTogether; ++i) {
                low                 = glm::min(low, Vec3(x[i], y[i], z[i]));
                high                = glm::max(high, Vec3(x[i], y[i], z[i]));
                const float to_base = direction.y < 0.0f ? greatest(base_y_ - y[i], -1e30f) / direction.y : 1e30f;
                base[i]             = greatest(to_base, 0.0f);
                metres[i]           = 0.0f;
            }
            const Vec3 middle = (low + high) * 0.5f;
            float farthest    = 0.0f;  // squared
            for (std::size_t i = 0; i < Rays::kTogether; ++i) {
                const Vec3 from_middle = Vec3(x[i], y[i], z[i]) - middle;
                farthest               = greatest(farthest, glm::dot(from_middle, from_middle));
            }
            const std::size_t count =
                find_in_reach(near, near_count, {middle, std::sqrt(farthest) * 1.001f, direction, margin}, found);
            for (std::size_t j = 0; j < count; ++j) add_chords(rays, first, direction, near.particle[found[j]]);
        }
        for (std::size_t i = 0; i < end; ++i) rays.share_[i] = exp_of_minus(rays.metres_[i] * per_metre_ * density);
    });
}

}  // namespace cloud
