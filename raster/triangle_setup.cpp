// SPDX-License-Identifier: MIT
#include "raster/triangle_setup.h"

#include <algorithm>
#include <cmath>

namespace raster {
namespace {

// The pixels that are sampled in [low, high] subpixels, as a half-open range.
int first_pixel(const PixelGrid& grid, std::int64_t low) {
    return static_cast<int>((low - grid.center + kSubpixels - 1) >> kSubpixelBits);
}
int end_pixel(const PixelGrid& grid, std::int64_t high) {
    return static_cast<int>((high - grid.center) >> kSubpixelBits) + 1;
}
Rect pixels_between(const PixelGrid& grid, std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) {
    return {first_pixel(grid, x0), first_pixel(grid, y0), end_pixel(grid, x1), end_pixel(grid, y1)};
}

Edge make_edge(const PixelGrid& grid, const Subpixel& from, const Subpixel& to) {
    const std::int64_t ex = to.x - from.x, ey = to.y - from.y;
    const bool top_left          = ey < 0 || (ey == 0 && ex > 0);
    const std::int64_t at_origin = ex * (grid.center - from.y) - ey * (grid.center - from.x);
    return {.a = -ey, .b = ex, .c = (at_origin - (top_left ? 0 : 1)) >> kSubpixelBits};
}

// Gradients of one triangle's values. The corners are clockwise, the area positive.
class PlaneMaker {
  public:
    PlaneMaker(const PixelGrid& grid, const std::array<Subpixel, 3>& corners, std::int64_t area)
        : center_(grid.center),
          x0_(corners[0].x),
          y0_(corners[0].y),
          x1_(corners[1].x - x0_),
          y1_(corners[1].y - y0_),
          x2_(corners[2].x - x0_),
          y2_(corners[2].y - y0_),
          area_(area) {}

    template <int kFraction>
    Plane make(std::int64_t v0, std::int64_t v1, std::int64_t v2) const {
        const std::int64_t d1 = v1 - v0, d2 = v2 - v0;
        const auto gx = static_cast<std::uint64_t>((d1 * y2_ - d2 * y1_) * (std::int64_t{1} << kFraction) / area_);
        const auto gy = static_cast<std::uint64_t>((d2 * x1_ - d1 * x2_) * (std::int64_t{1} << kFraction) / area_);
        const std::uint64_t at_corner = static_cast<std::uint64_t>(v0) << kFraction;
        return {.origin = at_corner + gx * static_cast<std::uint64_t>(center_ - x0_) +
                          gy * static_cast<std::uint64_t>(center_ - y0_),
                .dx = gx << kSubpixelBits,
                .dy = gy << kSubpixelBits};
    }

