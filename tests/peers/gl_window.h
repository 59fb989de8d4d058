// SPDX-License-Identifier: MIT
// Triangles that are left of pipeline/execute's vertex stage, drawn by OpenGL: it has nothing to transform, light or
// clip. Colours and fog are the vertices' bytes.
#pragma once

#include "pipeline/frame/frame.h"
#include "tests/peers/gl_memory.h"

namespace peers {

enum class WindowTriangles {
    // As the rasterizer draws them: corners snapped to its grid, whose points OpenGL's finer one contains; all corners
    // at w = 1, so that colours are linear on the screen, and texture coordinates times rhw, with theirs as q. OpenGL
    // is then asked for the same triangles, edge for edge.
    Snapped,
    // As OpenGL would have them: corners where the vertex stage puts them, w as it is, faces culled by OpenGL.
    Placed,
};

// The pass's targets are bound, its area and fragment state set.
void draw_window_triangles(const pipeline::Frame& frame, const pipeline::Pass& pass,
                           const pipeline::DrawTriangles& draw, WindowTriangles which, const GlMemory& memory);

// With its corners on the rasterizer's grid.
pipeline::DrawRectangle snapped(const pipeline::DrawRectangle& draw);

}  // namespace peers
