// SPDX-License-Identifier: MIT
// What follows, at a pixel, from the triangles that come near its centre:
// - Slivers. Snapping displaces a vertex by up to 1/32 pixel along each axis here (1/16 where corners are cut, not rounded)
//   and 1/512 in OpenGL, 0.048 pixel (0.091) together along a diagonal. Where two edges are both as near as that to the centre, those of one triangle at its tip
//   or all along a sliver, or those of two that fold or overlap there, each may lie on either side of it in one of them
//   only, and a triangle be culled.
// - Slopes. The same displacement changes a colour at the centre by as much times its slope.
// - Depth ties. It does so with a surface's depth, besides what floats lose of it. Where what the
//   pass draws and another surface are within the sum of theirs of each other, and no third one hides either, either may
//   be the nearer.
// - Perspective. OpenGL interpolates colours and fog in perspective, which the frame does linearly on the screen:
//   with weights b_i of the corners, sum b_i r_i c_i / sum b_i r_i and sum b_i c_i, r = 1/w. The two are known here
//   exactly.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "pipeline/frame/frame.h"
#include "raster/primitives.h"

namespace peers {

class PassGeometry {
  public:
    // Of a pass, and for slivers of those before it that its depth comes from. The frame outlives this.
    PassGeometry(const pipeline::Frame& frame, std::size_t index);

    // Do two edges come too near to the centre of pixel (x, y)?
    bool has_sliver(int x, int y) const;

    // Does an edge of a triangle come near to the centre?
    bool has_edge(int x, int y) const;

    // May another surface than in our picture be the nearest there? For depth tests that keep the nearer one.
    bool has_depth_tie(int x, int y) const;

    // Is the centre exactly on an edge of a triangle or rectangle of the pass, snapped to our grid? There is a rule for
    // ties, which softpipe, whose edges are floats, does not keep.
    bool has_tie(int x, int y) const;

    // The greatest difference of the two interpolations there, of any colour, alpha or fog of any triangle, in units
    // of 255.
    double perspective(int x, int y) const;

    // What the same may change by within as many pixels.
    double change_within(double pixels, int x, int y) const;

    // Pixels: how far snapping may displace a vertex in one picture from where it is in the other.
    double reach() const { return reach_; }

  private:
    struct NearTriangle {
        raster::Triangle corners;
        bool is_of_pass, is_culled, writes_depth, same_view;  // as the pass's camera and viewport
    };
    // Its depth at the centre of a pixel is known to +-reach.
    struct Surface {
        double depth, reach;
        bool is_of_pass, writes_depth;
        const raster::Triangle* triangle = nullptr;
        bool same_view                   = false;
    };
    void add(const NearTriangle& triangle);
    glm::dvec2 center_of(int x, int y) const;
    std::vector<Surface> surfaces_at(int x, int y) const;
    const std::vector<NearTriangle>& near(int x, int y) const;

    const pipeline::Pass& pass_;
    int center_;                                    // Arithmetic::pixel_center
    double reach_;                                  // pixels: how far edges may be displaced
    double depth_step_ = 0.0;                       // what a depth is rounded by
    std::vector<Surface> flat_surfaces_;            // clears and rectangles
    int width_ = 0, height_ = 0;                    // in tiles
    std::vector<std::vector<NearTriangle>> tiles_;  // culled triangles too
};

}  // namespace peers
