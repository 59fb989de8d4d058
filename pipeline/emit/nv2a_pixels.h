// SPDX-License-Identifier: MIT
// What the NV2A is told for a pass beside its draws: surfaces, the part that is drawn to, clears, and what happens to a pixel.
#pragma once

#include "pipeline/emit/nv2a_memory.h"
#include "pipeline/emit/nv2a_stream.h"

namespace pipeline {

// One of the two may be missing; its offset is then 0, and nothing may be written to it.
void set_surfaces(Nv2aStream& out, const Frame& frame, const Nv2aMemory& memory, TargetId color, TargetId depth);

// The pixels that viewport and scissor leave of the pass's targets; may be empty.
PixelRect drawn_part(const Frame& frame, const Pass& pass);

// The part must not be empty.
void set_window_clip(Nv2aStream& out, const PixelRect& part);
void clear(Nv2aStream& out, const Frame& frame, const Pass& pass, const PixelRect& part);

// What no frame has: dithering, stencil, points, lines, logic operations, skinning, vertex programs.
void set_unused_state(Nv2aStream& out);

// Blending, tests, masks, shading.
void set_pixel_state(Nv2aStream& out, const Pass& pass);
void set_culling(Nv2aStream& out, CullMode cull);

// All targets that are needed before a pass clears them whole get the zeros that frames begin with.
void clear_to_zeros(Nv2aStream& out, const Frame& frame, const Nv2aMemory& memory);

void copy(Nv2aStream& out, const Frame& frame, const Nv2aMemory& memory, const CopyRectangle& copy, TargetId to);

}  // namespace pipeline
