// SPDX-License-Identifier: MIT
// Triangles in window space, as lists: colours, S, T and Q times 1/w as frame/frame.h has them, X and Y cut to 1/16 pixel and
// Z to the depth buffer's units.
#pragma once

#include "pipeline/emit/gs_draw_state.h"

namespace pipeline {

// Throws std::invalid_argument for a corner that X or Y cannot hold: -2048..2047.9375 pixels.
void emit_triangles(const Frame& frame, const GsMemory& memory, const Pass& pass, const DrawWindowTriangles& draw,
                    GsBuilder& out);

}  // namespace pipeline
