// SPDX-License-Identifier: MIT
// Kernels: which pixels of a tile a primitive covers, as blocks with a mask. Blocks without a covered pixel are left out.
#pragma once

#include <array>
#include <cstdint>

#include "raster/fragment_batch.h"
#include "raster/triangle_setup.h"

namespace raster {

// A triangle seen from one tile. Edges that hold for the whole tile are all zero, the others fit 32 bits: such an edge crosses
// the tile, so within it |e| <= 64 |a| + 32 |b| < 2^26.
struct TileEdges {
    Rect bounds;                                // of what may be covered, within the tile
    int x = 0, y = 0;                           // the tile's first pixel
    std::array<std::int32_t, 3> e{}, a{}, b{};  // value there, and its steps
};

// False if an edge rules the whole tile out.
bool enter_tile(const SetUpTriangle& triangle, const Rect& tile, TileEdges& out);

// Both fill the batch with rows from `y` on and return the row to go on with; bounds.y1 when done. Adds to `covered`.
struct CoverKernels {
    int (*triangle)(const TileEdges& edges, int y, FragmentBatch& batch, std::uint64_t& covered);
    int (*rectangle)(const Rect& bounds, int y, FragmentBatch& batch, std::uint64_t& covered);
};
CoverKernels cover_kernels();  // for this processor

}  // namespace raster
