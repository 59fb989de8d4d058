// SPDX-License-Identifier: MIT
// The oracle's reading of sampling_rules.h: texture coordinates of a primitive, level of detail, and what a sampler
// reads there. Names are those of the rules, in lower case; U and V are `u` and `v` of a TexturePoint.
#pragma once

#include <array>
#include <cstdint>

#include "raster/reference_plane.h"
#include "raster/sampling_rules.h"

namespace raster::reference {

// u, v: 1/256 texel of level 0; lod: 1/256 level.
struct TexturePoint {
    std::int32_t u = 0, v = 0, lod = 0;
};

// Texture coordinates of a triangle whose vertices are in the order of its corners. The sampler has levels.
class TriangleTexture {
  public:
    TriangleTexture(const Corners& corners, const Triangle& triangle, int texture, const Sampler& sampler);
    TexturePoint at(int x, int y) const;

  private:
    std::int32_t lod_at(float u, float v, float r) const;

    Plane s_, t_, q_;
    float ku_ = 0.0f, kv_ = 0.0f;
    bool mips_  = false;
    int levels_ = 0;
};

// Texture coordinates of a rectangle. The sampler has levels, and the rectangle covers a pixel.
class RectangleTexture {
  public:
    RectangleTexture(const PixelGrid& grid, const Rectangle& rectangle, int texture, const Sampler& sampler);
    TexturePoint at(int x, int y) const;

  private:
    struct Axis {
        std::int64_t origin = 0, step = 0;
        std::uint64_t plane(int pixel) const;
    };
    // c0, c1: the coordinate at the snapped edges x0 and x1, which spans `size` texels from 0 to 1.
    static Axis axis(int center, float c0, float c1, int size, std::int64_t x0, std::int64_t x1);

    Axis u_, v_;
    std::int32_t lod_ = 0;  // the same everywhere
};

// The colour that the sampler reads, and how many texels it reads for it.
std::uint32_t sample(const Sampler& sampler, const TexturePoint& point);
int texels_read(const Sampler& sampler);

}  // namespace raster::reference
