// SPDX-License-Identifier: MIT
// Which commands touch which tile, in the order they were drawn.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "raster/fill_tile.h"
#include "raster/tile.h"

namespace raster {

// The tiles that a rectangle of pixels touches, numbered row by row.
class TileGrid {
  public:
    explicit TileGrid(const Rect& area);
    int count() const { return columns_ * rows_; }
    Rect tile(int index) const;                    // within the area
    Rect tiles_touched(const Rect& pixels) const;  // half-open, in tiles; pixels lie within the area
    int index(int column, int row) const { return row * columns_ + column; }
    int first_x(int column) const { return (x0_ + column) * kTileWidth; }
    int first_y(int row) const { return (y0_ + row) * kTileHeight; }

  private:
    Rect area_;
    int x0_ = 0, y0_ = 0, columns_ = 0, rows_ = 0;
};

// Commands, as they come, sorted by tile. Keeps its memory when cleared.
class Bin {
  public:
    void clear() { entries_.clear(); }

    // Enters each tile that the command may touch. The command must stay where it is until the last is sorted.
    void add(const Command& command, const TileGrid& grid);
    void add(const Command& command, const Rect& pixels, const TileGrid& grid);
    std::size_t entry_count() const { return entries_.size(); }

    // After the last command; from then on `commands` answers.
    void sort();
    std::span<const Command> commands(int tile) const {
        if (tile < first_tile_ || tile >= end_tile_) return {};
        const std::uint32_t* begin = begin_.data() + (tile - first_tile_);
        return {sorted_.data() + begin[0], sorted_.data() + begin[1]};
    }

  private:
    struct Entry {
        int tile;
        const Command* command;
    };
    std::vector<Entry> entries_;
    int first_tile_ = 0, end_tile_ = 0;
    std::vector<std::uint32_t> begin_;  // of each tile from first_tile_ on, in sorted_
    std::vector<Command> sorted_;       // copies, so that a tile's lie one after the other
};

}  // namespace raster
