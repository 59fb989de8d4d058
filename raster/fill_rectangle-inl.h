// SPDX-License-Identifier: MIT
// A rectangle within one tile. Depth and colour are constant, v is the same along a row and u advances evenly: so texels
// mostly come from contiguous loads instead of one by one, and a blit's weights are often quarters or halves, which need
// no more than 16 bits.
// Highway's per-target include guard.
#if defined(NIMBUS7_RASTER_FILL_RECTANGLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NIMBUS7_RASTER_FILL_RECTANGLE_INL_H_
#undef NIMBUS7_RASTER_FILL_RECTANGLE_INL_H_
#else
#define NIMBUS7_RASTER_FILL_RECTANGLE_INL_H_
#endif

#include <algorithm>

#include "raster/cover-inl.h"
#include "raster/sampling-inl.h"
#include "raster/shade-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

// The texture coordinates of one vector of lanes: u of each is (start + lane * step) >> 8 modulo 2^24, in 1/256 texel.
struct RowOfTexels {
    std::int32_t start, step, v;

    HWY_INLINE VI u() const { return hn::ShiftRight<8>(hn::Add(seti(start), hn::Mul(lane_index(0), seti(step)))); }
};

// Where u of the first and last lane is, and how it gets there.
class Advance {
  public:
    explicit HWY_INLINE Advance(const RowOfTexels& at) : step_(at.step >> 8) {
        const std::int64_t last = at.start + std::int64_t{at.step} * (lane_count() - 1);
        in_order_               = at.step >= 0 && last == static_cast<std::int32_t>(last);
        first_                  = at.start >> 8;
        last_                   = static_cast<std::int32_t>(last) >> 8;
    }
    // Does u gain exactly `step` with each lane? Its gains are the floor of the same number, or one more.
    HWY_INLINE bool is_even(int step) const {
        return in_order_ && (step_ == step || step_ == step - 1) && last_ - first_ == step * (lane_count() - 1);
    }
    HWY_INLINE bool is_in_order() const { return in_order_; }
    HWY_INLINE int first() const { return first_; }
    HWY_INLINE int last() const { return last_; }

  private:
    int step_, first_ = 0, last_ = 0;
    bool in_order_ = false;
};

// (a + b + c + d + 2) >> 2: all four weights alike.
HWY_INLINE Pixels average(const Quad& quad) {
    const Pixels a = unpack(quad.t00), b = unpack(quad.t10), c = unpack(quad.t01), d = unpack(quad.t11);
    const auto quarter = [](VU p, VU q, VU r, VU s) NIMBUS7_LAMBDA {
        return shift_right16<2>(add16(add16(add16(p, q), add16(r, s)), set_pair(2)));
    };
    return {quarter(a.lo, b.lo, c.lo, d.lo), quarter(a.hi, b.hi, c.hi, d.hi)};
}

// Weights that are quarters: the sum is at most 16 * 255.
HWY_INLINE Pixels weigh_quarters(const Quad& quad, VI u, VI v) {
    const VU four = set_pair(4), fu = fraction_pair_over<6>(u), fv = fraction_pair_over<6>(v);
    const VU gu = sub16(four, fu), gv = sub16(four, fv);
    const Pixels top = weigh_row(quad.t00, quad.t10, fu, gu), bottom = weigh_row(quad.t01, quad.t11, fu, gu);
    const Pixels sum = weigh(top, bottom, fv, gv);
    const VU half    = set_pair(8);
    return {shift_right16<4>(add16(sum.lo, half)), shift_right16<4>(add16(sum.hi, half))};
}

#if HWY_TARGET != HWY_SCALAR
// Magnified: all lanes lie in one vector of texels.
HWY_INLINE Quad load_window(const std::uint32_t* row0, const std::uint32_t* row1, VI column) {
    const VI from    = hn::Sub(column, seti(hn::GetLane(column)));
    const auto left  = hn::IndicesFromVec(DU(), from);
    const auto right = hn::IndicesFromVec(DU(), hn::Add(from, seti(1)));
    const VU a = hn::LoadU(DU(), row0), b = hn::LoadU(DU(), row1);
    return {hn::TableLookupLanes(a, left), hn::TableLookupLanes(a, right), hn::TableLookupLanes(b, left),
            hn::TableLookupLanes(b, right)};
}

