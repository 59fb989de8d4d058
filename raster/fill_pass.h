// SPDX-License-Identifier: MIT
// A pass for the rasterizer: clears, then primitives with their states, in order onto one colour and one depth image.
// `PassFiller` bins all of it into tiles and fills the tiles on several threads; `reference_fill_pass` (reference.h)
// does the same pixel by pixel. Both give the same bytes, whatever the number of threads, the order of tiles and the
// instruction set.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "raster/copy_pixels.h"
#include "raster/fill_counts.h"
#include "raster/fill_state.h"
#include "raster/image.h"
#include "raster/primitives.h"
#include "raster/tile.h"

namespace raster {

// Triangles are drawn before rectangles; a state's primitives are of one kind. flat: both colours of a triangle are
// those of its first corner.
struct Draw {
    FillState state;
    std::vector<Vertex> vertices;
    std::vector<TriangleCorners> triangles;
    std::vector<Rectangle> rectangles;
    bool flat = false;
};

inline Triangle triangle_of(const Draw& draw, const TriangleCorners& corners) {
    Triangle triangle{draw.vertices[corners[0]], draw.vertices[corners[1]], draw.vertices[corners[2]]};
    if (draw.flat)
        for (Vertex& vertex : triangle) {
            vertex.diffuse  = triangle[0].diffuse;
            vertex.specular = triangle[0].specular;
        }
    return triangle;
}

// color, depth: either may be null, never both; where both are there they have the same size. A state must not test or
// write depth without a depth image, nor test the alpha of a destination without a colour image, or with one that has
// no alpha. `depth_bits`: 16, 24 or 32. `format`: of the colour image. `scissor` lies within the images and limits
// clears as well, whose values are what the images hold.
struct PassFill {
    Image* color   = nullptr;
    Image* depth   = nullptr;
    int depth_bits = 24;
    ColorFormat format;
    PixelGrid grid;
    Rect scissor;
    std::optional<std::uint32_t> clear_color, clear_depth;
    std::vector<Draw> draws;
};

// tile_order_seed: not 0 shuffles the order in which tiles are taken, for tests. counts: whether anything is counted;
// without, primitives that are hidden cost less.
struct FillOptions {
    std::uint32_t tile_order_seed = 0;
    bool counts                   = true;
};

// Keeps its memory from one fill to the next. Not for use by two threads at once.
class PassFiller {
  public:
    PassFiller();
    ~PassFiller();

    // Fills passes one after the other, as if each were filled by itself: a tile goes through all of them while it is
    // in the cache. They draw to one colour and one depth image between them, though not each to both, and none reads
    // either as a texture. Adds to counts[i] what passes[i] did, with FillOptions::counts. Uses the threads of the arena it is called in
    // (thread_arena.h).
    void fill(std::span<const PassFill> passes, std::span<KernelCounts> counts, const FillOptions& options = {});

  private:
    struct Memory;
    std::unique_ptr<Memory> memory_;
};

// One pass by itself.
FillCounts fill_pass(const PassFill& pass, const FillOptions& options = {});

// The smallest rectangle that holds both.
Rect hull(const Rect& a, const Rect& b);

// Sets the pixels of `rect` that lie within the image.
void fill_rect(Image& image, const Rect& rect, std::uint32_t value);

}  // namespace raster
