// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cstddef>

#include "raster/triangle_setup.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/triangle_setup.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// A lane is one of a triangle's values. They are those that lie together in a vertex: the bytes of its two colours; and
// z, 1/w (which no plane is made of), s, t, q of the first and of the second texture.
constexpr int kLanes     = 8;
constexpr int kDepthLane = 0;
constexpr int texture_lane(int i) {
    return 2 + 3 * i;
}
static_assert(texture_lane(kMaxTextures) == kLanes);
static_assert(offsetof(Vertex, specular) == offsetof(Vertex, diffuse) + 4);
static_assert(offsetof(Vertex, rhw) == offsetof(Vertex, z) + 4 && offsetof(Vertex, uv) == offsetof(Vertex, z) + 8);
static_assert(sizeof(Vertex) == offsetof(Vertex, z) + kLanes * sizeof(float) &&
              sizeof(Plane) == 3 * sizeof(std::uint64_t));

using DD   = hn::CappedTag<double, kLanes>;
using DF   = hn::Rebind<float, DD>;
using DI   = hn::Rebind<std::int32_t, DD>;
using DU8  = hn::Rebind<std::uint8_t, DD>;
using DU64 = hn::Rebind<std::uint64_t, DD>;
using VD   = hn::Vec<DD>;
using VF   = hn::Vec<DF>;
using VU64 = hn::Vec<DU64>;

HWY_INLINE int lane_step() {
    return static_cast<int>(hn::Lanes(DD()));
}
HWY_INLINE VD set(double value) {
    return hn::Set(DD(), value);
}

// Snapped corners, clockwise.
struct Corners {
    const Vertex* vertex[3];
    std::int32_t x[3], y[3];  // subpixels
    std::int64_t area = 0;

    HWY_INLINE bool order() {
        area = std::int64_t{x[1] - x[0]} * (y[2] - y[0]) - std::int64_t{x[2] - x[0]} * (y[1] - y[0]);
        if (area < 0) {
            std::swap(vertex[1], vertex[2]);
            std::swap(x[1], x[2]);
            std::swap(y[1], y[2]);
            area = -area;
        }
        return area != 0;
    }
};

// As snap_to_subpixels. Below 2^22 the sum has no room for a fraction, so it rounds to nearest, ties to even.
HWY_INLINE std::int32_t snap(const PixelGrid& grid, float pixels) {
    constexpr float kRound = 0x1.8p23f;
    const float subpixels  = pixels * float{kSubpixels};
    return static_cast<std::int32_t>(grid.truncate ? subpixels : (subpixels + kRound) - kRound);
}

HWY_INLINE Edge make_edge(const PixelGrid& grid, const Corners& c, int from, int to) {
    const std::int64_t ex = c.x[to] - c.x[from], ey = c.y[to] - c.y[from];
    const bool top_left          = ey < 0 || (ey == 0 && ex > 0);
    const std::int64_t at_origin = ex * (grid.center - c.y[from]) - ey * (grid.center - c.x[from]);
    return {.a = static_cast<std::int32_t>(-ey),
            .b = static_cast<std::int32_t>(ex),
            .c = (at_origin - (top_left ? 0 : 1)) >> kSubpixelBits};
}

HWY_INLINE Rect pixels_between(const PixelGrid& grid, const Corners& c) {
    const auto [x_min, x_max] = std::minmax({c.x[0], c.x[1], c.x[2]});
    const auto [y_min, y_max] = std::minmax({c.y[0], c.y[1], c.y[2]});
    const auto first          = [&](std::int32_t low) { return (low - grid.center + kSubpixels - 1) >> kSubpixelBits; };
    const auto end            = [&](std::int32_t high) { return ((high - grid.center) >> kSubpixelBits) + 1; };
    return {first(x_min), first(y_min), end(x_max), end(y_max)};
}

// Whole numbers n / d and what is left, for n < 2^51 and 1 <= d < 2^40, both whole. The product with the rounded
// reciprocal is off by n / d * 2^-52 at most, 1/4 unless d is 1 and both are exact; so the nearest whole number is the
// quotient or one more, and its product with d is exact.
struct Division {
    VD quotient, rest;
};
HWY_INLINE Division divide(VD n, VD d, VD reciprocal) {
    const VD round      = set(0x1p52);
    const VD nearest    = hn::Sub(hn::Add(hn::Mul(n, reciprocal), round), round);
    const VD rest       = hn::Sub(n, hn::Mul(nearest, d));
    const auto too_many = hn::Lt(rest, hn::Zero(DD()));
    return {hn::Sub(nearest, hn::IfThenElseZero(too_many, set(1.0))), hn::Add(rest, hn::IfThenElseZero(too_many, d))};
}