// Two texels to the pixel.
HWY_INLINE Quad load_halved(const std::uint32_t* row0, const std::uint32_t* row1) {
    const DU d;
    const VU a0 = hn::LoadU(d, row0), a1 = hn::LoadU(d, row0 + lane_count());
    const VU b0 = hn::LoadU(d, row1), b1 = hn::LoadU(d, row1 + lane_count());
    return {hn::ConcatEven(d, a1, a0), hn::ConcatOdd(d, a1, a0), hn::ConcatEven(d, b1, b0), hn::ConcatOdd(d, b1, b0)};
}
#endif

// By contiguous loads; false at the border and for other steps.
HWY_INLINE bool load_quad_of_row(const SamplePlan::Level& level, const RowOfTexels& at, const Advance& advance,
                                 Quad& quad) {
    const int first = (advance.first() - 128) >> 8, last = (advance.last() - 128) >> 8, j = (at.v - 128) >> 8;
    if (!advance.is_in_order() || first < 0 || j < 0 || j + 1 >= level.height || last + 1 >= level.width) return false;
    const std::uint32_t* const row0 = level.texels + static_cast<std::ptrdiff_t>(j) * level.stride + first;
    const std::uint32_t* const row1 = row0 + level.stride;
    if (advance.is_even(256)) {
        const DU d;
        quad = {hn::LoadU(d, row0), hn::LoadU(d, row0 + 1), hn::LoadU(d, row1), hn::LoadU(d, row1 + 1)};
        return true;
    }
#if HWY_TARGET != HWY_SCALAR
    if (advance.is_even(512)) {
        quad = load_halved(row0, row1);
        return true;
    }
    const int last_lane = lane_count() - 1;
    if (last + 1 - first <= last_lane && first + last_lane < level.width) {
        quad = load_window(row0, row1, hn::ShiftRight<8>(hn::Sub(at.u(), seti(128))));
        return true;
    }
#endif
    return false;
}

template <class Texture>
HWY_INLINE Pixels sample_linear_row(Texture program, const SamplePlan& plan, const RowOfTexels& at) {
    const Advance advance(at);
    Quad quad;
    if (!load_quad_of_row(plan.levels[0], at, advance, quad)) return sample(program, plan, at.u(), seti(at.v), nullptr);
    const bool is_even = advance.is_even(256) || advance.is_even(512);
    const int bits     = advance.first() | at.v;
    if (program->rule == FilterRule::Single8 && is_even && (bits & 255) == 0)
        return average(quad);  // both fractions are one half
    const VI half = seti(128), u = hn::Sub(at.u(), half), v = hn::Sub(seti(at.v), half);
    if (program->rule == FilterRule::Single8 && is_even && (bits & 63) == 0) return weigh_quarters(quad, u, v);
    return with_filter(program, [&](auto filter) NIMBUS7_LAMBDA {
        using Filter = decltype(filter);
        if constexpr (Filter::kLinear)
            return Filter::weigh_quad(quad, u, v);
        else
            return unpack(quad.t00);  // not for such a program
    });
}

template <class Texture>
HWY_INLINE Pixels sample_point_row(Texture program, const SamplePlan& plan, const RowOfTexels& at) {
    const SamplePlan::Level& level = plan.levels[0];
    const Advance advance(at);
    const int i = advance.first() >> 8, j = at.v >> 8;
    if (advance.is_even(256) && i >= 0 && i + lane_count() <= level.width && j >= 0 && j < level.height)
        return unpack(hn::LoadU(DU(), level.texels + static_cast<std::ptrdiff_t>(j) * level.stride + i));
    return sample(program, plan, at.u(), seti(at.v), nullptr);
}