  private:
    std::int64_t center_, x0_, y0_, x1_, y1_, x2_, y2_, area_;
};

template <int kFraction>
std::array<Plane, 4> color_planes(const PlaneMaker& maker, std::uint32_t c0, std::uint32_t c1, std::uint32_t c2) {
    std::array<Plane, 4> planes;
    for (int channel = 0; channel < 4; ++channel) {
        const int shift = 8 * channel;
        planes[channel] = maker.make<kFraction>(c0 >> shift & 255, c1 >> shift & 255, c2 >> shift & 255);
    }
    return planes;
}

// The largest exponent e <= limit with largest * 2^e < 2^29.
int scale_exponent(float largest, int limit) {
    if (largest == 0.0f) return limit;
    return std::min(limit, 28 - std::ilogb(largest));
}

float step_of(std::uint64_t plane_step) {
    return static_cast<float>(static_cast<double>(static_cast<std::int64_t>(plane_step)) / (1 << kTextureFraction));
}

TexturePlanes texture_planes(const PlaneMaker& maker, const std::array<const Vertex*, 3>& v, int stage, bool lod,
                             int width, int height) {
    std::array<float, 3> s, t, q;
    float largest_st = 0.0f, largest_q = 0.0f;
    for (int i = 0; i < 3; ++i) {
        const TexCoord& uv = v[i]->uv[stage];
        s[i]               = uv.s * v[i]->rhw;
        t[i]               = uv.t * v[i]->rhw;
        q[i]               = uv.q * v[i]->rhw;
        largest_st         = std::max({largest_st, std::abs(s[i]), std::abs(t[i])});
        largest_q          = std::max(largest_q, std::abs(q[i]));
    }
    const int e = scale_exponent(largest_st, 60), eq = scale_exponent(largest_q, 90);
    const auto integer = [](float value, int exponent) {
        return static_cast<std::int64_t>(std::nearbyint(std::ldexp(static_cast<double>(value), exponent)));
    };
    const auto plane = [&](const std::array<float, 3>& value, int exponent) {
        return maker.make<kTextureFraction>(integer(value[0], exponent), integer(value[1], exponent),
                                            integer(value[2], exponent));
    };
    TexturePlanes out;
    out.s       = plane(s, e);
    out.t       = plane(t, e);
    out.q       = plane(q, eq);
    out.scale_u = static_cast<float>(std::ldexp(static_cast<double>(width), eq - e));
    out.scale_v = static_cast<float>(std::ldexp(static_cast<double>(height), eq - e));
    if (lod) {
        out.sx = step_of(out.s.dx), out.tx = step_of(out.t.dx), out.qx = step_of(out.q.dx);
        out.sy = step_of(out.s.dy), out.ty = step_of(out.t.dy), out.qy = step_of(out.q.dy);
    }
    return out;
}

}  // namespace

bool set_up_triangle(const Triangle& triangle, const SetupNeeds& needs, const PixelGrid& grid, const Rect& scissor,
                     SetUpTriangle& out) {
    std::array<const Vertex*, 3> v{&triangle[0], &triangle[1], &triangle[2]};
    std::array<Subpixel, 3> p;
    for (int i = 0; i < 3; ++i) p[i] = snap_to_subpixels(grid, v[i]->x, v[i]->y);

    std::int64_t area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
    if (area == 0) return false;
    if (area < 0) {
        std::swap(p[1], p[2]);
        std::swap(v[1], v[2]);
        area = -area;
    }
    const auto [x_min, x_max] = std::minmax({p[0].x, p[1].x, p[2].x});
    const auto [y_min, y_max] = std::minmax({p[0].y, p[1].y, p[2].y});
    out.bounds                = intersect(pixels_between(grid, x_min, y_min, x_max, y_max), scissor);
    if (out.bounds.empty()) return false;

    for (int i = 0; i < 3; ++i) out.edges[i] = make_edge(grid, p[i], p[(i + 1) % 3]);

    const PlaneMaker maker(grid, p, area);
    if (needs.depth) {
        const std::int64_t z0 = depth_value(v[0]->z), z1 = depth_value(v[1]->z), z2 = depth_value(v[2]->z);
        out.depth     = maker.make<kDepthFraction>(z0, z1, z2);
        out.depth_min = static_cast<std::int32_t>(std::min({z0, z1, z2}));
        out.depth_max = static_cast<std::int32_t>(std::max({z0, z1, z2}));
    }
    const auto varies = [&](std::uint32_t Vertex::*color) {
        return v[0]->*color != v[1]->*color || v[0]->*color != v[2]->*color;
    };
    out.flat_diffuse    = v[0]->diffuse;
    out.flat_specular   = v[0]->specular;
    out.diffuse_varies  = needs.diffuse && varies(&Vertex::diffuse);
    out.specular_varies = needs.specular && varies(&Vertex::specular);
    const auto planes   = [&](std::uint32_t Vertex::*color) {
        const std::uint32_t c0 = v[0]->*color, c1 = v[1]->*color, c2 = v[2]->*color;
        return needs.floor_colors ? color_planes<kFloorColorFraction>(maker, c0, c1, c2)
                                    : color_planes<kColorFraction>(maker, c0, c1, c2);
    };
    if (out.diffuse_varies) out.diffuse = planes(&Vertex::diffuse);
    if (out.specular_varies) out.specular = planes(&Vertex::specular);
    for (int i = 0; i < kMaxTextures; ++i)
        if (needs.texture[i])
            out.textures[i] = texture_planes(maker, v, i, needs.lod[i], needs.width[i], needs.height[i]);
    return true;
}

bool set_up_rectangle(const Rectangle& rectangle, const SetupNeeds& needs, const PixelGrid& grid, const Rect& scissor,
                      SetUpRectangle& out) {
    const auto [x0, y0] = snap_to_subpixels(grid, rectangle.x0, rectangle.y0);
    const auto [x1, y1] = snap_to_subpixels(grid, rectangle.x1, rectangle.y1);
    // The end is open: a pixel sampled exactly on it is outside.
    out.bounds          = intersect(pixels_between(grid, x0, y0, x1 - 1, y1 - 1), scissor);
    if (out.bounds.empty()) return false;
    out.depth = depth_value(rectangle.z);
    out.color = rectangle.color;

    const auto axis = [&grid](float from, float to, int size, std::int64_t begin, std::int64_t end) {
        static constexpr double kTexel = 4294967296.0;           // 2^32
        static constexpr double kLimit = 4611686018427387904.0;  // 2^62
        const auto integer             = [](double value) {
            return static_cast<std::uint64_t>(
                static_cast<std::int64_t>(std::nearbyint(std::clamp(value, -kLimit, kLimit))));
        };
        const double w0 = static_cast<double>(from) * size, w1 = static_cast<double>(to) * size;
        const double step   = (w1 - w0) * (kTexel * kSubpixels) / static_cast<double>(end - begin);
        const double origin = w0 * kTexel + static_cast<double>(grid.center - begin) / kSubpixels * step;
        return AxisPlane{integer(origin), integer(step)};
    };
    for (int i = 0; i < kMaxTextures; ++i) {
        if (!needs.texture[i]) continue;
        SetUpRectangle::Texture& texture = out.textures[i];
        const Rectangle::UvRect& uv      = rectangle.uv[i];
        texture.u                        = axis(uv.u0, uv.u1, needs.width[i], x0, x1);
        texture.v                        = axis(uv.v0, uv.v1, needs.height[i], y0, y1);
        const auto per_pixel             = [](std::uint64_t step) {
            return static_cast<float>(static_cast<double>(static_cast<std::int64_t>(step)) / 4294967296.0);
        };
        texture.ux = per_pixel(texture.u.step);
        texture.vy = per_pixel(texture.v.step);
    }
    return true;
}

}  // namespace raster
