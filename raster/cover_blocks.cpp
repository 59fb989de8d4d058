// SPDX-License-Identifier: MIT
#include "raster/cover_blocks.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/cover_blocks.cpp"
#include "hwy/foreach_target.h"
#include "raster/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raster {
namespace HWY_NAMESPACE {

// Keeps the block whose mask was just written, if a pixel is in.
HWY_INLINE void keep_block(int x, int y, int inside, FragmentBatch& batch, std::uint64_t& covered) {
    if (inside == 0) return;
    batch.at[batch.count] = {x, y};
    ++batch.count;
    covered += static_cast<std::uint64_t>(inside);
}

int cover_triangle(const TileEdges& edges, int y, FragmentBatch& batch, std::uint64_t& covered) {
    const int first_x       = edges.bounds.x0 & ~(kBlockWidth - 1);
    const int blocks_in_row = (edges.bounds.x1 - first_x + kBlockWidth - 1) / kBlockWidth;
    const VI before_x = seti(edges.bounds.x0 - 1), end_x = seti(edges.bounds.x1);
    // What an edge gains from the first lane of a block to each of the others.
    alignas(64) std::int32_t gain[3][kBlockWidth];
    for (int i = 0; i < 3; ++i)
        for (int lane = 0; lane < kBlockWidth; lane += lane_count())
            hn::Store(hn::Mul(lane_index(lane), seti(edges.a[i])), DI(), gain[i] + lane);

    batch.count = 0;
    for (; y < edges.bounds.y1 && batch.count + blocks_in_row <= kBatchBlocks; ++y) {
        for (int x = first_x; x < edges.bounds.x1; x += kBlockWidth) {
            std::int32_t start[3], outside = 0;
            for (int i = 0; i < 3; ++i) {
                start[i] = edges.e[i] + edges.a[i] * (x - edges.x) + edges.b[i] * (y - edges.y);
                // An edge that is negative at both ends of the block is so between them.
                outside |= start[i] & (start[i] + gain[i][kBlockWidth - 1]);
            }
            if (outside < 0) continue;
            std::uint32_t* mask = batch.mask[batch.count];
            int inside          = 0;
            for (int lane = 0; lane < kBlockWidth; lane += lane_count()) {
                const auto edge = [&](int i)
                                      HWY_ATTR { return hn::Add(seti(start[i]), hn::Load(DI(), gain[i] + lane)); };
                // The sign bit of the sum of bits is set if any edge is negative.
                const VI any_outside = hn::Or(edge(0), hn::Or(edge(1), edge(2)));
                const VI px          = hn::Add(lane_index(lane), seti(x));
                const auto in =
                    hn::And(hn::Gt(any_outside, seti(-1)), hn::And(hn::Gt(px, before_x), hn::Lt(px, end_x)));
                hn::Store(hn::BitCast(DU(), hn::VecFromMask(DI(), in)), DU(), mask + lane);
                inside += static_cast<int>(hn::CountTrue(DI(), in));
            }
            keep_block(x, y, inside, batch, covered);
        }
    }
    return y;
}

int cover_rectangle(const Rect& bounds, int y, FragmentBatch& batch, std::uint64_t& covered) {
    const int first_x       = bounds.x0 & ~(kBlockWidth - 1);
    const int blocks_in_row = (bounds.x1 - first_x + kBlockWidth - 1) / kBlockWidth;
    batch.count             = 0;
    for (; y < bounds.y1 && batch.count + blocks_in_row <= kBatchBlocks; ++y) {
        for (int x = first_x; x < bounds.x1; x += kBlockWidth) {
            std::uint32_t* mask = batch.mask[batch.count];
            for (int lane = 0; lane < kBlockWidth; lane += lane_count()) {
                const VI px   = hn::Add(lane_index(lane), seti(x));
                const auto in = hn::And(hn::Gt(px, seti(bounds.x0 - 1)), hn::Lt(px, seti(bounds.x1)));
                hn::Store(hn::BitCast(DU(), hn::VecFromMask(DI(), in)), DU(), mask + lane);
            }
            const int inside = std::min(x + kBlockWidth, bounds.x1) - std::max(x, bounds.x0);
            keep_block(x, y, inside, batch, covered);
        }
    }
    return y;
}

CoverKernels get_cover_kernels() {
    return {&cover_triangle, &cover_rectangle};
}

}  // namespace HWY_NAMESPACE
}  // namespace raster
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raster {

HWY_EXPORT(get_cover_kernels);
CoverKernels cover_kernels() {
    return HWY_DYNAMIC_DISPATCH(get_cover_kernels)();
}

bool enter_tile(const SetUpTriangle& triangle, const Rect& tile, TileEdges& out) {
    out.bounds = intersect(triangle.bounds, tile);
    if (out.bounds.empty()) return false;
    out.x = tile.x0;
    out.y = tile.y0;
    for (int i = 0; i < 3; ++i) {
        const Edge& edge          = triangle.edges[i];
        const std::int64_t across = edge.a * (kTileWidth - 1), down = edge.b * (kTileHeight - 1);
        const std::int64_t e    = edge.at(tile.x0, tile.y0);
        const std::int64_t low  = e + std::min<std::int64_t>(across, 0) + std::min<std::int64_t>(down, 0);
        const std::int64_t high = e + std::max<std::int64_t>(across, 0) + std::max<std::int64_t>(down, 0);
        if (high < 0) return false;
        const bool crosses = low < 0;
        out.e[i]           = crosses ? static_cast<std::int32_t>(e) : 0;
        out.a[i]           = crosses ? static_cast<std::int32_t>(edge.a) : 0;
        out.b[i]           = crosses ? static_cast<std::int32_t>(edge.b) : 0;
    }
    return true;
}

}  // namespace raster
#endif
