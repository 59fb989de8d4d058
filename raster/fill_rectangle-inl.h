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

#include "raster/box-inl.h"
#include "raster/cover-inl.h"
#include "raster/fill_aligned-inl.h"
#include "raster/sampling-inl.h"
#include "raster/shade-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

// The columns of texels that a vector of lanes reads, the same in every row. u of a lane is (start + lane * step) >> 8
// modulo 2^24, in 1/256 texel.
class Columns {
  public:
    // How a linear sample gets at its texels.
    enum class Way : std::uint8_t { Gather, Beside, Halved, Window, WideWindow };

    HWY_INLINE Columns(const TextureProgram& program, std::int32_t start, std::int32_t step, int width)
        : start_(start), step_(step) {
        if (program.address_u == Address::Wrap && !program.has_mips)
            start_ = into_first_repeat(start, width, program.linear);
        const std::int64_t last_u = start_ + std::int64_t{step} * (lane_count() - 1);
        first_u_                  = start_ >> 8;
        last_u_                   = static_cast<std::int32_t>(last_u) >> 8;
        is_in_order_              = step >= 0 && last_u == static_cast<std::int32_t>(last_u);
        way_                      = way(width);
    }
    HWY_INLINE VI u() const { return hn::ShiftRight<8>(hn::Add(seti(start_), hn::Mul(lane_index(0), seti(step_)))); }
    HWY_INLINE Way way() const { return way_; }
    // Of the first lane: its u, and the left one of the two columns that it reads if linear.
    HWY_INLINE int first_u() const { return first_u_; }
    HWY_INLINE int first() const { return (first_u_ - 128) >> 8; }
    // Does u gain exactly `step` with each lane? Its gains are the floor of the same number, or one more.
    HWY_INLINE bool is_even(int step) const {
        const int gain = step_ >> 8;
        return is_in_order_ && (gain == step || gain == step - 1) && last_u_ - first_u_ == step * (lane_count() - 1);
    }

  private:
    // Less so many widths that the leftmost column that is read is one of the texture's own.
    static HWY_INLINE std::int32_t into_first_repeat(std::int32_t start, int width, bool linear) {
        const int column = ((start >> 8) - (linear ? 128 : 0)) >> 8;
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(start) -
                                         (static_cast<std::uint32_t>(column & -width) << 16));
    }
    HWY_INLINE Way way(int width) const {
        const int last = (last_u_ - 128) >> 8;
        if (!is_in_order_ || first() < 0 || last + 1 >= width) return Way::Gather;
        if (is_even(256)) return Way::Beside;
#if HWY_TARGET != HWY_SCALAR
        if (is_even(512)) return Way::Halved;
        const int lanes = lane_count(), texels = last + 2 - first();
        if (texels <= lanes && first() + lanes <= width) return Way::Window;
        if (texels <= 2 * lanes && first() + 2 * lanes <= width) return Way::WideWindow;
#endif
        return Way::Gather;
    }

    std::int32_t start_, step_;
    int first_u_, last_u_;
    bool is_in_order_;
    Way way_;
};

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

// By contiguous loads, not to be asked of Way::Gather.
HWY_INLINE Quad load_quad(const std::uint32_t* row0, const std::uint32_t* row1, const Columns& columns) {
    const DU d;
#if HWY_TARGET != HWY_SCALAR
    const auto from = [&]() NIMBUS7_LAMBDA {
        return hn::Sub(hn::ShiftRight<8>(hn::Sub(columns.u(), seti(128))), seti(columns.first()));
    };
    switch (columns.way()) {
        case Columns::Way::Gather:
        case Columns::Way::Beside:
            break;
        case Columns::Way::Halved:
            return load_halved(row0, row1);
        case Columns::Way::Window:
            return look_up_window(row0, row1, from());
        case Columns::Way::WideWindow:
            return look_up_wide_window(row0, row1, from());
    }
#endif
    (void)columns;
    return {hn::LoadU(d, row0), hn::LoadU(d, row0 + 1), hn::LoadU(d, row1), hn::LoadU(d, row1 + 1)};
}

