// SPDX-License-Identifier: MIT
// The values that vary over a triangle, read a column of blocks at a time: 16 pixels by up to 16 rows. By the rules of
// raster/primitives.h a value at (row, lane) is the plane's at the row's first pixel plus `lane` steps: a sum of one
// number for each row and one for each lane.
// Highway's per-target include guard.
#if defined(NIMBUS7_RASTER_RAMPS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NIMBUS7_RASTER_RAMPS_INL_H_
#undef NIMBUS7_RASTER_RAMPS_INL_H_
#else
#define NIMBUS7_RASTER_RAMPS_INL_H_
#endif

#include "raster/fill_plan.h"
#include "raster/lanes-inl.h"
#include "raster/triangle_setup.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

// Modulo 2^32, or, of colours in pairs, 2^16 in either half.
struct Ramp {
    alignas(64) std::int32_t row[kColumnRows];
    alignas(64) std::int32_t lane[kBlockWidth];
};

// A vector of lanes of one row.
struct LanesOfRow {
    int row, lane;
    HWY_INLINE VI at(const Ramp& ramp) const { return hn::Add(seti(ramp.row[row]), hn::Load(DI(), ramp.lane + lane)); }
    HWY_INLINE VU pair_at(const Ramp& ramp) const {
        return add16(set(static_cast<std::uint32_t>(ramp.row[row])),
                     hn::BitCast(DU(), hn::Load(DI(), ramp.lane + lane)));
    }
};

// table[i], i in 0..15.
HWY_INLINE VI look_up(const std::int32_t* table, VI i) {
    static_assert(kColumnRows == 16 && kBlockWidth == 16);
#if HWY_TARGET <= HWY_AVX3
    return hn::TableLookupLanes(hn::Load(DI(), table), hn::IndicesFromVec(DI(), i));
#elif HWY_TARGET == HWY_AVX2
    const auto in_half = hn::IndicesFromVec(DI(), hn::And(i, seti(7)));
    return hn::IfThenElse(hn::Gt(i, seti(7)), hn::TableLookupLanes(hn::Load(DI(), table + 8), in_half),
                          hn::TableLookupLanes(hn::Load(DI(), table), in_half));
#else
    return hn::GatherIndex(DI(), table, i);
#endif
}

// Lanes from anywhere in the column, as 16 * row + lane.
struct LanesOfList {
    VI row, lane;
    explicit HWY_INLINE LanesOfList(const std::uint8_t* list) {
        const VI position = hn::PromoteTo(DI(), hn::LoadU(hn::Rebind<std::uint8_t, DI>(), list));
        row               = hn::ShiftRight<4>(position);
        lane              = hn::And(position, seti(kBlockWidth - 1));
    }
    HWY_INLINE VI at(const Ramp& ramp) const { return hn::Add(look_up(ramp.row, row), look_up(ramp.lane, lane)); }
    HWY_INLINE VU pair_at(const Ramp& ramp) const {
        return add16(hn::BitCast(DU(), look_up(ramp.row, row)), hn::BitCast(DU(), look_up(ramp.lane, lane)));
    }
};

// A plane at the first pixels of rows, one row to the lane: r(plane(x, y + row), S) of raster/primitives.h.
template <int S>
class RowStarts {
  public:
    HWY_INLINE RowStarts(const Plane& plane, int x, int y)
        : first_(plane.at(x, y) + (std::uint64_t{1} << (S - 1))), dy_(plane.dy) {}

    // Of a vector of rows, from `row` on.
    HWY_INLINE VI at(int row) const {
        const std::uint64_t first = first_ + dy_ * static_cast<std::uint64_t>(row);
        // The low 32 bits of a shift right are the same with and without sign.
#if HWY_TARGET == HWY_SCALAR
        return seti(static_cast<std::int32_t>(first >> S));
#else
        const D64 d;
        const auto words = [](auto v) NIMBUS7_LAMBDA { return hn::BitCast(DU(), v); };
        const auto iota = hn::Iota(d, 0), dy = hn::Set(d, dy_);
        const auto low  = hn::MulEven(words(dy), words(iota));
        const auto high = hn::MulEven(words(hn::ShiftRight<32>(dy)), words(iota));
        const auto near = hn::Add(hn::Set(d, first), hn::Add(low, hn::ShiftLeft<32>(high)));
        const auto far  = hn::Add(near, hn::Set(d, dy_ * hn::Lanes(d)));
        const auto half = [](auto v) NIMBUS7_LAMBDA { return hn::TruncateTo(hn::Half<DU>(), hn::ShiftRight<S>(v)); };
        return hn::BitCast(DI(), hn::Combine(DU(), half(far), half(near)));
#endif
    }

  private:
#if HWY_TARGET != HWY_SCALAR
    using D64 = hn::Repartition<std::uint64_t, DU>;
#endif
    std::uint64_t first_, dy_;
};

template <int S>
HWY_INLINE void start_rows(const Plane& plane, int x, int y, int rows, std::int32_t* out) {
    const RowStarts<S> starts(plane, x, y);
    for (int row = 0; row < rows; row += lane_count()) hn::Store(starts.at(row), DI(), out + row);
}

template <int S>
HWY_INLINE void start_lanes(const Plane& plane, std::int32_t* out) {
    const VI step = seti(read_plane<S>(plane.dx));
    for (int lane = 0; lane < kBlockWidth; lane += lane_count())
        hn::Store(hn::Mul(lane_index(lane), step), DI(), out + lane);
}

