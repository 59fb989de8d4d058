// SPDX-License-Identifier: MIT
// A pass for the rasterizer: primitives with their states, drawn in order onto one colour and one depth image.
// `fill_pass` bins all of it into tiles and fills the tiles on several threads; `reference_fill_pass` (reference.h)
// does the same pixel by pixel. Both give the same bytes, whatever the number of threads, the order of tiles and the
// instruction set.
#pragma once

#include <cstdint>
#include <vector>

#include "raster/copy_pixels.h"
#include "raster/fill_counts.h"
#include "raster/fill_state.h"
#include "raster/image.h"
#include "raster/primitives.h"
#include "raster/tile.h"

namespace raster {

// Triangles are drawn before rectangles; a state's primitives are of one kind.
struct Draw {
    FillState state;
    std::vector<Triangle> triangles;
    std::vector<Rectangle> rectangles;
};

// color, depth: either may be null, never both; where both are there they have the same size. A state must not test or
// write depth without a depth image, nor test the alpha of a destination without a colour image, or with one that has
// no alpha. `depth_bits`: 16, 24 or 32. `format`: of the colour image. `scissor` lies within the images.
struct PassFill {
    Image* color   = nullptr;
    Image* depth   = nullptr;
    int depth_bits = 24;
    ColorFormat format;
    PixelGrid grid;
    Rect scissor;
    std::vector<Draw> draws;
};

// tile_order_seed: not 0 shuffles the order in which tiles are taken, for tests.
struct FillOptions {
    std::uint32_t tile_order_seed = 0;
};

// Uses the threads of the arena it is called in (thread_arena.h).
FillCounts fill_pass(const PassFill& pass, const FillOptions& options = {});

// Sets the pixels of `rect` that lie within the image.
void fill_rect(Image& image, const Rect& rect, std::uint32_t value);

}  // namespace raster
