// SPDX-License-Identifier: MIT
// The pixels of a tile that have got their last colour. Where each fragment replaces what is there and none changes what
// the others are tested against, only the last one that passes shows: primitives are then filled in reverse, the last one
// first, and a pixel that has been written once is settled.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "raster/tile.h"

namespace raster {

class SettledPixels {
  public:
    void clear() { rows_.fill(0); }

    // Of the block at (x, y), x a multiple of 16: a bit for each of its pixels.
    unsigned block(int x, int y) const { return static_cast<unsigned>(row(y) >> in_row(x)) & 0xffff; }
    void add(int x, int y, unsigned bits) {
        rows_[static_cast<std::size_t>(y & (kTileHeight - 1))] |= std::uint64_t{bits} << in_row(x);
    }

    // All of a rectangle within the tile?
    bool has(const Rect& pixels) const {
        const std::uint64_t columns = ~std::uint64_t{0} >> (kTileWidth - (pixels.x1 - pixels.x0)) << in_row(pixels.x0);
        std::uint64_t all           = columns;
        for (int y = pixels.y0; y < pixels.y1; ++y) all &= row(y);
        return all == columns;
    }

  private:
    static_assert(kTileWidth == 64 && std::has_single_bit(unsigned{kTileHeight}));
    static int in_row(int x) { return x & (kTileWidth - 1); }
    std::uint64_t row(int y) const { return rows_[static_cast<std::size_t>(y & (kTileHeight - 1))]; }

    std::array<std::uint64_t, kTileHeight> rows_{};
};

}  // namespace raster
