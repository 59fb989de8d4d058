// SPDX-License-Identifier: MIT
// The clip volume, and triangles cut to it, in clip space (pipeline/frame/math_types.h):
//   w >= kLeastW     so that what is left can be divided by
//   0 <= z <= w      near and far plane
//   |x| <= gx * w, |y| <= gy * w     the guard band, in half viewports; gx = gy = 1 is the viewport itself
// Distances to a plane, and new vertices on it, are computed in double and rounded once. A new vertex depends on
// nothing but the two ends of its edge, whichever way the edge runs: it is always cut from the inside end, and every
// triangle that needs a cut goes through all planes in one order. So two triangles with a common edge get the same bits
// on it.
#pragma once

#include <array>
#include <cstdint>

#include "pipeline/frame/frame.h"

namespace pipeline {

inline constexpr float kLeastW = 0x1p-32f;

struct ClipVolume {
    double gx = 1.0, gy = 1.0;
};

inline constexpr int kClipPlanes = 7;
using PlaneDistances             = std::array<double, kClipPlanes>;

// Negative outside. The position is finite.
inline PlaneDistances plane_distances(const ClipVolume& volume, const Vec4& position) {
    const double x = position.x, y = position.y, z = position.z, w = position.w;
    return {w - kLeastW, z, w - z, volume.gx * w + x, volume.gx * w - x, volume.gy * w + y, volume.gy * w - y};
}

// Bit k is set if the position lies outside plane k.
using Outcode = std::uint8_t;
inline Outcode outcode(const ClipVolume& volume, const Vec4& position) {
    const PlaneDistances distances = plane_distances(volume, position);
    unsigned code                  = 0;
    for (int plane = 0; plane < kClipPlanes; ++plane) code |= static_cast<unsigned>(distances[plane] < 0.0) << plane;
    return static_cast<Outcode>(code);
}

// All of it is linear over a triangle. Colours 0..1, fog 1 for none, uv homogeneous.
struct ClipVertex {
    Vec4 position  = Vec4(0.0f);
    Vec4 diffuse   = Vec4(1.0f);
    Vec3 specular  = Vec3(0.0f);
    float fog      = 1.0f;
    using TexCoord = Vec3;
    std::array<TexCoord, kTextureStages> uv{TexCoord(0.0f, 0.0f, 1.0f), TexCoord(0.0f, 0.0f, 1.0f)};
    bool operator==(const ClipVertex&) const = default;
};

// Convex, turning as the triangle does; no corners if nothing is left. One plane adds one corner to a convex polygon,
// but rounding may leave one slightly bent; a plane then adds at most one for every two corners: 3 4 6 9 13 19 28 42.
struct ClippedPolygon {
    static constexpr int kMaxCorners = 42;
    std::array<ClipVertex, kMaxCorners> corners;
    int count = 0;
};

ClippedPolygon clip_triangle(const ClipVolume& volume, const std::array<ClipVertex, 3>& triangle);

}  // namespace pipeline
