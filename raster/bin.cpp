// SPDX-License-Identifier: MIT
#include "raster/bin.h"

#include <algorithm>

namespace raster {

TileGrid::TileGrid(const Rect& area) : area_(area) {
    if (area.empty()) return;
    x0_      = area.x0 / kTileWidth;
    y0_      = area.y0 / kTileHeight;
    columns_ = (area.x1 - 1) / kTileWidth - x0_ + 1;
    rows_    = (area.y1 - 1) / kTileHeight - y0_ + 1;
}

Rect TileGrid::tile(int index) const {
    const int x = first_x(index % columns_), y = first_y(index / columns_);
    return intersect({x, y, x + kTileWidth, y + kTileHeight}, area_);
}

Rect TileGrid::tiles_touched(const Rect& pixels) const {
    return {pixels.x0 / kTileWidth - x0_, pixels.y0 / kTileHeight - y0_, (pixels.x1 - 1) / kTileWidth - x0_ + 1,
            (pixels.y1 - 1) / kTileHeight - y0_ + 1};
}

void Bin::add(const Command& command, const Rect& pixels, const TileGrid& grid) {
    const Rect tiles = grid.tiles_touched(pixels);
    for (int row = tiles.y0; row < tiles.y1; ++row)
        for (int column = tiles.x0; column < tiles.x1; ++column)
            entries_.push_back({grid.index(column, row), &command});
}

void Bin::add(const Command& command, const TileGrid& grid) {
    if (!command.triangle) return add(command, command.rectangle->bounds, grid);
    const SetUpTriangle& triangle = *command.triangle;
    const Rect tiles              = grid.tiles_touched(triangle.bounds);
    if (tiles.x1 - tiles.x0 == 1 || tiles.y1 - tiles.y0 == 1) return add(command, triangle.bounds, grid);

    // The greatest value of each edge in a tile; where one is negative the tile is outside.
    std::array<std::int64_t, 3> row_start, across, down;
    for (int i = 0; i < 3; ++i) {
        const Edge& edge = triangle.edges[i];
        row_start[i]     = edge.at(grid.first_x(tiles.x0), grid.first_y(tiles.y0)) +
                       std::max<std::int64_t>(edge.a * (kTileWidth - 1), 0) +
                       std::max<std::int64_t>(edge.b * (kTileHeight - 1), 0);
        across[i] = edge.a * kTileWidth;
        down[i]   = edge.b * kTileHeight;
    }
    for (int row = tiles.y0; row < tiles.y1; ++row) {
        std::array<std::int64_t, 3> greatest = row_start;
        for (int column = tiles.x0; column < tiles.x1; ++column) {
            if ((greatest[0] | greatest[1] | greatest[2]) >= 0) entries_.push_back({grid.index(column, row), &command});
            for (int i = 0; i < 3; ++i) greatest[i] += across[i];
        }
        for (int i = 0; i < 3; ++i) row_start[i] += down[i];
    }
}

void Bin::sort() {
    first_tile_ = end_tile_ = 0;
    if (entries_.empty()) return;
    const auto [least, greatest] = std::minmax_element(entries_.begin(), entries_.end(),
                                                       [](const Entry& a, const Entry& b) { return a.tile < b.tile; });
    first_tile_                  = least->tile;
    end_tile_                    = greatest->tile + 1;

    // Each tile's count, one place on; then where its commands begin; and that again as they are put in.
    begin_.assign(static_cast<std::size_t>(end_tile_ - first_tile_) + 2, 0);
    std::uint32_t* const next = begin_.data() + 1;
    for (const Entry& entry : entries_) ++next[entry.tile - first_tile_ + 1];
    for (std::size_t tile = 2; tile < begin_.size(); ++tile) begin_[tile] += begin_[tile - 1];
    sorted_.resize(entries_.size());
    for (const Entry& entry : entries_) sorted_[next[entry.tile - first_tile_]++] = *entry.command;
}

}  // namespace raster
