// SPDX-License-Identifier: MIT
// From object space to window space, for triangles: transform, Direct3D 7 lighting, vertex fog, texture coordinate
// generation, clipping, the viewport and culling. Matrices are multiplied in double and rounded once; from there single
// precision in one fixed order, but for lengths, curves and the cuts of edges (double); of the C library only sqrt
// and what rounds.
//   clip    Against the near and far plane (0 <= z <= w) and a guard band of kGuardBand pixels around the viewport;
//           what reaches from the viewport into the guard band is left to the scissor. Triangles with all corners
//           beyond one side of the viewport are dropped. See pipeline/execute/clip.h.
//   window  x = X + (1 + cx/cw) * W/2, y = Y + (1 - cy/cw) * H/2, z = cz/cw, rhw = 1/cw, for viewport (X, Y, W, H);
//           kept within the guard band and 0..1, which only the rounding of a cut can leave.
//   cull    By the sign of D, the area of the snapped corners (raster/primitives.h): CW drops D > 0, CCW drops D < 0,
//           and D = 0 is always dropped.
//   colour  Bytes, round(c * 255) half up, made last: clipping works on floats. With flat shading all corners get the
//           bytes of the triangle's first vertex, whatever clipping leaves of it.
// Overflow: a triangle is dropped if one of its clip coordinates is not finite, or if a texture coordinate is beyond
// what raster::TexCoord allows; a colour or fog that is not a number counts as 0.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "pipeline/execute/vertex_shader.h"
#include "pipeline/frame/frame.h"
#include "raster/fill_pass.h"

namespace pipeline {

struct VertexStageCounts {
    std::uint64_t vertices     = 0;  // distinct ones that the draw refers to
    std::uint64_t triangles_in = 0, triangles_drawn = 0;
};

// A draw for the stage. `viewport` is already resolved (not empty); `guard_band` is in pixels; `out` gets the triangles, in order, and their
// vertices, in place of those it had.
struct VertexStageDraw {
    const Pass* pass          = nullptr;
    const DrawTriangles* draw = nullptr;
    PixelRect viewport;
    float guard_band  = kGuardBand;
    raster::Draw* out = nullptr;
    VertexStageCounts counts;
};

// Keeps its memory from one run to the next. Not for use by two threads at once.
class VertexStage {
  public:
    VertexStage();
    ~VertexStage();

    // Uses the threads of the arena it is called in.
    void run(const Frame& frame, std::span<VertexStageDraw> draws, ShadingPath path = ShadingPath::Kernels);

  private:
    struct Memory;
    std::unique_ptr<Memory> memory_;
};

// One draw by itself.
VertexStageCounts run_vertex_stage(const Frame& frame, const Pass& pass, const DrawTriangles& draw,
                                   const PixelRect& viewport, raster::Draw& out,
                                   ShadingPath path = ShadingPath::Kernels);

}  // namespace pipeline
