// SPDX-License-Identifier: MIT
// The mega-particles as spheres, against the scene's own depth buffer.
#pragma once

#include "cloud/mega_particles/cloud_draw.h"

namespace cloud {

// Lit spheres, front to back, with z test and z write; alpha 1, or the particle's own. In article mode the pipeline's
// own lights light them, as they would any object of the scene; in skirt mode the light is baked into the vertices.
void append_particles(const CloudDraw& draw);

// Clears to the cloud's mean colour, alpha 0, and draws every sphere inflated by 2.5 sigma, back to front, alpha 0, z
// test without z write: when the blur spreads a rim, it mixes cloud with cloud colour, and nearer objects keep clear of
// it.
void append_skirt(const CloudDraw& draw);

// Directional lights and ambient that give sun (1/2 + 1/2 N.L) + sky (1/2 + 1/2 Ny) + bounce (1/2 - 1/2 Ny): a light
// from each side, the one behind with negative colour.
pipeline::LightingState daylight_state(const Daylight& daylight);

}  // namespace cloud
