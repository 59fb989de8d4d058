// SPDX-License-Identifier: MIT
#include "cloud/bounds.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <utility>

namespace cloud {
namespace {

using glm::dvec3;
using glm::dvec4;

// x/w, or y/w, of a sphere.
struct Interval {
    double low = 0.0, high = 0.0;
};

// The planes x - k w = 0 through the eye that touch the sphere. With X, W the values at its centre and x, w the
// gradients of both, |X - k W| = r |x - k w|, a quadratic in k. The whole sphere lies at w > 0, so it has two roots.
Interval touching_planes(const dvec4& x_row, const dvec4& w_row, const dvec4& center, double radius) {
    const double X = glm::dot(x_row, center), W = glm::dot(w_row, center), r2 = radius * radius;
    const dvec3 x(x_row), w(w_row);
    const double a = W * W - r2 * glm::dot(w, w);
    const double b = X * W - r2 * glm::dot(x, w);
    const double c = X * X - r2 * glm::dot(x, x);
    const double d = std::sqrt(std::max(b * b - a * c, 0.0));
    return {(b - d) / a, (b + d) / a};
}

}  // namespace

float focal_px(const View& view) {
    return std::abs(view.projection[1][1]) * static_cast<float>(view.height) * 0.5f;
}

float near_reach_m(const View& view) {
    const float x = 1.0f / view.projection[0][0], y = 1.0f / view.projection[1][1];
    return view.near_m * std::sqrt(1.0f + x * x + y * y);
}

float greatest_radius(const Particle& particle) {
    // The greatest stretch of a matrix is at most sqrt(|M|_1 |M|_inf), and exactly that if it only scales along axes.
    float columns = 0.0f, rows = 0.0f;
    for (int i = 0; i < 3; ++i) {
        const Vec3 column = glm::abs(particle.shape[i]);
        const Vec3 row    = glm::abs(Vec3(particle.shape[0][i], particle.shape[1][i], particle.shape[2][i]));
        columns           = std::max(columns, column.x + column.y + column.z);
        rows              = std::max(rows, row.x + row.y + row.z);
    }
    return particle.radius * std::sqrt(columns * rows);
}

Sphere bounding_sphere(const Particle& particle, const Cloud& cloud) {
    Sphere sphere{particle.center, greatest_radius(particle) * (1.0f + std::max(cloud.lumpiness, 0.0f))};
    // A point (rho, y) of the sphere that is squashed stays inside if the centre is above the base. Otherwise, with
    // d = base - centre, h^2 = r^2 - rho^2: rho^2 + (0.15 (d + h))^2 <= r^2 + 0.045 d^2 around the point of the base
    // above it.
    const float below = cloud.base_y - particle.center.y;
    if (below > 0.0f) {
        sphere.center.y = cloud.base_y;
        sphere.radius   = std::sqrt(sphere.radius * sphere.radius + 0.045f * below * below);
    }
    return sphere;
}

std::optional<PixelRect> screen_bounds(const Cloud& cloud, const View& view, int margin_px, int alignment) {
    const int width = round_up(view.width, alignment), height = round_up(view.height, alignment);
    const glm::dmat4 rows = glm::transpose(glm::dmat4(view.projection) * glm::dmat4(view.view));
    Interval x{1e9, -1e9}, y = x;  // clip space over w
    for (const Particle& particle : cloud.particles) {
        const Sphere sphere = bounding_sphere(particle, cloud);
        const dvec4 center(dvec3(sphere.center), 1.0);
        const double w = glm::dot(rows[3], center), reach = sphere.radius * glm::length(dvec3(rows[3]));
        if (w + reach <= view.near_m) continue;
        if (!(w - reach > view.near_m)) return PixelRect{0, 0, width, height};
        for (auto [bounds, row] : {std::pair{&x, &rows[0]}, std::pair{&y, &rows[1]}}) {
            const Interval touched = touching_planes(*row, rows[3], center, sphere.radius);
            bounds->low            = std::min(bounds->low, touched.low);
            bounds->high           = std::max(bounds->high, touched.high);
        }
    }
    const auto to_pixels = [](double clip_over_w, int size) {
        return std::clamp((1.0 + clip_over_w) * 0.5 * size, -1e6, 1e6);
    };
    const auto down = [&](double px) { return static_cast<int>(std::floor((px - margin_px) / alignment)) * alignment; };
    const auto up   = [&](double px) { return static_cast<int>(std::ceil((px + margin_px) / alignment)) * alignment; };
    const PixelRect rect{
        std::max(down(to_pixels(x.low, view.width)), 0), std::max(down(to_pixels(-y.high, view.height)), 0),
        std::min(up(to_pixels(x.high, view.width)), width), std::min(up(to_pixels(-y.low, view.height)), height)};
    // The padding beyond the picture's right and lower edge shows nothing.
    if (rect.x0 >= std::min(rect.x1, view.width) || rect.y0 >= std::min(rect.y1, view.height)) return std::nullopt;
    return rect;
}

PixelRect grow(const PixelRect& rect, int pixels, int width, int height) {
    return {std::max(rect.x0 - pixels, 0), std::max(rect.y0 - pixels, 0), std::min(rect.x1 + pixels, width),
            std::min(rect.y1 + pixels, height)};
}

PixelRect hull(const PixelRect& a, const PixelRect& b) {
    return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

PixelRect at_level(const PixelRect& rect, int level) {
    return {rect.x0 >> level, rect.y0 >> level, rect.x1 >> level, rect.y1 >> level};
}

}  // namespace cloud