// A plane of bytes at the first pixels of rows, in 8.7 fixed point, half a unit added: in the high half of each lane, with
// anything below. No more than 32 bits of the plane have a part in that.
class ByteRowStarts {
  public:
    HWY_INLINE ByteRowStarts(const Plane& plane, int x, int y)
        : first_(static_cast<std::uint32_t>(plane.at(x, y)) + (64u << kColorDrop) + (1u << (kColorDrop - 1))),
          dy_(static_cast<std::uint32_t>(plane.dy)) {}
    HWY_INLINE VU at(int row) const {
        return hn::Add(set(first_), hn::Mul(hn::BitCast(DU(), lane_index(row)), set(dy_)));
    }

  private:
    static_assert(kColorDrop == 16);
    std::uint32_t first_, dy_;
};

// Two such planes as a ramp of pairs; or one, with anything in the low half.
HWY_INLINE void color_pair_rows(const Plane& low, const Plane& high, int x, int y, int rows, std::int32_t* out) {
    const ByteRowStarts a(low, x, y), b(high, x, y);
    for (int row = 0; row < rows; row += lane_count()) {
        const VU pair = hn::Or(hn::ShiftRight<16>(a.at(row)), hn::And(b.at(row), set(0xffff0000)));
        hn::Store(hn::BitCast(DI(), pair), DI(), out + row);
    }
}
HWY_INLINE void color_high_rows(const Plane& high, int x, int y, int rows, std::int32_t* out) {
    const ByteRowStarts starts(high, x, y);
    for (int row = 0; row < rows; row += lane_count()) hn::Store(hn::BitCast(DI(), starts.at(row)), DI(), out + row);
}
HWY_INLINE void color_pair_lanes(const Plane& low, const Plane& high, std::int32_t* out) {
    const std::uint32_t a = static_cast<std::uint32_t>(read_plane<kColorDrop>(low.dx)) & 0xffff;
    const std::uint32_t b = static_cast<std::uint32_t>(read_plane<kColorDrop>(high.dx));
    for (int lane = 0; lane < kBlockWidth; lane += lane_count())
        hn::Store(hn::BitCast(DI(), mul16(lane_index_pair(lane), set(a | b << 16))), DI(), out + lane);
}

HWY_INLINE void fill_ramp(std::int32_t value, std::int32_t* out) {
    for (int i = 0; i < kBlockWidth; i += lane_count()) hn::Store(seti(value), DI(), out + i);
}

// Which bytes of a colour are wanted: all or alpha alone; and how they become bytes, see FillState::floor_colors.
struct ColorUse {
    bool floors = false, alpha_only = false;
};

// Four bytes that vary: as pairs, blue with red and green with alpha; or, with `floors`, one by one.
class ColorRamps {
  public:
    HWY_INLINE void enter_triangle(ColorUse use, bool varies, std::uint32_t flat, const std::array<Plane, 4>& planes) {
        varies_ = varies;
        if (use.floors) {
            for (int channel = use.alpha_only ? 3 : 0; channel < 4; ++channel) {
                if (varies) {
                    start_lanes<kColorDrop>(planes[channel], ramps_[channel].lane);
                } else {
                    fill_ramp(0, ramps_[channel].lane);
                    fill_ramp(static_cast<std::int32_t>((flat >> 8 * channel & 255) << 15), ramps_[channel].row);
                }
            }
            return;
        }
        for (int half = use.alpha_only ? 1 : 0; half < 2; ++half) {
            if (varies) {
                color_pair_lanes(planes[half], planes[half + 2], ramps_[half].lane);
            } else {
                fill_ramp(0, ramps_[half].lane);
                fill_ramp(static_cast<std::int32_t>((flat >> 8 * half & 0x00ff00ff) << 7), ramps_[half].row);
            }
        }
    }
    HWY_INLINE void enter_column(ColorUse use, const std::array<Plane, 4>& planes, int x, int y, int rows) {
        if (!varies_) return;
        if (use.floors) {
            for (int channel = use.alpha_only ? 3 : 0; channel < 4; ++channel)
                start_rows<kColorDrop>(planes[channel], x, y, rows, ramps_[channel].row);
            return;
        }
        if (use.alpha_only) return color_high_rows(planes[3], x, y, rows, ramps_[1].row);
        for (int half = 0; half < 2; ++half)
            color_pair_rows(planes[half], planes[half + 2], x, y, rows, ramps_[half].row);
    }
    template <class Lanes>
    HWY_INLINE Pixels at(ColorUse use, const Lanes& lanes) const {
        if (!use.floors) {
            // Bytes wherever the triangle is.
            const auto pair = [&](int half) NIMBUS7_LAMBDA { return shift_right16<7>(lanes.pair_at(ramps_[half])); };
            return {use.alpha_only ? set(0) : pair(0), pair(1)};
        }
        const auto channel = [&](int index) NIMBUS7_LAMBDA {
            const VI byte = hn::ShiftRight<15>(hn::Add(lanes.at(ramps_[index]), seti(128)));
            return hn::BitCast(DU(), hn::Min(hn::Max(byte, seti(0)), seti(255)));
        };
        const VU alpha = hn::ShiftLeft<16>(channel(3));
        if (use.alpha_only) return {set(0), alpha};
        return {hn::Or(channel(0), hn::ShiftLeft<16>(channel(2))), hn::Or(channel(1), alpha)};
    }

  private:
    Ramp ramps_[4];
    bool varies_ = false;
};

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#endif  // include guard
