// SPDX-License-Identifier: MIT
// Which triangles cannot show in a tile, found by a look at what is there: a small part of what it costs to fill them.
// Highway's per-target include guard.
#if defined(NIMBUS7_RASTER_HIDDEN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NIMBUS7_RASTER_HIDDEN_INL_H_
#undef NIMBUS7_RASTER_HIDDEN_INL_H_
#else
#define NIMBUS7_RASTER_HIDDEN_INL_H_
#endif

#include "raster/fill_plan.h"
#include "raster/lanes-inl.h"
#include "raster/tests-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

// Does every one of these pixels hold a depth less than this one, or as great where that fails too? Pixels beside them are
// looked at as well, as far as vectors reach. The answer may only be no where it could be yes.
template <class Program>
HWY_INLINE bool is_behind(Program program, std::uint32_t depth, const Rect& pixels, const Image& there) {
    const bool or_equal  = program->depth_func == Compare::Less;
    const auto is_nearer = [&](std::uint32_t stored) { return or_equal ? stored <= depth : stored < depth; };
    // Mostly the first look will do.
    if (!is_nearer(there.row((pixels.y0 + pixels.y1) / 2)[(pixels.x0 + pixels.x1) / 2])) return false;
    VU greatest   = set(0);
    const int end = pixels.x1;
    for (int y = pixels.y0; y < pixels.y1; ++y) {
        const std::uint32_t* const row = there.row(y);
        for (int x = pixels.x0 & -lane_count(); x < end; x += lane_count())
            greatest = hn::Max(greatest, hn::Load(DU(), row + x));
    }
    return is_nearer(hn::GetLane(hn::MaxOfLanes(DU(), greatest)));
}

// pixels: of the triangle's bounds, those within the tile; not empty.
template <class Program>
HWY_INLINE bool is_hidden(Program program, const SetUpTriangle& triangle, const Rect& pixels, const FillTarget& target,
                          const TileWork& work) {
    if (program->is_last_word() && work.settled && work.settled->has(pixels)) return true;
    if (!program->fails_behind()) return false;
    const std::uint32_t nearest = to_depth_format(static_cast<std::uint32_t>(triangle.depth_min), program->depth_bits);
    return is_behind(program, nearest, pixels, *target.depth);
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#endif  // include guard
