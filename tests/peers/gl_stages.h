// SPDX-License-Identifier: MIT
// The texture stages as OpenGL's texture units: filters, addresses, coordinates made from the camera-space position,
// and the ops as GL_COMBINE with its extensions (ARB_texture_env_combine, ATI_texture_env_combine3).
#pragma once

#include "pipeline/frame/frame.h"
#include "tests/peers/gl_memory.h"

namespace peers {

// The stages with what a draw binds to them. Returns how many are in use; the other units are off. Coordinates from
// the camera-space position are for triangles alone. Replaces the modelview matrix.
int set_stages(const pipeline::PipelineState& state, const pipeline::TextureBindings& textures, const GlMemory& memory,
               bool are_triangles);

// Is it an op of OpenGL's?
bool has_op(pipeline::TextureOp op);

}  // namespace peers
