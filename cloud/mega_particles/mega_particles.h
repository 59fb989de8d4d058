// SPDX-License-Identifier: MIT
// Volumetric clouds by mega-particles (H. and W. Bahnassi, "Volumetric Clouds and Mega-Particles", ShaderX5 5.3),
// written as passes of a frame. Read mega_particles.cpp: it is the technique on one screen.
#pragma once

#include <span>

#include "cloud/bake.h"
#include "cloud/cloud.h"
#include "cloud/mega_particles/options.h"
#include "pipeline/frame/frame.h"

namespace cloud {

// The scene that the clouds go into, already drawn by earlier passes of the frame. fog: the scene's own; particles get
// it as any other object does.
struct SceneTargets {
    pipeline::TargetId back_buffer, depth;
    pipeline::CameraId camera;
    pipeline::FogState fog;
};

// Appends the passes (with their targets, textures, vertices) that draw `clouds` over the scene, farthest first.
// back_buffer, depth and view have one size. Throws std::invalid_argument as check() does.
void append_mega_particles(pipeline::Frame& frame, const SceneTargets& scene, const View& view,
                           std::span<const BakedCloud> clouds, const MegaParticleOptions& options = {});

// The same, baking each cloud first; an animation of the camera bakes once instead.
void append_mega_particles(pipeline::Frame& frame, const SceneTargets& scene, const View& view, const Daylight& light,
                           std::span<const Cloud> clouds, const MegaParticleOptions& options = {});

}  // namespace cloud
