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
// Texels of two rows in one vector each, or in two, one after the other: texel `from` and the next for each lane.
HWY_INLINE Quad look_up_window(const std::uint32_t* row0, const std::uint32_t* row1, VI from) {
    const auto left  = hn::IndicesFromVec(DU(), from);
    const auto right = hn::IndicesFromVec(DU(), hn::Add(from, seti(1)));
    const VU a = hn::LoadU(DU(), row0), b = hn::LoadU(DU(), row1);
    return {hn::TableLookupLanes(a, left), hn::TableLookupLanes(a, right), hn::TableLookupLanes(b, left),
            hn::TableLookupLanes(b, right)};
}
HWY_INLINE Quad look_up_wide_window(const std::uint32_t* row0, const std::uint32_t* row1, VI from) {
    const DU d;
    const VI next = hn::Add(from, seti(1));
    const VU a0 = hn::LoadU(d, row0), a1 = hn::LoadU(d, row0 + lane_count());
    const VU b0 = hn::LoadU(d, row1), b1 = hn::LoadU(d, row1 + lane_count());
#if HWY_TARGET <= HWY_AVX3
    const auto look_up = [](VU low, VU high, VI i)
                             NIMBUS7_LAMBDA { return VU{_mm512_permutex2var_epi32(low.raw, i.raw, high.raw)}; };
#else
    const auto look_up = [d](VU low, VU high, VI i) NIMBUS7_LAMBDA {
        const auto within = hn::IndicesFromVec(d, hn::And(i, seti(lane_count() - 1)));
        return hn::IfThenElse(hn::RebindMask(d, hn::Lt(i, seti(lane_count()))), hn::TableLookupLanes(low, within),
                              hn::TableLookupLanes(high, within));
    };
#endif
    return {look_up(a0, a1, from), look_up(a0, a1, next), look_up(b0, b1, from), look_up(b0, b1, next)};
}

// Two texels to the pixel.
HWY_INLINE Quad load_halved(const std::uint32_t* row0, const std::uint32_t* row1) {
    const DU d;
    const VU a0 = hn::LoadU(d, row0), a1 = hn::LoadU(d, row0 + lane_count());
    const VU b0 = hn::LoadU(d, row1), b1 = hn::LoadU(d, row1 + lane_count());
    return {hn::ConcatEven(d, a1, a0), hn::ConcatOdd(d, a1, a0), hn::ConcatEven(d, b1, b0), hn::ConcatOdd(d, b1, b0)};
}
#endif

// The same with all four weights alike: (a + b + c + d + 2) >> 2.
HWY_INLINE Pixels average_halved(const std::uint32_t* row0, const std::uint32_t* row1) {
#if HWY_TARGET <= HWY_AVX2
    // Of two texels next to each other blue with blue and red with red, in one word, and green and alpha in another, so
    // that sums of neighbouring bytes are pairs.
    alignas(16) static constexpr std::uint8_t kBeside[16] = {0, 4, 2, 6, 8, 12, 10, 14, 1, 5, 3, 7, 9, 13, 11, 15};
    const hn::Repartition<std::uint8_t, DU> bytes;
    const hn::Repartition<std::uint64_t, DU> two_words;
    const auto beside = hn::LoadDup128(bytes, kBeside);
    const auto sums   = [&](const std::uint32_t* texels) NIMBUS7_LAMBDA {
        const auto moved = hn::TableLookupBytes(hn::BitCast(bytes, hn::LoadU(DU(), texels)), beside);
#if HWY_TARGET <= HWY_AVX3
        return VU{_mm512_maddubs_epi16(moved.raw, _mm512_set1_epi8(1))};
#else
        return VU{_mm256_maddubs_epi16(moved.raw, _mm256_set1_epi8(1))};
#endif
    };
    const auto near    = hn::BitCast(two_words, add16(sums(row0), sums(row1)));
    const auto far     = hn::BitCast(two_words, add16(sums(row0 + lane_count()), sums(row1 + lane_count())));
    const auto quarter = [](auto sum)
                             NIMBUS7_LAMBDA { return shift_right16<2>(add16(hn::BitCast(DU(), sum), set_pair(2))); };
    return {quarter(hn::ConcatEven(two_words, far, near)), quarter(hn::ConcatOdd(two_words, far, near))};
#elif HWY_TARGET == HWY_SCALAR
    return average({set(row0[0]), set(row0[1]), set(row1[0]), set(row1[1])});
#else
    return average(load_halved(row0, row1));
#endif
}

// The rows of texels that a vector of lanes reads, from its first one on; false if they reach over the border.
struct TexelRows {
    const std::uint32_t *row0, *row1;
    int first, last;  // columns, less half a texel
};
HWY_INLINE bool find_rows(const SamplePlan::Level& level, const RowOfTexels& at, const Advance& advance,
                          TexelRows& rows) {
    const int first = (advance.first() - 128) >> 8, last = (advance.last() - 128) >> 8, j = (at.v - 128) >> 8;
    if (!advance.is_in_order() || first < 0 || j < 0 || j + 1 >= level.height || last + 1 >= level.width) return false;
    const std::uint32_t* const row = level.texels + static_cast<std::ptrdiff_t>(j) * level.stride + first;
    rows                           = {row, row + level.stride, first, last};
    return true;
}

