// SPDX-License-Identifier: MIT
// From a triangle to what the kernels step through: edge functions and planes in 64-bit integers, per pixel. The rules
// are those of raster/primitives.h and raster/sampling_rules.h.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "raster/primitives.h"
#include "raster/tile.h"

namespace raster {

// value at the sample point of pixel (x, y): origin + dx * x + dy * y, modulo 2^64. Not set to anything at first, since arrays
// of planes are made for every triangle.
struct Plane {
    std::uint64_t origin, dx, dy;
    bool operator==(const Plane&) const = default;
    std::uint64_t at(int x, int y) const {
        return origin + dx * static_cast<std::uint64_t>(x) + dy * static_cast<std::uint64_t>(y);
    }
};

// Inside where a * x + b * y + c >= 0 for pixel (x, y). The edge function only takes every 16th integer from one pixel
// to the next, so its low 4 bits never change and are dropped: |a|, |b| <= 2^19.
struct Edge {
    std::int32_t a = 0, b = 0;
    std::int64_t c = 0;
    std::int64_t at(std::int64_t x, std::int64_t y) const { return a * x + b * y + c; }
};

struct TexturePlanes {
    Plane s, t, q;
    float scale_u = 0.0f, scale_v = 0.0f;                  // ku, kv of the rules
    float sx = 0, tx = 0, qx = 0, sy = 0, ty = 0, qy = 0;  // steps, for the level of detail
};

// Between the set-up of many and their filling memory has the most to do, so what is needed of all comes first and what few
// need lies elsewhere.
struct SetUpTriangle {
    Rect bounds;  // pixels that may be covered, within the scissor
    std::int32_t depth_min = 0, depth_max = 0;
    Plane depth;
    std::array<Edge, 3> edges;
    std::uint32_t flat_diffuse = 0, flat_specular = 0;     // where the colour does not vary
    bool diffuse_varies = false, specular_varies = false;  // in what is needed of them
    std::array<Plane, 4> specular, diffuse;                // blue, green, red, alpha
    TexturePlanes* textures = nullptr;                     // kMaxTextures; whoever makes the triangle gives the room
};

// What of a triangle a draw needs; the rest is left alone. fog: of specular only its alpha, unless `specular` is set
// too. Texture sizes are those of level 0.
struct SetupNeeds {
    bool depth = false, diffuse = false, specular = false, fog = false;
    bool floor_colors = false;
    int depth_cut     = 0;  // low bits that a corner's depth loses
    std::array<bool, kMaxTextures> texture{}, lod{};
    std::array<int, kMaxTextures> width{}, height{};
};

// A draw's triangles, or some of them; flat as in raster/fill_pass.h.
struct TriangleList {
    std::span<const Vertex> vertices;
    std::span<const TriangleCorners> corners;
    bool flat = false;
};

// Sets up, in order, from out[0] on, those that may cover something within `scissor`, and returns how many they are. Needs
// SetUpTriangle::textures if it needs any texture.
std::size_t set_up_triangles(const TriangleList& triangles, const SetupNeeds& needs, const PixelGrid& grid,
                             const Rect& scissor, SetUpTriangle* out);

// A rectangle's texture coordinates: planes in one variable, 2^32 to the texel.
struct AxisPlane {
    std::uint64_t origin = 0, step = 0;
    std::uint64_t at(int i) const { return origin + step * static_cast<std::uint64_t>(i); }
};

struct SetUpRectangle {
    Rect bounds;
    std::uint32_t depth = 0;  // 30 bits
    std::uint32_t color = 0;
    struct Texture {
        AxisPlane u, v;
        float ux = 0, vy = 0;  // texels per pixel
    };
    std::array<Texture, kMaxTextures> textures;
};

bool set_up_rectangle(const Rectangle& rectangle, const SetupNeeds& needs, const PixelGrid& grid, const Rect& scissor,
                      SetUpRectangle& out);

// floor((p + 2^(S-1)) / 2^S) of a plane, modulo 2^32: the r of the rules.
template <int S>
constexpr std::int32_t read_plane(std::uint64_t p) {
    return static_cast<std::int32_t>(
        static_cast<std::uint32_t>(static_cast<std::uint64_t>(static_cast<std::int64_t>(p + (1ull << (S - 1))) >> S)));
}

inline constexpr int kColorDrop = 16, kDepthDrop = 12, kTextureDrop = 12, kRectangleDrop = 16;  // S of the rules
inline constexpr int kColorFraction = 23, kFloorColorFraction = 31, kDepthFraction = 12,
                     kTextureFraction = 12;  // F of the rules

}  // namespace raster
