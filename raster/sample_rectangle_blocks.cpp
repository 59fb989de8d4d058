// SPDX-License-Identifier: MIT
// Sampling for rectangles: along a block v is constant and u advances evenly, so texels come from contiguous loads instead of
// one by one, and a blit's weights are often quarters or halves, which need no more than 16 bits.
#include <type_traits>

#include "raster/sample_blocks.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/sample_rectangle_blocks.cpp"
#include "hwy/foreach_target.h"
#include "raster/lanes-inl.h"
#include "raster/sampling-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR
constexpr bool kHasWindows = false;
HWY_INLINE bool load_window(const std::uint32_t*, const std::uint32_t*, const std::int32_t*, Quad&) {
    return false;
}
HWY_INLINE bool load_halved(const std::uint32_t*, const std::uint32_t*, Quad&) {
    return false;
}
#else
constexpr bool kHasWindows = true;

// Magnified: all lanes lie in one vector of texels. u: less half a texel, of the vector's lanes.
HWY_INLINE bool load_window(const std::uint32_t* row0, const std::uint32_t* row1, const std::int32_t* u, Quad& quad) {
    const VI column  = hn::ShiftRight<8>(hn::Sub(hn::Load(DI(), u), seti(128)));
    const VI from    = hn::Sub(column, seti(hn::GetLane(column)));
    const auto left  = hn::IndicesFromVec(DU(), from);
    const auto right = hn::IndicesFromVec(DU(), hn::Add(from, seti(1)));
    const VU a = hn::LoadU(DU(), row0), b = hn::LoadU(DU(), row1);
    quad = {hn::TableLookupLanes(a, left), hn::TableLookupLanes(a, right), hn::TableLookupLanes(b, left),
            hn::TableLookupLanes(b, right)};
    return true;
}

// Two texels to the pixel.
HWY_INLINE bool load_halved(const std::uint32_t* row0, const std::uint32_t* row1, Quad& quad) {
    const DU d;
    const VU a0 = hn::LoadU(d, row0), a1 = hn::LoadU(d, row0 + lane_count());
    const VU b0 = hn::LoadU(d, row1), b1 = hn::LoadU(d, row1 + lane_count());
    quad = {hn::ConcatEven(d, a1, a0), hn::ConcatOdd(d, a1, a0), hn::ConcatEven(d, b1, b0), hn::ConcatOdd(d, b1, b0)};
    return true;
}
#endif

// How u advances over a vector of lanes. u is the floor of evenly spaced values, but modulo 2^24, so both ends count: with
// the first step between 0 and 512, a total of `step` for each lane means that every step is the same, and a total
// that is positive and no more means that none has wrapped.
struct Advance {
    int step;
    bool is_even, is_forward;
};
HWY_INLINE Advance advance_of(const std::int32_t* u) {
    const int last_lane = lane_count() - 1;
    const int step = last_lane > 0 ? u[1] - u[0] : 256, total = u[last_lane] - u[0];
    const bool is_small = step >= 0 && step <= 512;
    return {step, is_small && total == step * last_lane, is_small && total > 0};
}

// The neighbours of one vector of lanes if contiguous loads give them; false at the border and for other steps.
HWY_INLINE bool load_quad(const SamplePlan& plan, const std::int32_t* u, std::int32_t v, const Advance& advance,
                          Quad& quad) {
    const SamplePlan::Level& level = plan.levels[0];
    const int last_lane            = lane_count() - 1;
    const int first = (u[0] - 128) >> 8, last = (u[last_lane] - 128) >> 8, j = (v - 128) >> 8;
    if (first < 0 || j < 0 || j + 1 >= level.height) return false;
    const std::uint32_t* const row0 = level.texels + static_cast<std::ptrdiff_t>(j) * level.stride + first;
    const std::uint32_t* const row1 = row0 + level.stride;
    if (advance.is_even && advance.step == 256 && last + 1 < level.width) {
        const DU d;
        quad = {hn::LoadU(d, row0), hn::LoadU(d, row0 + 1), hn::LoadU(d, row1), hn::LoadU(d, row1 + 1)};
        return true;
    }
    if (!kHasWindows) return false;
    if (advance.is_even && advance.step == 512 && last + 1 < level.width) return load_halved(row0, row1, quad);
    if (advance.is_forward && last + 1 - first <= last_lane && first + last_lane < level.width)
        return load_window(row0, row1, u, quad);
    return false;
}