// A whole number, |v| < 2^51.
HWY_INLINE VU64 to_integer(VD v) {
    const VD base = set(0x1.8p52);
    return hn::Sub(hn::BitCast(DU64(), hn::Add(v, base)), hn::BitCast(DU64(), base));
}
// The nearest whole number, ties to even, of |v| < 2^51.
HWY_INLINE VD round(VD v) {
    const VD base = set(0x1.8p52);
    return hn::Sub(hn::Add(v, base), base);
}

// The planes of the rules, as many at once as there are lanes.
class PlaneMaker {
  public:
    PlaneMaker(const PixelGrid& grid, const Corners& c)
        : x1_(c.x[1] - c.x[0]),
          y1_(c.y[1] - c.y[0]),
          x2_(c.x[2] - c.x[0]),
          y2_(c.y[2] - c.y[0]),
          area_(static_cast<double>(c.area)),
          reciprocal_(1.0 / area_),
          to_center_x_(static_cast<std::uint64_t>(std::int64_t{grid.center} - c.x[0])),
          to_center_y_(static_cast<std::uint64_t>(std::int64_t{grid.center} - c.y[0])) {}

    // From whole values at the corners. F = kFirst + kSecond: digits of a long division. A numerator is below 2^50 for
    // values of 30 bits (kFirst 0) and 2^28 for bytes (kFirst 23), and what a division leaves is below 2^39 (kSecond 12
    // or 8): each dividend is below 2^51.
    template <int kFirst, int kSecond>
    HWY_INLINE void make(VD v0, VD v1, VD v2, Plane* out) const {
        const VD d1 = hn::Sub(v1, v0), d2 = hn::Sub(v2, v0);
        const VU64 gx = gradient<kFirst, kSecond>(hn::Sub(hn::Mul(d1, set(y2_)), hn::Mul(d2, set(y1_))));
        const VU64 gy = gradient<kFirst, kSecond>(hn::Sub(hn::Mul(d2, set(x1_)), hn::Mul(d1, set(x2_))));
        const VU64 to_center =
            hn::Add(hn::Mul(gx, hn::Set(DU64(), to_center_x_)), hn::Mul(gy, hn::Set(DU64(), to_center_y_)));
        const VU64 origin = hn::Add(hn::ShiftLeft<kFirst + kSecond>(to_integer(v0)), to_center);
        hn::StoreInterleaved3(origin, hn::ShiftLeft<kSubpixelBits>(gx), hn::ShiftLeft<kSubpixelBits>(gy), DU64(),
                              &out->origin);
    }

  private:
    // n * 2^F / area, truncated toward zero, modulo 2^64.
    template <int kFirst, int kSecond>
    HWY_INLINE VU64 gradient(VD n) const {
        const VD area = set(area_), reciprocal = set(reciprocal_);
        const Division first = divide(hn::Mul(hn::Abs(n), set(1 << kFirst)), area, reciprocal);
        VU64 magnitude       = to_integer(first.quotient);
        if constexpr (kSecond > 0) {
            const Division second = divide(hn::Mul(first.rest, set(1 << kSecond)), area, reciprocal);
            magnitude             = hn::Add(hn::ShiftLeft<kSecond>(magnitude), to_integer(second.quotient));
        }
        const auto is_negative = hn::RebindMask(DU64(), hn::Lt(n, hn::Zero(DD())));
        return hn::IfThenElse(is_negative, hn::Sub(hn::Zero(DU64()), magnitude), magnitude);
    }

    double x1_, y1_, x2_, y2_, area_, reciprocal_;
    std::uint64_t to_center_x_, to_center_y_;
};

// 2^e as a float's or double's bits say it, e of a normal number.
HWY_INLINE double power_of_two(int e) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52);
}

// The largest exponent e <= limit with largest * 2^e < 2^29; limit >= 28 - (-126), so subnormal numbers need no care.
HWY_INLINE int scale_exponent(float largest, int limit) {
    const int exponent = static_cast<int>(std::bit_cast<std::uint32_t>(largest) >> 23) - 127;
    return std::min(limit, 28 - exponent);
}

HWY_INLINE float step_of(std::uint64_t plane_step) {
    return static_cast<float>(static_cast<double>(static_cast<std::int64_t>(plane_step)) / (1 << kTextureFraction));
}

// As depth_value, without its `cut` low bits.
HWY_INLINE std::int32_t to_depth(float z, int cut) {
    const auto value = static_cast<std::int32_t>((static_cast<double>(z) * ((1 << kDepthBits) - 1) + 0x1p52) - 0x1p52);
    return value & -(1 << cut);
}

