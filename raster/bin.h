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
    Rect tiles_touched(const Rect& pixels) const;  // half-open, in tiles
    int index(int column, int row) const { return row * columns_ + column; }
    Rect whole_tile(int column, int row) const;

  private:
    Rect area_;
    int x0_ = 0, y0_ = 0, columns_ = 0, rows_ = 0;
};

// A command falls into a tile: what binning one part of the pass gives, in order.
struct TileEntry {
    int tile;
    const Command* command;
};

// Appends an entry for each tile that the command may touch.
void bin_command(const Command& command, const TileGrid& grid, std::vector<TileEntry>& out);

// The parts' entries, in order, sorted by tile.
class Bins {
  public:
    Bins(int tile_count, std::span<const std::vector<TileEntry>> parts);
    std::span<const Command* const> commands(int tile) const {
        return {commands_.data() + begin_[tile], commands_.data() + begin_[tile + 1]};
    }

  private:
    std::vector<std::uint32_t> begin_;
    std::vector<const Command*> commands_;
};

}  // namespace raster