// (a + b + c + d + 2) >> 2: all four weights alike.
HWY_INLINE VU average(const Quad& quad) {
    const Pixels a = unpack(quad.t00), b = unpack(quad.t10), c = unpack(quad.t01), d = unpack(quad.t11);
    const VU two = set_pair(2), bytes = set_pair(0xff);
    const auto quarter = [&](VU p, VU q, VU r, VU s) HWY_ATTR {
        return hn::And(hn::ShiftRight<2>(add16(add16(add16(p, q), add16(r, s)), two)), bytes);
    };
    return pack({quarter(a.lo, b.lo, c.lo, d.lo), quarter(a.hi, b.hi, c.hi, d.hi)});
}

// Weights that are quarters: the sum is at most 16 * 255.
HWY_INLINE VU weigh_quarters(const Quad& quad, VI u, VI v) {
    const auto pair_of_quarters = [](VI fraction) HWY_ATTR {
        const VU f = hn::BitCast(DU(), hn::ShiftRight<6>(hn::And(fraction, seti(255))));
        return hn::Or(f, hn::ShiftLeft<16>(f));
    };
    const VU four = set_pair(4), fu = pair_of_quarters(u), fv = pair_of_quarters(v);
    const VU gu = sub16(four, fu), gv = sub16(four, fv);
    const Pixels top = weigh_row(quad.t00, quad.t10, fu, gu), bottom = weigh_row(quad.t01, quad.t11, fu, gu);
    const auto weigh = [&](VU a, VU b) HWY_ATTR {
        const VU sum = add16(add16(mul16(a, gv), mul16(b, fv)), set_pair(8));
        return hn::And(hn::ShiftRight<4>(sum), set_pair(0xff));
    };
    return pack({weigh(top.lo, bottom.lo), weigh(top.hi, bottom.hi)});
}

template <class Filter>
void sample_rectangle_linear(const SamplePlan& plan, const SamplePoints& points, int count,
                             BlockRows<std::uint32_t>& out) {
    for (int block = 0; block < count; ++block)
        for (int lane = 0; lane < kBlockWidth; lane += lane_count()) {
            const std::int32_t* const at = points.u[block] + lane;
            const std::int32_t v_there   = points.v[block][lane];
            const VI u = hn::Load(DI(), at), v = seti(v_there);
            const Advance advance = advance_of(at);
            Quad quad;
            VU texel;
            if (!load_quad(plan, at, v_there, advance, quad)) {
                texel = sample_level<Filter>(plan, 0, u, v);
            } else {
                const VI moved_u = hn::Sub(u, seti(128)), moved_v = hn::Sub(v, seti(128));
                const int bits = at[0] | v_there | advance.step;
                if (!std::is_same_v<Filter, Single8>)
                    texel = Filter::weigh(quad, moved_u, moved_v);
                else if (advance.is_even && (bits & 255) == 0)
                    texel = average(quad);  // both fractions are one half
                else if (advance.is_even && (bits & 63) == 0)
                    texel = weigh_quarters(quad, moved_u, moved_v);
                else
                    texel = Single8::weigh(quad, moved_u, moved_v);
            }
            hn::Store(texel, DU(), out[block] + lane);
        }
}

void sample_rectangle_point(const SamplePlan& plan, const SamplePoints& points, int count,
                            BlockRows<std::uint32_t>& out) {
    const SamplePlan::Level& level = plan.levels[0];
    for (int block = 0; block < count; ++block)
        for (int lane = 0; lane < kBlockWidth; lane += lane_count()) {
            const std::int32_t* const at = points.u[block] + lane;
            const int i = at[0] >> 8, j = points.v[block][lane] >> 8;
            const Advance advance = advance_of(at);
            const bool contiguous = advance.is_even && advance.step == 256 && i >= 0 &&
                                    i + lane_count() <= level.width && j >= 0 && j < level.height;
            const VU texel = contiguous
                                 ? hn::LoadU(DU(), level.texels + static_cast<std::ptrdiff_t>(j) * level.stride + i)
                                 : sample_level<Point<MixHalfUp>>(plan, 0, hn::Load(DI(), at),
                                                                  hn::Load(DI(), points.v[block] + lane));
            hn::Store(texel, DU(), out[block] + lane);
        }
}

SampleKernel get_rectangle_kernel(const SamplePlan& plan) {
    return for_filter(plan, [](auto filter) -> SampleKernel {
        using Filter = decltype(filter);
        if constexpr (Filter::kLinear) return &sample_rectangle_linear<Filter>;
        return &sample_rectangle_point;
    });
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raster {
HWY_EXPORT(get_rectangle_kernel);
SampleKernel sample_rectangle_kernel(const SamplePlan& plan) {
    if (plan.level_count == 0 || plan.lod_max() > 0) return sample_kernel(plan);
    return HWY_DYNAMIC_DISPATCH(get_rectangle_kernel)(plan);
}
}  // namespace raster
#endif
