// SPDX-License-Identifier: MIT
// The loop: everything that covers one tile, in order, a batch of fragments at a time. Read this first.
#pragma once

#include <span>

#include "raster/fill_counts.h"
#include "raster/fill_plan.h"
#include "raster/image.h"

namespace raster {

// One primitive in a tile's list: a triangle or a rectangle, and how to fill it.
struct Command {
    const FillPlan* plan            = nullptr;
    const SetUpTriangle* triangle   = nullptr;
    const SetUpRectangle* rectangle = nullptr;
};

FillCounts fill_tile(std::span<const Command* const> commands, const Rect& tile, Image* color, Image* depth);

}  // namespace raster