// By contiguous loads; false for steps that these do not serve.
HWY_INLINE bool load_quad([[maybe_unused]] const SamplePlan::Level& level, [[maybe_unused]] const RowOfTexels& at,
                          const Advance& advance, const TexelRows& rows, Quad& quad) {
    if (advance.is_even(256)) {
        const DU d;
        quad = {hn::LoadU(d, rows.row0), hn::LoadU(d, rows.row0 + 1), hn::LoadU(d, rows.row1),
                hn::LoadU(d, rows.row1 + 1)};
        return true;
    }
#if HWY_TARGET != HWY_SCALAR
    if (advance.is_even(512)) {
        quad = load_halved(rows.row0, rows.row1);
        return true;
    }
    const int lanes = lane_count(), texels = rows.last + 2 - rows.first;
    if (texels <= 2 * lanes && rows.first + (texels <= lanes ? 1 : 2) * lanes <= level.width) {
        const VI from = hn::Sub(hn::ShiftRight<8>(hn::Sub(at.u(), seti(128))), seti(rows.first));
        quad          = texels <= lanes ? look_up_window(rows.row0, rows.row1, from)
                                        : look_up_wide_window(rows.row0, rows.row1, from);
        return true;
    }
#endif
    return false;
}

template <class Texture>
HWY_INLINE Pixels sample_linear_row(Texture program, const SamplePlan& plan, const RowOfTexels& at) {
    const SamplePlan::Level& level = plan.levels[0];
    const Advance advance(at);
    TexelRows rows{};
    if (program->alpha_quads || !find_rows(level, at, advance, rows))
        return sample(program, plan, at.u(), seti(at.v), nullptr);
    // Fractions of one half, and of quarters, along both axes.
    const bool is_even    = advance.is_even(256) || advance.is_even(512),
               is_single8 = program->rule == FilterRule::Single8;
    const bool halves     = is_single8 && is_even && ((advance.first() | at.v) & 255) == 0;
    const bool quarters   = is_single8 && is_even && ((advance.first() | at.v) & 63) == 0;
    if (halves && advance.is_even(512)) return average_halved(rows.row0, rows.row1);
    Quad quad;
    if (!load_quad(level, at, advance, rows, quad)) return sample(program, plan, at.u(), seti(at.v), nullptr);
    if (halves) return average(quad);
    const VI half = seti(128), u = hn::Sub(at.u(), half), v = hn::Sub(seti(at.v), half);
    if (quarters) return weigh_quarters(quad, u, v);
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

// The colour of one vector of lanes in any row.
template <class Program>
class RectangleSource {
  public:
    HWY_INLINE RectangleSource(Program program, const FillPlan& plan, const SetUpRectangle& rectangle, int block,
                               int lane)
        : program_(program), plan_(plan), rectangle_(rectangle) {
        for (int i = 0; i < kMaxTextures; ++i) {
            if (!program->textures[i].has_texels) continue;
            const SetUpRectangle::Texture& texture = rectangle.textures[i];
            step_[i]                               = read_plane<kRectangleDrop>(texture.u.step);
            start_[i] =
                static_cast<std::int32_t>(static_cast<std::uint32_t>(read_plane<kRectangleDrop>(texture.u.at(block))) +
                                          static_cast<std::uint32_t>(lane) * static_cast<std::uint32_t>(step_[i]));
            if (program->textures[i].has_mips) lod_[i] = rectangle_lod(texture, plan.samplers[i].lod_max);
        }
    }
    HWY_INLINE void enter_row(int y) { y_ = y; }

    HWY_INLINE Pixels diffuse() const { return unpack(set(rectangle_.color)); }
    HWY_INLINE Pixels specular() const { return unpack(set(Vertex{}.specular)); }
    template <int kStage>
    HWY_INLINE Pixels texel() const {
        const std::int32_t v = read_plane<kRectangleDrop>(rectangle_.textures[kStage].v.at(y_)) >> 8;
        return sample_row(texture_of<kStage>(program_), plan_.samplers[kStage], lod_[kStage],
                          {start_[kStage], step_[kStage], v});
    }

  private:
    Program program_;
    const FillPlan& plan_;
    const SetUpRectangle& rectangle_;
    std::array<std::int32_t, kMaxTextures> start_{}, step_{};
    std::array<int, kMaxTextures> lod_{};
    int y_ = 0;
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
    const VU depth      = set(program->depth_bits == 0 ? 0 : to_depth_format(rectangle.depth, program->depth_bits));
    const auto depth_at = [depth]() NIMBUS7_LAMBDA { return depth; };

    for (int block = bounds.x0 & -kBlockWidth; block < bounds.x1; block += kBlockWidth)
        for (int lane = 0; lane < kBlockWidth; lane += lane_count()) {
            const unsigned bits = lanes_between(block, bounds.x0, bounds.x1) >> lane & all_lanes();
            if (bits == 0) continue;
            RectangleSource<Program> source(program, plan, rectangle, block, lane);
            for (int y = bounds.y0; y < bounds.y1; ++y) {
                const int x = block + lane;
                const Place place{program->uses_color_target() ? target.color->row(y) + x : nullptr,
                                  program->depth_bits != 0 ? target.depth->row(y) + x : nullptr, lane, y};
                MU mask = mask_of(bits);
                if (program->tests_first()) {
                    mask = test_stored(program, place, depth_at, mask, mask, counter);
                    if (!program->makes_color || hn::AllFalse(DU(), mask)) continue;
                }
                source.enter_row(y);
                finish(program, plan, place, depth_at, make_color(program, plan, source), mask, counter);
            }
        }
    counter.add_to(counts, program, plan);
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#endif  // include guard
