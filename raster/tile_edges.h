// SPDX-License-Identifier: MIT
// A triangle's edge functions within one tile, small enough for 32 bits.
#pragma once

#include <array>
#include <cstdint>

#include "raster/tile.h"
#include "raster/triangle_setup.h"

namespace raster {

// An edge that has all of the tile inside is 0 everywhere. One that crosses it stays below 2^26.
struct TileEdges {
    Rect bounds;                                // of what may be covered, within the tile
    int x = 0, y = 0;                           // the tile's first pixel
    std::array<std::int32_t, 3> e{}, a{}, b{};  // value there, and its steps
};

// False if nothing in the tile can be covered.
bool enter_tile(const SetUpTriangle& triangle, const Rect& tile, TileEdges& out);

}  // namespace raster
