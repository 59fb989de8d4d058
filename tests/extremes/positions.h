// SPDX-License-Identifier: MIT
// Positions as extreme as floats are: what the vertex stage makes of them, and depth where near and far are far apart.
#pragma once

#include <cstdint>

#include "pipeline/frame/frame.h"
#include "tests/extremes/extremes.h"

namespace extremes {

// A frame of random triangles under a projection from 10^-3 to 10^4, or, of odd seeds, with all depth 0, so that no other plane
// keeps w from 0. Coordinates are 0, +-2^-149 to +-2^101, and those of another vertex nearly again; half of the edges pass
// the eye as near as floats allow.
pipeline::Frame wild_frame(std::uint32_t seed, std::uint32_t triangles);

// What to_window_triangles makes of wild frames: vertices, and those that are not as window vertices have to be.
struct WildVertices {
    std::uint64_t triangles = 0, vertices = 0, invalid = 0;
    double greatest_rhw = 0.0;
};
WildVertices wild_vertices(std::uint32_t frames);

// Of triangles in view but for one corner, each in turn, which is before the eye at a w of 2^-35, or beyond what floats hold.
WildVertices corners_next_to_eye();
WildVertices corners_at_infinity();
inline constexpr std::uint32_t kWildFrames = 100, kEyeTriangles = 100000;

// Depth with near : far = 1 : 10^7, of vertices from near to far, 1/1000 apart, against double: greatest error in 2^-24, and
// how many are not in order.
struct FarDepth {
    std::uint64_t vertices = 0, out_of_order = 0;
    double error = 0.0;
    double merges_at[3] =
        {};  // times near: from where on a distance and 1.01 times it may have one depth, of 16, 24, 32 bits
};
FarDepth far_depth();
// z is (m z + n) / w with w = -z: m, its product and the sum are rounded to 2^-24 of w each, n to 2^-24 of near, the quotient to
// 2^-25.
inline constexpr double kFarDepthBound = 4.5;

// Of triangles with an edge that passes the eye, or misses it by what rounding is, in numbers up to 2^50, cut at a guard band:
// corners with w below what can be divided by, or no number.
struct EyeCorners {
    std::uint64_t corners = 0, bad = 0;
};
EyeCorners eye_corners(std::uint32_t triangles);

// Each float of a frame with all there is in it, set to not-a-number and to either infinity: values set, and those that
// validate lets pass.
struct NotFinite {
    std::uint64_t values = 0, passed = 0;
};
NotFinite not_finite();

}  // namespace extremes
