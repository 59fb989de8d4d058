// SPDX-License-Identifier: MIT
// What follows, at a pixel, from the triangles that come near its centre:
// - Slivers. Snapping displaces a vertex by up to 1/32 pixel along each axis here and 1/512 in OpenGL, 0.048 pixel
//   together along a diagonal. Where two edges of a triangle are both as near as that to the centre, at its tip or
//   all along a sliver, it may cover the centre, or be culled, in one of them only.
// - Perspective. OpenGL interpolates colours and fog in perspective, which the frame does linearly on the screen:
//   with weights b_i of the corners, sum b_i r_i c_i / sum b_i r_i and sum b_i c_i, r = 1/w. The two are known here
//   exactly.
#pragma once

#include <vector>

#include "pipeline/frame/frame.h"
#include "raster/primitives.h"

namespace peers {

class PassGeometry {
  public:
    // Of a pass, and for slivers of those before it that its depth comes from. The frame outlives this.
    PassGeometry(const pipeline::Frame& frame, std::size_t index);

    // Do two edges of one triangle come too near to the centre of pixel (x, y)?
    bool has_sliver(int x, int y) const;

    // Is the centre exactly on an edge of a triangle or rectangle of the pass, snapped to our grid? There is a rule for
    // ties, which softpipe, whose edges are floats, does not keep.
    bool has_tie(int x, int y) const;

    // The greatest difference of the two interpolations there, of any colour, alpha or fog of any triangle, in units
    // of 255.
    double perspective(int x, int y) const;

  private:
    struct NearTriangle {
        raster::Triangle corners;
        bool is_of_pass;
    };
    void add(const raster::Triangle& triangle, bool is_of_pass);
    const std::vector<NearTriangle>& near(int x, int y) const;

    const pipeline::Pass& pass_;
    int width_ = 0, height_ = 0;                    // in tiles
    std::vector<std::vector<NearTriangle>> tiles_;  // culled triangles too
};

}  // namespace peers