// z, and s, t, q times 1/w, at the corners; and the powers of two that make integers of s, t, and of q.
struct Values {
    alignas(64) float at[3][kLanes];
    struct Exponents {
        int st = 0, q = 0;
    };
    Exponents exponents[kMaxTextures];

    HWY_INLINE Values(const Corners& c, const SetupNeeds& needs, int used_lanes) {
        alignas(64) float largest[kLanes];
        for (int lane = 0; lane < used_lanes; lane += lane_step()) {
            const auto is_depth = hn::FirstN(DF(), lane == kDepthLane ? 1 : 0);
            const auto value    = [&](int corner) HWY_ATTR {
                const auto* const floats =
                    reinterpret_cast<const float*>(c.vertex[corner]) + offsetof(Vertex, z) / sizeof(float);
                const VF rhw = hn::Set(DF(), c.vertex[corner]->rhw);
                const VF product =
                    hn::Mul(hn::LoadU(DF(), floats + lane), hn::IfThenElse(is_depth, hn::Set(DF(), 1.0f), rhw));
                hn::Store(product, DF(), at[corner] + lane);
                return hn::Abs(product);
            };
            hn::Store(hn::Max(value(0), hn::Max(value(1), value(2))), DF(), largest + lane);
        }
        for (int i = 0; i < kMaxTextures; ++i) {
            if (!needs.texture[i]) continue;
            const int lane  = texture_lane(i);
            exponents[i].st = scale_exponent(std::max(largest[lane], largest[lane + 1]), 60);
            exponents[i].q  = scale_exponent(largest[lane + 2], 90);
        }
    }

    // What the lanes are multiplied by. From registers: what is put together in memory from parts is slow to load.
    HWY_INLINE VD scale(int lane) const {
        static_assert(kMaxTextures == 2);
        alignas(64) static constexpr double kDepth[kLanes]    = {(1 << kDepthBits) - 1};
        alignas(64) static constexpr double kTakes[4][kLanes] = {
            {0, 0, 1, 1, 0, 0, 0, 0}, {0, 0, 0, 0, 1, 0, 0, 0}, {0, 0, 0, 0, 0, 1, 1, 0}, {0, 0, 0, 0, 0, 0, 0, 1}};
        const auto part = [&](int i, int exponent) HWY_ATTR {
            return hn::Mul(hn::Load(DD(), kTakes[i] + lane), set(power_of_two(exponent)));
        };
        return hn::Add(hn::Load(DD(), kDepth + lane),
                       hn::Add(hn::Add(part(0, exponents[0].st), part(1, exponents[0].q)),
                               hn::Add(part(2, exponents[1].st), part(3, exponents[1].q))));
    }

    HWY_INLINE VD integers(int corner, int lane, VD lane_scale) const {
        return round(hn::Mul(hn::PromoteTo(DD(), hn::Load(DF(), at[corner] + lane)), lane_scale));
    }
};

HWY_INLINE void set_texture(const Plane* planes, const SetupNeeds& needs, int i, const Values::Exponents& exponents,
                            TexturePlanes& out) {
    const double scale = power_of_two(exponents.q - exponents.st);
    out.s              = planes[texture_lane(i)];
    out.t              = planes[texture_lane(i) + 1];
    out.q              = planes[texture_lane(i) + 2];
    out.scale_u        = static_cast<float>(needs.width[i] * scale);
    out.scale_v        = static_cast<float>(needs.height[i] * scale);
    if (!needs.lod[i]) return;
    out.sx = step_of(out.s.dx), out.tx = step_of(out.t.dx), out.qx = step_of(out.q.dx);
    out.sy = step_of(out.s.dy), out.ty = step_of(out.t.dy), out.qy = step_of(out.q.dy);
}

HWY_INLINE void set_up_depth_and_textures(const Corners& c, const SetupNeeds& needs, const PlaneMaker& maker,
                                          SetUpTriangle& out) {
    const int used_lanes = needs.texture[1]   ? texture_lane(2)
                           : needs.texture[0] ? texture_lane(1)
                           : needs.depth      ? kDepthLane + 1
                                              : 0;
    const Values values(c, needs, used_lanes);
    Plane planes[kLanes];
    static_assert(kDepthFraction == 12 && kTextureFraction == 12);
    for (int lane = 0; lane < used_lanes; lane += lane_step()) {
        const VD scale = values.scale(lane);
        maker.make<0, 12>(values.integers(0, lane, scale), values.integers(1, lane, scale),
                          values.integers(2, lane, scale), planes + lane);
    }
    if (needs.depth && needs.depth_cut != 0) {
        // Rare enough for lanes of which one is used.
        const auto depth = [&](int corner) HWY_ATTR { return set(to_depth(c.vertex[corner]->z, needs.depth_cut)); };
        Plane cut[kLanes];
        maker.make<0, 12>(depth(0), depth(1), depth(2), cut);
        planes[kDepthLane] = cut[0];
    }
    if (needs.depth) {
        out.depth             = planes[kDepthLane];
        const auto [min, max] = std::minmax({c.vertex[0]->z, c.vertex[1]->z, c.vertex[2]->z});
        out.depth_min         = to_depth(min, needs.depth_cut);
        out.depth_max         = to_depth(max, needs.depth_cut);
    }
    for (int i = 0; i < kMaxTextures; ++i)
        if (needs.texture[i]) set_texture(planes, needs, i, values.exponents[i], out.textures[i]);
}

