// SPDX-License-Identifier: MIT
// A pass's state, one concept each, in OpenGL's terms. All of a concept is set each time, so nothing is left over
// from the pass before.
#pragma once

#include "pipeline/frame/frame.h"

namespace peers {

// Viewport and scissor of a pass, resolved: not empty, in pixels of its targets.
struct PassArea {
    pipeline::PixelRect viewport, scissor;
};
PassArea area_of(const pipeline::Frame& frame, const pipeline::Pass& pass);

void set_scissor(const pipeline::PixelRect& scissor);
void clear(const pipeline::Clear& clear);

// Of triangles.
void set_fog(const pipeline::FogState& fog);
void set_culling(pipeline::CullMode cull);

// Blend, colour mask, alpha and depth test, shading, and what stays off.
void set_fragment_state(const pipeline::PipelineState& state);

}  // namespace peers
