// SPDX-License-Identifier: MIT
// The pixel grid. Window space is in pixels, x right, y down; pixel (0, 0) covers [0, 1) x [0, 1); where
// in it a primitive is sampled is a pass's choice (PixelGrid in raster/primitives.h). Rectangles are half-open. A *block* is 16 x 1 pixels starting at a multiple of 16: one cache line
// of four-byte pixels, and the grid on which every interpolated value is defined, so that neither the width of a
// vector, the tile nor the thread can change a bit. A *tile* is what one thread fills while it stays in the L1 cache.
#pragma once

#include <algorithm>

namespace raster {

inline constexpr int kBlockWidth = 16;
inline constexpr int kColumnRows = 16;  // rows of blocks, one below the other, that a triangle is filled by at a time
inline constexpr int kTileWidth  = 64;
inline constexpr int kTileHeight = 32;
static_assert(kTileWidth % kBlockWidth == 0);

struct Rect {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    constexpr bool empty() const { return x0 >= x1 || y0 >= y1; }
    bool operator==(const Rect&) const = default;
};

constexpr Rect intersect(const Rect& a, const Rect& b) {
    return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

}  // namespace raster
