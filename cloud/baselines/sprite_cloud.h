// SPDX-License-Identifier: MIT
// The particle cloud of 2000, to measure mega-particles against: a few hundred camera-facing quads per cloud, each with
// the picture of a puff, blended over the scene from back to front (SRCALPHA, INVSRCALPHA), with z test and no z write.
// Lengths in metres.
//
// What makes the comparison fair: the puffs fill the very particles that mega-particles draw, keep to their silhouette
// and flat base, and take their colour from the same baked light: sun, self-shadow, sky and all. What the technique
// cannot do stays: a puff has one colour, so it shows no shading of its own; it is cut off sharply where it meets the
// scene; and each pixel of the cloud is blended many times over.
#pragma once

#include <span>
#include <vector>

#include "cloud/bake.h"
#include "cloud/mega_particles/mega_particles.h"

namespace cloud {

struct SpriteOptions {
    int count     = 200;    // of a cloud: 1 to 100,000
    float opacity = 0.85f;  // of a puff's middle: 0 to 1
};

// A puff. radius: half the edge of its quad. cosine, sine: of its turn about the line of sight.
struct Sprite {
    Vec3 center  = Vec3(0.0f);
    float radius = 1.0f;
    Vec3 color   = Vec3(1.0f);
    float alpha  = 1.0f;
    float cosine = 1.0f, sine = 0.0f;
};

// A cloud's puffs. cloud: whose they are.
struct SpriteCloud {
    Cloud cloud;
    std::vector<Sprite> sprites;
};

// Puff i of N belongs to the particle in which the fraction (i + 1/2) / N of the sum of all R^2 is reached: by volume
// the cloud's ends, which are made of small particles, would stay bare. Within it, it sits at a distance of
// 0.7 R max(u, v, w) from the middle (u, v, w evenly spread over 0..1, so that places are evenly spread over the ball),
// its azimuth a golden angle on from the one before. Its core, kSoftDiscCore of its radius, reaches to the particle's
// surface, but to 0.55 R at least; the cloud's base lifts it. Its colour is the particle's times the light near it on
// the outside of the cloud, plus the particle's glow: the mean over all vertices outside of other particles, weighted
// by 1 / (d^2 + s^2)^2, s being 0.12 of the greatest radius. Throws std::invalid_argument for options out of range.
SpriteCloud make_sprites(const BakedCloud& baked, const SpriteOptions& options = {});

// Appends one pass for each cloud in view, "<cloud>: sprites, back to front", farthest cloud first. Puffs turn
// transparent where they come closer to the eye than their radius. All share one A8 texture of 16 KiB, whose
// clear texels are kept from the blend by the alpha test.
void append_sprite_clouds(pipeline::Frame& frame, const SceneTargets& scene, const View& view,
                          std::span<const SpriteCloud> clouds);

// The same, making the puffs first; an animation of the camera makes them once instead.
void append_sprite_clouds(pipeline::Frame& frame, const SceneTargets& scene, const View& view,
                          std::span<const BakedCloud> clouds, const SpriteOptions& options = {});

}  // namespace cloud
