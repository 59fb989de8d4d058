// SPDX-License-Identifier: MIT
// A camera and an object's place as the chip wants them: a 3x4 matrix to eye space, and one of its two projections, which
// have six numbers p0..p5 and no more:
//   perspective    x' = p0 x + p1 z   y' = p2 y + p3 z   z' = p4 z + p5   w' = -z
//   orthographic   x' = p0 x + p1     y' = p2 y + p3     z' = p4 z + p5   w' = 1
// The chip keeps -w' <= z' <= 0 and writes depth 1 + z' / w' in the range of GX_SetViewport(..., 0, 1); Direct3D keeps
// 0 <= z <= w and writes z / w. So z' = z - w: with clip z = e Z + f and w = s |Z| in camera space, p4 = 1 -+ e / s and
// p5 = f / s. Where the frame's projection has another form than that, its rows X, Y and -W go to the matrix of positions,
// and the projection is only what is left for depth, Z = a W + b: p4 = 1 - a, p5 = b.
// Sources: libogc, gx.c, GX_LoadProjectionMtx and GX_SetViewportJitter; Dolphin, VideoCommon, for what the transform unit makes
// of the six numbers.
#pragma once

#include <array>
#include <optional>

#include "pipeline/frame/frame.h"

namespace pipeline {

using GxMatrix = std::array<std::array<float, 4>, 3>;  // rows

// near, far: distances from the eye at which depth is 0 and 1; what GX_SetFog asks for.
struct GxDepthRange {
    float near = 0.0f, far = 1.0f;
};

struct GxProjection {
    bool is_perspective = false;
    std::array<float, 6> p{};
    bool operator==(const GxProjection&) const = default;
};

// eye_z: eye space is camera space with z times this, 1 or -1; 0 if it is not camera space, so that neither the chip's
// lights nor its fog can be used. fog_range: nothing also where the chip's fog does not know the depths.
struct GxTransform {
    GxProjection projection;
    GxMatrix position{};
    float eye_z = 0.0f;
    std::optional<GxDepthRange> fog_range;
};

// Nothing if depth is no such function of w.
std::optional<GxTransform> gx_transform(const Camera& camera, const Mat4& world);

// For GX_LoadProjectionMtx.
std::array<std::array<float, 4>, 4> gx_rows(const GxProjection& projection);

// (s, t, q) of CAMERAPOSITION from a position in object space.
GxMatrix gx_texture_matrix(const Camera& camera, const Mat4& world, const Mat4& transform);

}  // namespace pipeline
