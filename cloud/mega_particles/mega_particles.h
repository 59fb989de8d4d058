// SPDX-License-Identifier: MIT
// Volumetric clouds by mega-particles (Bahnassi & Bahnassi, "Mega-Particles for Volumetric Rendering", ShaderX5 5.3), written as
// passes of a frame. Read mega_particles.cpp: it is the technique on one screen.
#pragma once

#include <span>

#include "cloud/cloud.h"
#include "pipeline/frame/frame.h"

namespace cloud {

// The scene that the clouds go into, already drawn by earlier passes of the frame.
struct SceneTargets {
    pipeline::TargetId back_buffer, depth;
    pipeline::CameraId camera;
};

// Appends the passes (with their targets, textures, vertices) that draw `clouds` over the scene, farthest first.
void append_mega_particles(pipeline::Frame& frame, const SceneTargets& scene, const View& view, const Daylight& light,
                           std::span<const Cloud> clouds);

}  // namespace cloud
