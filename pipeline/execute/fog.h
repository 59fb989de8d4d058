// SPDX-License-Identifier: MIT
// Vertex fog: the share of the fragment's own colour that the fog leaves, 1 (no fog) to 0. The curves stand at FogMode
// in pipeline/frame/pipeline_state.h. Source: the Direct3D 7 help, "Fog Formulas"; a linear fog with start = end is all
// fog.
#pragma once

#include "pipeline/frame/pipeline_state.h"

namespace pipeline {

float fog_factor(const FogState& fog, const Vec3& camera_position);

}  // namespace pipeline
