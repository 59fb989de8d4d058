// SPDX-License-Identifier: MIT
#include "raster/tile_edges.h"

#include <algorithm>

namespace raster {

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