template <int kFirst, int kSecond>
HWY_INLINE void set_up_colors(const Corners& c, const SetupNeeds& needs, const PlaneMaker& maker, SetUpTriangle& out) {
    constexpr int kChannels = 4;
    Plane planes[kLanes];
    for (int lane = 0; lane < (out.specular_varies ? kLanes : kChannels); lane += lane_step()) {
        const auto bytes = [&](int corner) HWY_ATTR {
            const auto* const colors =
                reinterpret_cast<const std::uint8_t*>(c.vertex[corner]) + offsetof(Vertex, diffuse);
            return hn::PromoteTo(DD(), hn::PromoteTo(DI(), hn::LoadU(DU8(), colors + lane)));
        };
        maker.make<kFirst, kSecond>(bytes(0), bytes(1), bytes(2), planes + lane);
    }
    if (out.diffuse_varies) std::copy_n(planes, kChannels, out.diffuse.begin());
    if (!out.specular_varies) return;
    if (needs.specular)
        std::copy_n(planes + kChannels, kChannels, out.specular.begin());
    else
        out.specular[3] = planes[kChannels + 3];
}

HWY_INLINE bool set_up(Corners& c, bool flat, const SetupNeeds& needs, const PixelGrid& grid, const Rect& scissor,
                       SetUpTriangle& out) {
    const Vertex& first = *c.vertex[0];
    for (int i = 0; i < 3; ++i) {
        c.x[i] = snap(grid, c.vertex[i]->x);
        c.y[i] = snap(grid, c.vertex[i]->y);
    }
    if (!c.order()) return false;
    out.bounds = intersect(pixels_between(grid, c), scissor);
    if (out.bounds.empty()) return false;
    for (int i = 0; i < 3; ++i) out.edges[i] = make_edge(grid, c, i, (i + 1) % 3);

    const auto varies = [&](std::uint32_t Vertex::*color, std::uint32_t bits) {
        return !flat && (((first.*color ^ c.vertex[1]->*color) | (first.*color ^ c.vertex[2]->*color)) & bits) != 0;
    };
    out.flat_diffuse    = first.diffuse;
    out.flat_specular   = first.specular;
    out.diffuse_varies  = needs.diffuse && varies(&Vertex::diffuse, 0xffffffff);
    out.specular_varies = (needs.specular && varies(&Vertex::specular, 0xffffffff)) ||
                          (needs.fog && varies(&Vertex::specular, 0xff000000));

    const PlaneMaker maker(grid, c);
    set_up_depth_and_textures(c, needs, maker, out);
    if (!out.diffuse_varies && !out.specular_varies) return true;
    static_assert(kColorFraction == 23 && kFloorColorFraction == 31);
    if (needs.floor_colors)
        set_up_colors<23, 8>(c, needs, maker, out);
    else
        set_up_colors<23, 0>(c, needs, maker, out);
    return true;
}

std::size_t set_up_list(const TriangleList& triangles, const SetupNeeds& needs, const PixelGrid& grid,
                        const Rect& scissor, SetUpTriangle* out) {
    SetUpTriangle* next = out;
    for (const TriangleCorners& corners : triangles.corners) {
        Corners c;
        for (int i = 0; i < 3; ++i) c.vertex[i] = &triangles.vertices[corners[i]];
        if (set_up(c, triangles.flat, needs, grid, scissor, *next)) ++next;
    }
    return static_cast<std::size_t>(next - out);
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raster {

HWY_EXPORT(set_up_list);
std::size_t set_up_triangles(const TriangleList& triangles, const SetupNeeds& needs, const PixelGrid& grid,
                             const Rect& scissor, SetUpTriangle* out) {
    return HWY_DYNAMIC_DISPATCH(set_up_list)(triangles, needs, grid, scissor, out);
}

}  // namespace raster
#endif
