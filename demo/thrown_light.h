// SPDX-License-Identifier: MIT
// Light that fire or a flash throws on what stands around: what is drawn already is drawn once more, times 1 + the light.
#pragma once

#include "demo/cloud_motion.h"
#include "pipeline/frame/frame.h"

namespace demo {

// (1 - d^2)^3 of the distance d from the middle, 0 from its border on: half its size is 1.
pipeline::Texture light_texture();

// With light_texture() on both stages: color (1 - (x^2 + z^2))^3 (1 - y^2)^3, in ranges from the light's centre. Seen from
// above and from the side, as two textures are what there is; surfaces that look away are lit as well. The pass's camera
// has this view, its fog these distances.
pipeline::PipelineState thrown_light_state(const ThrownLight& light, const pipeline::Mat4& view,
                                           const pipeline::FogState& fog);

}  // namespace demo
