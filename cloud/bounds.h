// SPDX-License-Identifier: MIT
// Where on the screen a cloud can be: rectangles in whole pixels, for scissors.
#pragma once

#include <optional>

#include "cloud/cloud.h"

namespace cloud {

using pipeline::PixelRect;

// Pixels per unit of tangent, vertically.
float focal_px(const View& view);

// The greatest distance from the eye at which the near plane still cuts into the picture: that of its corners.
float near_reach_m(const View& view);

// The radius of a sphere around the particle's ellipsoid.
float greatest_radius(const Particle& particle);

// A sphere around all of a particle, lumps and squashed base included.
struct Sphere {
    Vec3 center  = Vec3(0.0f);
    float radius = 0.0f;
};
Sphere bounding_sphere(const Particle& particle, const Cloud& cloud);

// The pixels that the cloud's particles may touch, grown by margin_px on all sides and then outwards to multiples of
// `alignment`, within a target of width x height rounded up to multiples of it. The whole of that where a particle
// reaches through the near plane. Nothing where none is in view.
std::optional<PixelRect> screen_bounds(const Cloud& cloud, const View& view, int margin_px, int alignment);

// Grown by `pixels` on all sides, within width x height.
PixelRect grow(const PixelRect& rect, int pixels, int width, int height);

// The smallest around both.
PixelRect hull(const PixelRect& a, const PixelRect& b);

// The same part of a target of half the size, `level` times over.
PixelRect at_level(const PixelRect& rect, int level);

constexpr int round_up(int value, int multiple) {
    return (value + multiple - 1) / multiple * multiple;
}

}  // namespace cloud
