// SPDX-License-Identifier: MIT
// Which pixels of a column of blocks, 16 pixels by up to 16 rows, a triangle covers.
// Highway's per-target include guard.
#if defined(NIMBUS7_RASTER_COVER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NIMBUS7_RASTER_COVER_INL_H_
#undef NIMBUS7_RASTER_COVER_INL_H_
#else
#define NIMBUS7_RASTER_COVER_INL_H_
#endif

#include <algorithm>

#include "raster/lanes-inl.h"
#include "raster/tile_edges.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

// Lanes of the block at x that lie within [x0, x1).
HWY_INLINE unsigned lanes_between(int x, int x0, int x1) {
    const unsigned from = x0 > x ? 0xffffu << (x0 - x) : 0xffffu;
    const unsigned to   = x1 < x + kBlockWidth ? 0xffffu >> (x + kBlockWidth - x1) : 0xffffu;
    return from & to & 0xffff;
}

class ColumnCover {
  public:
    explicit HWY_INLINE ColumnCover(const TileEdges& edges) : edges_(edges) {
        // What an edge gains from the first lane of a block to each of the others.
        for (int i = 0; i < 3; ++i)
            for (int lane = 0; lane < kBlockWidth; lane += lane_count())
                hn::Store(hn::Mul(lane_index(lane), seti(edges.a[i])), DI(), gain_[i] + lane);
    }

    // The column at (x, y), y the first of `rows`: a bit for each row that may have pixels in.
    HWY_INLINE unsigned enter(int x, int y, int rows) {
        first_lane_ = std::max(edges_.bounds.x0 - x, 0) & -lane_count();
        end_lane_   = std::min(edges_.bounds.x1 - x, kBlockWidth);
        for (int lane = first_lane_; lane < end_lane_; lane += lane_count()) {
            const VI before = hn::Sub(lane_index(lane), seti(edges_.bounds.x0 - x));
            const VI behind = hn::Sub(seti(edges_.bounds.x1 - 1 - x), lane_index(lane));
            hn::Store(hn::Or(before, behind), DI(), beyond_ + lane);
        }
        unsigned outside = 0, crossed = 0;
        for (int row = 0; row < rows; row += lane_count()) {
            VI both = seti(0), either = seti(0);
            for (int i = 0; i < 3; ++i) {
                const VI down = hn::Mul(lane_index(row), seti(edges_.b[i]));
                const VI left =
                    hn::Add(seti(edges_.e[i] + edges_.a[i] * (x - edges_.x) + edges_.b[i] * (y - edges_.y)), down);
                const VI right = hn::Add(left, seti(gain_[i][kBlockWidth - 1]));
                hn::Store(left, DI(), start_[i] + row);
                // An edge that is negative at both ends of a block is so between them, and likewise if it is not.
                both   = hn::Or(both, hn::And(left, right));
                either = hn::Or(either, hn::Or(left, right));
            }
            const auto negative = [](VI v) NIMBUS7_LAMBDA { return bits_of(hn::RebindMask(DU(), hn::Lt(v, seti(0)))); };
            outside |= negative(both) << row;
            crossed |= negative(either) << row;
        }
        crossed_ = crossed;
        return ~outside & ((1u << rows) - 1);
    }

    // The pixels of a vector of lanes. Those from first_lane() up to end_lane() have all that is covered in any row.
    HWY_INLINE MU lanes(int row, int lane) const {
        // The sign bit of a sum of bits is set where that of any is.
        VI any_outside = hn::Load(DI(), beyond_ + lane);
        if (crossed_ >> row & 1) {
            const auto edge = [&](int i) NIMBUS7_LAMBDA {
                return hn::Add(seti(start_[i][row]), hn::Load(DI(), gain_[i] + lane));
            };
            any_outside = hn::Or(hn::Or(any_outside, edge(0)), hn::Or(edge(1), edge(2)));
        }
        return hn::RebindMask(DU(), hn::Gt(any_outside, seti(-1)));
    }
    HWY_INLINE int first_lane() const { return first_lane_; }
    HWY_INLINE int end_lane() const { return end_lane_; }

  private:
    const TileEdges& edges_;
    unsigned crossed_ = 0;
    int first_lane_ = 0, end_lane_ = 0;
    alignas(64) std::int32_t beyond_[kBlockWidth];  // negative where a lane is not within the bounds
    alignas(64) std::int32_t gain_[3][kBlockWidth];
    alignas(64) std::int32_t start_[3][kColumnRows];
};

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#endif  // include guard
