// SPDX-License-Identifier: MIT
// Material, lights and ambient light of a pass as calls of Direct3D 7. The light that is everywhere is a render state of
// bytes there: what no bytes can say becomes the ambient colour of a light.
#pragma once

#include <string>
#include <vector>

#include "pipeline/frame/lighting_state.h"

namespace pipeline::dx7 {

std::vector<std::string> lighting_calls(const LightingState& state);

}  // namespace pipeline::dx7
