// SPDX-License-Identifier: MIT
#include "raster/bin.h"

namespace raster {

TileGrid::TileGrid(const Rect& area) : area_(area) {
    if (area.empty()) return;
    x0_      = area.x0 / kTileWidth;
    y0_      = area.y0 / kTileHeight;
    columns_ = (area.x1 - 1) / kTileWidth - x0_ + 1;
    rows_    = (area.y1 - 1) / kTileHeight - y0_ + 1;
}

Rect TileGrid::whole_tile(int column, int row) const {
    const int x = (x0_ + column) * kTileWidth, y = (y0_ + row) * kTileHeight;
    return {x, y, x + kTileWidth, y + kTileHeight};
}

Rect TileGrid::tile(int index) const {
    return intersect(whole_tile(index % columns_, index / columns_), area_);
}

Rect TileGrid::tiles_touched(const Rect& pixels) const {
    return {pixels.x0 / kTileWidth - x0_, pixels.y0 / kTileHeight - y0_, (pixels.x1 - 1) / kTileWidth - x0_ + 1,
            (pixels.y1 - 1) / kTileHeight - y0_ + 1};
}

void bin_command(const Command& command, const TileGrid& grid, std::vector<TileEntry>& out) {
    const Rect tiles = grid.tiles_touched(command.triangle ? command.triangle->bounds : command.rectangle->bounds);
    const bool large = tiles.x1 - tiles.x0 > 1 && tiles.y1 - tiles.y0 > 1;
    TileEdges edges;
    for (int row = tiles.y0; row < tiles.y1; ++row)
        for (int column = tiles.x0; column < tiles.x1; ++column) {
            if (large && command.triangle && !enter_tile(*command.triangle, grid.whole_tile(column, row), edges))
                continue;
            out.push_back({grid.index(column, row), &command});
        }
}

Bins::Bins(int tile_count, std::span<const std::vector<TileEntry>> parts)
    : begin_(static_cast<std::size_t>(tile_count) + 1) {
    for (const auto& part : parts)
        for (const TileEntry& entry : part) ++begin_[entry.tile + 1];
    for (int tile = 0; tile < tile_count; ++tile) begin_[tile + 1] += begin_[tile];
    commands_.resize(begin_.back());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (const auto& part : parts)
        for (const TileEntry& entry : part) commands_[next[entry.tile]++] = entry.command;
}

}  // namespace raster
