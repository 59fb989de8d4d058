// SPDX-License-Identifier: MIT
// The mega-particles as spheres, against the scene's own depth buffer.
#pragma once

#include "cloud/mega_particles/cloud_draw.h"

namespace cloud {

// Lit spheres, front to back, with z test and z write; alpha 1, or the particle's own. In article mode the pipeline's
// own lights light them, as they would any object of the scene; in other modes the light is baked into the vertices.
// Premultiplied and black mode clear to nothing first. Article mode knows no glow, no inner lights and no
// silver lining.
void append_particles(const CloudDraw& draw);

// Clears to the cloud's mean colour, alpha 0, and draws every sphere inflated by 2.5 sigma, back to front, alpha 0, z
// test without z write: when the blur spreads a rim, it mixes cloud with cloud colour, and nearer objects keep clear of
// it. Without MegaParticleOptions::skirt it only clears.
void append_skirt(const CloudDraw& draw);

// Marks the back buffer where the scene is behind the particles inflated by 2.5 sigma, by bit 7 of its alpha: the blurred
// rim may lie over that. With it the composite can come after all of the scene; it needs no stencil.
void append_rim_mask(const CloudDraw& draw);

// The colour of a particle's surface from wherever it is seen: the baked light and that of the cloud's inner lights,
// times the particle's colour; and its glow.
Vec3 color_of(const Cloud& cloud, const Particle& particle, const LitVertex& vertex);

// Directional lights and ambient that give sun (1/2 + 1/2 N.L) + sky (1/2 + 1/2 Ny) + bounce (1/2 - 1/2 Ny): a light
// from each side, the one behind with negative colour.
pipeline::LightingState daylight_state(const Daylight& daylight);

}  // namespace cloud
