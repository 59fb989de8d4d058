// SPDX-License-Identifier: MIT
// Everything that covers one tile, in order, while its pixels are in the L1 cache.
#pragma once

#include <cstdint>
#include <span>

#include "raster/fill_counts.h"
#include "raster/fill_plan.h"
#include "raster/tile.h"

namespace raster {

// One primitive in a tile's list: a triangle or a rectangle, how to fill it, and whose counts it adds to.
struct Command {
    const FillPlan* plan            = nullptr;
    const SetUpTriangle* triangle   = nullptr;
    const SetUpRectangle* rectangle = nullptr;
    std::uint32_t pass              = 0;
};

// Asks for the tile's pixels before the first of them is needed: rows lie far apart, and no processor guesses them.
void prefetch_tile(const FillTarget& target, const Rect& tile);

// tile: within the target. Adds to counts[Command::pass], if there are any counts.
void fill_tile(std::span<const Command* const> commands, const Rect& tile, const FillTarget& target,
               std::span<KernelCounts> counts);

}  // namespace raster
