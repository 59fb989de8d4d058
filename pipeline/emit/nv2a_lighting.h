// SPDX-License-Identifier: MIT
// Lights of the NV2A's fixed function. Of a vertex lit by the chip
//   colour = SCENE_AMBIENT_COLOR + sum over lights of A (ambient + max(0, N.L) diffuse)
// with the material's colours multiplied in by the program, or the diffuse one taken from the vertex (COLOR_MATERIAL), and
// A = 1 / (a0 + a1 d + a2 d^2) within the range. Sources: xemu, pgraph/glsl/vsh-ff.c; Mesa, nouveau's nv10_state_tnl.c and
// nv20_state_tnl.c, whose registers are laid out alike. Where they disagree or know nothing, colours are computed here
// (pipeline/execute/lighting.h), and the chip is given those:
//   - ambient or emissive colours that come from vertices: which of MATERIAL_EMISSION and SCENE_AMBIENT_COLOR is multiplied
//     by the vertex's colour, and whether the lights' ambient colours are
//   - highlights: their curve is six numbers (SPECULAR_PARAMS), known only by fits to a few powers
#pragma once

#include "pipeline/emit/nv2a_draw.h"

namespace pipeline {

bool lights_on_chip(const LightingState& lighting);

// Lighting on, with lights and material, or off.
void set_lights(Nv2aStream& out, const Nv2aDraw& draw);

// Both colours, 0xAARRGGBB each, rounded as the frame's are, of frame.vertices from `first` on.
std::vector<std::uint8_t> lit_colors(const Nv2aDraw& draw, std::uint32_t first, std::uint32_t count);

}  // namespace pipeline