template <class Texture>
HWY_INLINE const std::uint32_t* texel_row(Texture program, const SamplePlan::Level& level, int j) {
    return level.texels + static_cast<std::ptrdiff_t>(address(program->address_v, j, level.last_row)) * level.stride;
}

// v: of the row, in 1/256 texel.
template <class Texture>
HWY_INLINE Pixels sample_linear_row(Texture program, const SamplePlan& plan, const Columns& columns, std::int32_t v) {
    using Way                      = Columns::Way;
    const SamplePlan::Level& level = plan.levels[0];
    const int j                    = (v - 128) >> 8;
    if (program->alpha_quads || columns.way() == Way::Gather)
        return sample(program, plan, columns.u(), seti(v), nullptr);
    const std::uint32_t* const row0 = texel_row(program, level, j) + columns.first();
    const std::uint32_t* const row1 = texel_row(program, level, j + 1) + columns.first();
    if (program->rule == FilterRule::Single8 && (columns.way() == Way::Beside || columns.way() == Way::Halved)) {
        // Fractions of one half, or of quarters, along both axes.
        const int bits = columns.first_u() | v;
        if ((bits & 255) == 0)
            return unpack(columns.way() == Way::Halved ? mean_halved(row0, row1)
                                                       : mean(load_quad(row0, row1, columns)));
        if ((bits & 63) == 0) {
            const VI half = seti(128);
            return weigh_quarters(load_quad(row0, row1, columns), hn::Sub(columns.u(), half), hn::Sub(seti(v), half));
        }
    }
    const VI half = seti(128);
    return with_filter(program, [&](auto filter) NIMBUS7_LAMBDA {
        using Filter = decltype(filter);
        if constexpr (Filter::kLinear)
            return Filter::weigh_quad(load_quad(row0, row1, columns), hn::Sub(columns.u(), half),
                                      hn::Sub(seti(v), half));
        else
            return Pixels{set(0), set(0)};  // not for such a program
    });
}

template <class Texture>
HWY_INLINE Pixels sample_point_row(Texture program, const SamplePlan& plan, const Columns& columns, std::int32_t v) {
    const SamplePlan::Level& level = plan.levels[0];
    const int i                    = columns.first_u() >> 8;
    if (columns.is_even(256) && i >= 0 && i + lane_count() <= level.width)
        return unpack(hn::LoadU(DU(), texel_row(program, level, v >> 8) + i));
    return sample(program, plan, columns.u(), seti(v), nullptr);
}

template <class Texture>
HWY_INLINE Pixels sample_row(Texture program, const SamplePlan& plan, const Columns& columns, std::int32_t v, int lod) {
    if (program->has_mips) {
        alignas(64) std::int32_t lods[kBlockWidth];
        hn::Store(seti(lod), DI(), lods);
        return sample(program, plan, columns.u(), seti(v), lods);
    }
    return program->linear ? sample_linear_row(program, plan, columns, v) : sample_point_row(program, plan, columns, v);
}

// In 1/256 level, by raster/sampling_rules.h.
HWY_INLINE int rectangle_lod(const SetUpRectangle::Texture& texture, int lod_max) {
    const float rho2 = std::max(texture.ux * texture.ux, texture.vy * texture.vy);
    return std::clamp((std::bit_cast<std::int32_t>(rho2) - std::bit_cast<std::int32_t>(1.0f)) >> 16, 0, lod_max);
}

// Where a vector of lanes reads one texture.
struct RectangleTexture {
    Columns columns;
    int lod = 0;

    HWY_INLINE RectangleTexture(const TextureProgram& program, const SamplePlan& plan,
                                const SetUpRectangle::Texture& texture, int block, int lane)
        : columns(program, start(texture, block, lane), read_plane<kRectangleDrop>(texture.u.step),
                  plan.levels[0].width) {
        if (program.has_mips) lod = rectangle_lod(texture, plan.lod_max);
    }

