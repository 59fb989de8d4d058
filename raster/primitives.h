// SPDX-License-Identifier: MIT
// What the rasterizer draws, and the rules that say which pixels a primitive covers and which integers it gives to each.
//
// The grid (PixelGrid) says where a pixel is sampled, C in 1/16 pixel from its left and top edge, and how corners snap.
// Snapping   X = x * 16 and Y = y * 16, rounded to the nearest integer, ties to even, or toward zero if `truncate`: 4
//            subpixel bits. |x|, |y| <= 16384.
// Triangle   With D = (X1-X0)(Y2-Y0) - (X2-X0)(Y1-Y0): nothing is drawn if D = 0; if D < 0, vertices 1 and 2 change
//            places (and D its sign), so that the corners go clockwise on the screen. Pixel (x, y) is covered if its
//            sample point P = (16x+C, 16y+C) has E > 0, or E = 0 on a top or left edge, for each edge a->b of 0->1, 1->2, 2->0:
//            E = (bX-aX)(PY-aY) - (bY-aY)(PX-aX). A top edge has bY = aY and bX > aX, a left edge has bY < aY.
//            Two triangles that share an edge therefore never both cover a pixel on it, and never leave one out.
// Rectangle  Covers pixel (x, y) if X0 <= 16x+C < X1 and Y0 <= 16y+C < Y1. Depth and colour are constant;
//            specular is 0xff000000.
//
// A value that varies over a triangle starts as an integer v at each vertex and is a plane over subpixels with F
// fraction bits, in 64-bit integers modulo 2^64 (the division truncates toward zero):
//   gx = ((v1-v0)(Y2-Y0) - (v2-v0)(Y1-Y0)) * 2^F / D        gy = ((v2-v0)(X1-X0) - (v1-v0)(X2-X0)) * 2^F / D
//   plane(x, y) = v0 * 2^F + gx * (16x+C - X0) + gy * (16y+C - Y0)        step = 16 * gx        step_y = 16 * gy
// and is read on the grid of blocks: with xb = x rounded down to a multiple of 16 and r(p, S) = floor((p + 2^(S-1)) / 2^S),
//   value(x, y) = r(plane(xb, y), S) + (x - xb) * r(step, S)
//   kind                  v at the vertex                              F    S    read as
//   colour, fog (bytes)   the byte                                     23   16   (value + 64) >> 7, a byte
//     with `floor_colors`                                              31   16   (value + 128) >> 15, kept within 0..255:
//                                                                                floor(colour + 1/256)
//   depth                 z * (2^30 - 1) in double, nearest, ties even  12   12   value, kept within the triangle's
//                                                                                least and greatest v
//     with `whole_depth`  that, without the bits that the format lacks
//   texture s, t, q       see raster/sampling_rules.h                  12   12   value
// (value is signed, >> arithmetic). At a covered pixel a value lies within its vertices' range but for the rounding of step
// (8 at most) and that of gx and gy (2^20 / 2^S at most), so lanes of 16 bits (colour to nearest) and 32 bits (the others)
// hold it, whatever the same sum is elsewhere modulo their size.
// The depth of a format with n bits is value >> (30 - n) for n <= 30, and value * 4 + (value >> 28) for n = 32.
#pragma once

#include <array>
#include <cfloat>
#include <cmath>
#include <cstdint>

#ifdef __FAST_MATH__
#error "these rules need IEEE arithmetic"
#endif
static_assert(FLT_EVAL_METHOD == 0, "these rules need float operations that round to float");

namespace raster {

inline constexpr int kSubpixelBits = 4;
inline constexpr int kSubpixels    = 1 << kSubpixelBits;

struct PixelGrid {
    int center                              = kSubpixels / 2;  // C of the rules, 0..15
    bool truncate                           = false;
    bool operator==(const PixelGrid&) const = default;
};

inline constexpr float kMaxCoordinate = 16384.0f;  // pixels, either side of 0
inline constexpr int kDepthBits       = 30;        // of interpolated depth
inline constexpr int kMaxTextures     = 2;

// Of a depth in 0..1, and of that in a format with `bits` bits.
inline std::uint32_t depth_value(float z) {
    return static_cast<std::uint32_t>(std::nearbyint(static_cast<double>(z) * ((1 << kDepthBits) - 1)));
}
constexpr std::uint32_t to_depth_format(std::uint32_t depth, int bits) {
    return bits == 32 ? depth << 2 | depth >> 28 : depth >> (kDepthBits - bits);
}

struct Subpixel {
    std::int64_t x = 0, y = 0;
};
inline Subpixel snap_to_subpixels(const PixelGrid& grid, float x, float y) {
    const auto snap = [&](float pixels) {
        const float subpixels = pixels * float{kSubpixels};  // exact
        return static_cast<std::int64_t>(grid.truncate ? std::trunc(subpixels) : std::nearbyint(subpixels));
    };
    return {snap(x), snap(y)};
}

// Homogeneous: the texture is read at (s/q, t/q), where 0..1 spans it. Times rhw, each is less than 2^40.
struct TexCoord {
    float s = 0.0f, t = 0.0f, q = 1.0f;
};

// x, y: pixels; z: 0..1; rhw: 1/w, greater than 0. Colours are 0xAARRGGBB; the alpha of `specular` is the fog factor,
// 255 for no fog.
struct Vertex {
    std::uint32_t diffuse  = 0xffffffff;
    std::uint32_t specular = 0xff000000;
    float x = 0.0f, y = 0.0f, z = 0.0f, rhw = 1.0f;
    std::array<TexCoord, kMaxTextures> uv;
};
using Triangle        = std::array<Vertex, 3>;
using TriangleCorners = std::array<std::uint32_t, 3>;  // places in a list of vertices

// x, y: pixels; z: 0..1; uv at the corners, each axis depending on its own coordinate only.
struct Rectangle {
    float x0 = 0.0f, y0 = 0.0f, x1 = 0.0f, y1 = 0.0f, z = 0.0f;
    std::uint32_t color = 0xffffffff;
    struct UvRect {
        float u0 = 0.0f, v0 = 0.0f, u1 = 1.0f, v1 = 1.0f;
    };
    std::array<UvRect, kMaxTextures> uv;
};

}  // namespace raster
