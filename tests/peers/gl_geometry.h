// SPDX-License-Identifier: MIT
// A pass's draws. Triangles go through OpenGL's own transform, clipping and lighting; the projection is changed to
// its conventions: depth -1..1 before the viewport, z of camera space negated (gl_lighting.h), and y down, since row
// 0 of all memory here is the top row.
// Fog is Direct3D's vertex fog: the factor of each vertex, here from the C library's functions in double, is handed
// to OpenGL as a fog coordinate, with linear fog that ends at 0 and starts at 1, so that OpenGL only interpolates it.
#pragma once

#include "pipeline/frame/frame.h"
#include "tests/peers/gl_memory.h"

namespace peers {

// The pass's targets are bound, its area and fragment state set.
void draw_triangles(const pipeline::Frame& frame, const pipeline::Pass& pass, const pipeline::DrawTriangles& draw,
                    const GlMemory& memory);
void draw_rectangle(const pipeline::Frame& frame, const pipeline::Pass& pass, const pipeline::DrawRectangle& draw,
                    const GlMemory& memory);

}  // namespace peers