template <class Texture>
HWY_INLINE Pixels sample_row(Texture program, const SamplePlan& plan, int lod, const RowOfTexels& at) {
    if (program->has_mips) {
        alignas(64) std::int32_t lods[kBlockWidth];
        hn::Store(seti(lod), DI(), lods);
        return sample(program, plan, at.u(), seti(at.v), lods);
    }
    return program->linear ? sample_linear_row(program, plan, at) : sample_point_row(program, plan, at);
}

// In 1/256 level, by raster/sampling_rules.h.
HWY_INLINE int rectangle_lod(const SetUpRectangle::Texture& texture, int lod_max) {
    const float rho2 = std::max(texture.ux * texture.ux, texture.vy * texture.vy);
    return std::clamp((std::bit_cast<std::int32_t>(rho2) - std::bit_cast<std::int32_t>(1.0f)) >> 16, 0, lod_max);
}

template <class Program>
struct RectangleSource {
    Program program;
    const FillPlan& plan;
    const SetUpRectangle& rectangle;
    const std::array<int, kMaxTextures>& lod;
    int block, lane, y;

    HWY_INLINE Pixels diffuse() const { return unpack(set(rectangle.color)); }
    HWY_INLINE Pixels specular() const { return unpack(set(Vertex{}.specular)); }
    template <int kStage>
    HWY_INLINE Pixels texel() const {
        const SetUpRectangle::Texture& texture = rectangle.textures[kStage];
        const std::int32_t step                = read_plane<kRectangleDrop>(texture.u.step);
        const auto at_lane = static_cast<std::uint32_t>(read_plane<kRectangleDrop>(texture.u.at(block))) +
                             static_cast<std::uint32_t>(lane) * static_cast<std::uint32_t>(step);
        return sample_row(texture_of<kStage>(program), plan.samplers[kStage], lod[kStage],
                          {static_cast<std::int32_t>(at_lane), step, read_plane<kRectangleDrop>(texture.v.at(y)) >> 8});
    }
};

// Program: OneProgram or AnyProgram.
template <class Program>
HWY_INLINE void fill_rectangle(Program program, const FillPlan& plan, const SetUpRectangle& rectangle, const Rect& tile,
                               const FillTarget& target, FillCounts& counts) {
    const Rect bounds = intersect(rectangle.bounds, tile);
    if (bounds.empty()) return;
    Counter counter;
    counter.covered =
        static_cast<std::uint64_t>(bounds.x1 - bounds.x0) * static_cast<std::uint64_t>(bounds.y1 - bounds.y0);
    std::array<int, kMaxTextures> lod{};
    for (int i = 0; i < kMaxTextures; ++i)
        if (program->textures[i].has_mips) lod[i] = rectangle_lod(rectangle.textures[i], plan.samplers[i].lod_max);
    const VU depth = set(program->depth_bits == 0 ? 0 : to_depth_format(rectangle.depth, program->depth_bits));

    for (int y = bounds.y0; y < bounds.y1; ++y)
        for (int block = bounds.x0 & -kBlockWidth; block < bounds.x1; block += kBlockWidth) {
            const unsigned covered = lanes_between(block, bounds.x0, bounds.x1);
            for (int lane = 0; lane < kBlockWidth; lane += lane_count()) {
                const unsigned bits = covered >> lane & all_lanes();
                if (bits == 0) continue;
                const Place place{target.color ? target.color->row(y) + block + lane : nullptr,
                                  target.depth ? target.depth->row(y) + block + lane : nullptr, lane, y};
                const auto depth_at = [depth]() NIMBUS7_LAMBDA { return depth; };
                MU mask             = mask_of(bits);
                if (program->tests_first()) {
                    mask = test_stored(program, place, depth_at, mask, mask, counter);
                    if (!program->makes_color || hn::AllFalse(DU(), mask)) continue;
                }
                const RectangleSource<Program> source{program, plan, rectangle, lod, block, lane, y};
                finish(program, plan, place, depth_at, make_color(program, plan, source), mask, counter);
            }
        }
    counter.add_to(counts, program, plan);
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#endif  // include guard
