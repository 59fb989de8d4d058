// SPDX-License-Identifier: MIT
#include "raster/reference_texture.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "raster/tile.h"

namespace raster::reference {

namespace {

// The largest e <= limit with largest * 2^e < 2^29. ldexp is exact here.
int scale_exponent(float largest, int limit) {
    int e = limit;
    while (std::ldexp(double{largest}, e) >= 0x1p29) --e;
    return e;
}

std::array<std::int64_t, 3> scaled(const std::array<float, 3>& values, int exponent) {
    std::array<std::int64_t, 3> integers{};
    for (int i = 0; i < 3; ++i)
        integers[i] = static_cast<std::int64_t>(std::nearbyint(std::ldexp(double{values[i]}, exponent)));
    return integers;
}

float largest_magnitude(const std::array<float, 3>& values) {
    return std::max({std::abs(values[0]), std::abs(values[1]), std::abs(values[2])});
}

Plane texture_plane(const Corners& corners, const std::array<std::int64_t, 3>& v) {
    return make_plane(corners, v, 12, 12);
}

std::int32_t bits(float value) {
    return std::bit_cast<std::int32_t>(value);
}

std::int32_t lod_of(float ux, float vx, float uy, float vy, int levels) {
    const float across = ux * ux + vx * vx;
    const float down   = uy * uy + vy * vy;
    const float rho2   = std::max(across, down);
    const int lod      = (bits(rho2) - bits(1.0f)) >> 16;
    return std::clamp(lod, 0, 256 * (levels - 1));
}

int level_count(const Sampler& sampler) {
    return static_cast<int>(sampler.levels.size());
}

int address(Address mode, int i, int n) {
    switch (mode) {
        case Address::Wrap:
            return i & (n - 1);
        case Address::Clamp:
            return std::clamp(i, 0, n - 1);
        case Address::Mirror: {
            const int m = i & (2 * n - 1);
            return m < n ? m : 2 * n - 1 - m;
        }
    }
    return 0;
}

std::uint32_t texel_at(const Sampler& sampler, int level, int i, int j) {
    const TextureLevel& from = sampler.levels[static_cast<std::size_t>(level)];
    return from
        .texels[address(sampler.address_v, j, from.height) * from.stride + address(sampler.address_u, i, from.width)];
}

std::uint32_t channel(std::uint32_t color, int shift) {
    return (color >> shift) & 255;
}

// One channel of four texels.
struct Square {
    std::uint32_t t00, t10, t01, t11;
};

// The sum of the four by their weights, fu and fv being in 1/one.
std::uint32_t sum_of_four(const Square& t, std::uint32_t fu, std::uint32_t fv, std::uint32_t one) {
    return (one - fv) * ((one - fu) * t.t00 + fu * t.t10) + fv * ((one - fu) * t.t01 + fu * t.t11);
}

// One channel by `rule`; fu, fv in 1/256.
std::uint32_t weighed(FilterRule rule, const Square& t, std::uint32_t fu, std::uint32_t fv) {
    switch (rule) {
        case FilterRule::Single8:
            return (sum_of_four(t, fu, fv, 256) + (1u << 15)) >> 16;
        case FilterRule::Single4:
            return (sum_of_four(t, fu >> 4, fv >> 4, 16) + (1u << 7)) >> 8;
        case FilterRule::Single7:
            return sum_of_four(t, fu >> 1, fv >> 1, 128) >> 14;
        case FilterRule::Cascade8: {
            const auto lerp = [](std::uint32_t a, std::uint32_t b, std::uint32_t f) {
                return ((256 - f) * a + f * b + 128) >> 8;
            };
            return lerp(lerp(t.t00, t.t10, fu), lerp(t.t01, t.t11, fu), fv);
        }
        case FilterRule::Cascade4: {
            const auto lerp = [](std::uint32_t a, std::uint32_t b, std::uint32_t f) {
                return ((16 - f) * a + f * b) >> 4;
            };
            return lerp(lerp(t.t00, t.t10, fu >> 4), lerp(t.t01, t.t11, fu >> 4), fv >> 4);
        }
    }
    return 0;
}

std::uint32_t sample_level(const Sampler& sampler, int level, std::int32_t level0_u, std::int32_t level0_v) {
    std::int32_t u = level0_u >> level, v = level0_v >> level;
    if (!sampler.linear) return texel_at(sampler, level, u >> 8, v >> 8);

    u -= 128;
    v -= 128;
    const int i = u >> 8, j = v >> 8;
    const std::uint32_t fu = u & 255, fv = v & 255;
    const std::uint32_t t00 = texel_at(sampler, level, i, j), t10 = texel_at(sampler, level, i + 1, j);
    const std::uint32_t t01 = texel_at(sampler, level, i, j + 1), t11 = texel_at(sampler, level, i + 1, j + 1);
    std::uint32_t color = 0;
    for (int shift = 0; shift < 32; shift += 8)
        color |= weighed(sampler.rule,
                         {channel(t00, shift), channel(t10, shift), channel(t01, shift), channel(t11, shift)}, fu, fv)
                 << shift;
    return color;
}

// One channel of two levels, f in 1/256.
std::uint32_t mixed(FilterRule rule, std::uint32_t a, std::uint32_t b, std::uint32_t f) {
    switch (rule) {
        case FilterRule::Single8:
        case FilterRule::Cascade8:
            return (a * (256 - f) + b * f + 128) >> 8;
        case FilterRule::Single4:
        case FilterRule::Single7:
        case FilterRule::Cascade4:
            f >>= 4;
            return (a * (16 - f) + b * f) >> 4;
    }
    return 0;
}

}  // namespace

TriangleTexture::TriangleTexture(const Corners& corners, const Triangle& triangle, int texture, const Sampler& sampler)
    : mips_(sampler.mip != MipFilter::None), levels_(level_count(sampler)) {
    std::array<float, 3> s{}, t{}, q{};
    for (int i = 0; i < 3; ++i) {
        const Vertex& vertex = triangle[i];
        s[i]                 = vertex.uv[texture].s * vertex.rhw;
        t[i]                 = vertex.uv[texture].t * vertex.rhw;
        q[i]                 = vertex.uv[texture].q * vertex.rhw;
    }
    const int e  = scale_exponent(std::max(largest_magnitude(s), largest_magnitude(t)), 60);
    const int eq = scale_exponent(largest_magnitude(q), 90);
    s_           = texture_plane(corners, scaled(s, e));
    t_           = texture_plane(corners, scaled(t, e));
    q_           = texture_plane(corners, scaled(q, eq));
    ku_          = static_cast<float>(std::ldexp(double(sampler.levels[0].width), eq - e));
    kv_          = static_cast<float>(std::ldexp(double(sampler.levels[0].height), eq - e));
}

TexturePoint TriangleTexture::at(int x, int y) const {
    const auto s     = static_cast<std::int32_t>(s_.value(x, y));
    const auto t     = static_cast<std::int32_t>(t_.value(x, y));
    const auto q     = std::max(static_cast<std::int32_t>(q_.value(x, y)), 1);
    const float r    = 1.0f / static_cast<float>(q);
    const float u    = static_cast<float>(s) * r;
    const float v    = static_cast<float>(t) * r;
    const auto texel = [](float coordinate, float k) {
        return static_cast<std::int32_t>(std::floor(std::clamp((coordinate * k) * 256.0f, -0x1p30f, 0x1p30f)));
    };
    return {texel(u, ku_), texel(v, kv_), mips_ ? lod_at(u, v, r) : 0};
}

std::int32_t TriangleTexture::lod_at(float u, float v, float r) const {
    const auto slope = [](std::int64_t step) { return static_cast<float>(static_cast<double>(step) / 0x1p12); };
    const float sx = slope(s_.step()), tx = slope(t_.step()), qx = slope(q_.step());
    const float sy = slope(s_.step_y()), ty = slope(t_.step_y()), qy = slope(q_.step_y());
    const float ux = ((sx - u * qx) * r) * ku_, vx = ((tx - v * qx) * r) * kv_;
    const float uy = ((sy - u * qy) * r) * ku_, vy = ((ty - v * qy) * r) * kv_;
    return lod_of(ux, vx, uy, vy, levels_);
}

RectangleTexture::RectangleTexture(const PixelGrid& grid, const Rectangle& rectangle, int texture,
                                   const Sampler& sampler) {
    const Rectangle::UvRect& uv = rectangle.uv[texture];
    const TextureLevel& level0  = sampler.levels[0];
    u_ = axis(grid.center, uv.u0, uv.u1, level0.width, snap(grid, rectangle.x0), snap(grid, rectangle.x1));
    v_ = axis(grid.center, uv.v0, uv.v1, level0.height, snap(grid, rectangle.y0), snap(grid, rectangle.y1));
    if (sampler.mip == MipFilter::None) return;
    const auto texels_per_pixel = [](std::int64_t step) {
        return static_cast<float>(static_cast<double>(step) / 0x1p32);
    };
    lod_ = lod_of(texels_per_pixel(u_.step), 0.0f, 0.0f, texels_per_pixel(v_.step), level_count(sampler));
}

RectangleTexture::Axis RectangleTexture::axis(int center, float c0, float c1, int size, std::int64_t x0,
                                              std::int64_t x1) {
    const auto to_integer = [](double value) {
        return static_cast<std::int64_t>(std::nearbyint(std::clamp(value, -0x1p62, 0x1p62)));
    };
    const double w0 = double{c0} * size, w1 = double{c1} * size;
    const double dw = (w1 - w0) * 0x1p36 / static_cast<double>(x1 - x0);
    return {.origin = to_integer(w0 * 0x1p32 + static_cast<double>(center - x0) / 16.0 * dw), .step = to_integer(dw)};
}

std::uint64_t RectangleTexture::Axis::plane(int pixel) const {
    return static_cast<std::uint64_t>(origin) + static_cast<std::uint64_t>(pixel) * static_cast<std::uint64_t>(step);
}

TexturePoint RectangleTexture::at(int x, int y) const {
    const int xb          = x / kBlockWidth * kBlockWidth;
    const auto step       = static_cast<std::uint64_t>(u_.step);
    const std::uint32_t u = rounded(u_.plane(xb), 16) + static_cast<std::uint32_t>(x - xb) * rounded(step, 16);
    const std::uint32_t v = rounded(v_.plane(y), 16);
    return {static_cast<std::int32_t>(u) >> 8, static_cast<std::int32_t>(v) >> 8, lod_};
}

std::uint32_t sample(const Sampler& sampler, const TexturePoint& point) {
    const auto [u, v, lod] = point;
    switch (sampler.mip) {
        case MipFilter::None:
            return sample_level(sampler, 0, u, v);
        case MipFilter::Point:
            return sample_level(sampler, (lod + 128) >> 8, u, v);
        case MipFilter::Linear: {
            const int level       = lod >> 8;
            const std::uint32_t f = lod & 255;
            const std::uint32_t a = sample_level(sampler, level, u, v);
            const std::uint32_t b = sample_level(sampler, std::min(level + 1, level_count(sampler) - 1), u, v);
            std::uint32_t color   = 0;
            for (int shift = 0; shift < 32; shift += 8)
                color |= mixed(sampler.rule, channel(a, shift), channel(b, shift), f) << shift;
            return color;
        }
    }
    return 0;
}

int texels_read(const Sampler& sampler) {
    return (sampler.linear ? 4 : 1) * (sampler.mip == MipFilter::Linear ? 2 : 1);
}

}  // namespace raster::reference