  private:
    static HWY_INLINE std::int32_t start(const SetUpRectangle::Texture& texture, int block, int lane) {
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(read_plane<kRectangleDrop>(texture.u.at(block))) +
                                         static_cast<std::uint32_t>(lane) *
                                             static_cast<std::uint32_t>(read_plane<kRectangleDrop>(texture.u.step)));
    }
};

// The colour of one vector of lanes in any row.
template <class Program>
class RectangleSource {
  public:
    HWY_INLINE RectangleSource(Program program, const FillPlan& plan, const SetUpRectangle& rectangle, int block,
                               int lane)
        : program_(program),
          plan_(plan),
          rectangle_(rectangle),
          diffuse_(unpack(set(rectangle.color))),
          textures_{{program->textures[0], plan.samplers[0], rectangle.textures[0], block, lane},
                    {program->textures[1], plan.samplers[1], rectangle.textures[1], block, lane}} {}
    HWY_INLINE void enter_row(int y) { y_ = y; }

    HWY_INLINE Pixels diffuse() const { return diffuse_; }
    HWY_INLINE Pixels specular() const { return unpack(set(Vertex{}.specular)); }
    template <int kStage>
    HWY_INLINE Pixels texel() const {
        const std::int32_t v = read_plane<kRectangleDrop>(rectangle_.textures[kStage].v.at(y_)) >> 8;
        return sample_row(texture_of<kStage>(program_), plan_.samplers[kStage], textures_[kStage].columns, v,
                          textures_[kStage].lod);
    }

  private:
    Program program_;
    const FillPlan& plan_;
    const SetUpRectangle& rectangle_;
    Pixels diffuse_;
    RectangleTexture textures_[kMaxTextures];
    int y_ = 0;
};

template <class Program>
HWY_INLINE Place first_place(Program program, const FillTarget& target, int block, int lane, int y) {
    const int x = block + lane;
    return {program->uses_color_target() ? target.color->row(y) + x : nullptr,
            program->depth_bits != 0 ? target.depth->row(y) + x : nullptr, lane, y};
}

// Program: OneProgram or AnyProgram.
template <class Program>
HWY_INLINE void fill_rectangle(Program program, const FillPlan& plan, const SetUpRectangle& rectangle, const Rect& tile,
                               const FillTarget& target, const TileWork& work) {
    const Rect bounds = intersect(rectangle.bounds, tile);
    if (bounds.empty()) return;
    Counter counter;
    counter.is_asked = work.counts != nullptr;
    counter.covered =
        static_cast<std::uint64_t>(bounds.x1 - bounds.x0) * static_cast<std::uint64_t>(bounds.y1 - bounds.y0);
    const VU depth      = set(program->depth_bits == 0 ? 0 : to_depth_format(rectangle.depth, program->depth_bits));
    const auto depth_at = [depth]() NIMBUS7_LAMBDA { return depth; };
    const std::ptrdiff_t stride = (target.color ? target.color : target.depth)->stride();
    const Rect filled           = fill_aligned(program, plan, rectangle, bounds, target);

    for (int block = bounds.x0 & -kBlockWidth; block < bounds.x1; block += kBlockWidth)
        for (int lane = 0; lane < kBlockWidth; lane += lane_count()) {
            const unsigned bits = lanes_between(block, bounds.x0, bounds.x1) >> lane & all_lanes();
            if (bits == 0 || (block + lane >= filled.x0 && block + lane < filled.x1)) continue;
            RectangleSource<Program> source(program, plan, rectangle, block, lane);
            const MU covered = mask_of(bits);
            Place place      = first_place(program, target, block, lane, bounds.y0);
            for (; place.y < bounds.y1; ++place.y) {
                MU mask = covered;
                if (program->tests_first()) mask = test_stored(program, place, depth_at, mask, mask, counter);
                if (program->makes_color && !(program->tests_first() && hn::AllFalse(DU(), mask))) {
                    source.enter_row(place.y);
                    finish(program, plan, place, depth_at, make_color(program, plan, source), mask, counter);
                }
                if (program->uses_color_target()) place.color += stride;
                if (program->depth_bits != 0) place.depth += stride;
            }
        }
    if (work.counts) counter.add_to(*work.counts, program, plan);
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#endif  // include guard
