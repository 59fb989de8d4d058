// SPDX-License-Identifier: MIT
// A scene with the same numbers and less of everything, so that thousands are built in a minute.
#pragma once

#include <algorithm>
#include <cstddef>

#include "demo/scene_data.h"

namespace fuzz {

// Left out are terrains, whose grid has half a million triangles whatever their size, pictures, and files, whose readers
// are tried by themselves.
inline demo::SceneDescription soon_built(demo::SceneDescription scene) {
    constexpr std::size_t kClouds = 3, kSolids = 4, kCores = 4, kKeys = 6, kLights = 2;
    constexpr int kParticles = 12, kFaceSize = 16, kOctaves = 4, kStars = 6, kFrames = 100000;
    const auto keep_first = [](auto& items, std::size_t count) {
        if (items.size() > count) items.erase(items.begin() + static_cast<std::ptrdiff_t>(count), items.end());
    };
    scene.terrain.reset();
    scene.meshes.clear();
    scene.sky.stars = std::min(scene.sky.stars, kStars);
    scene.frames    = std::min(scene.frames, kFrames);
    keep_first(scene.solids, kSolids);
    for (demo::Solid& solid : scene.solids) solid.texture = {};
    std::erase_if(scene.clouds, [](const demo::CloudPlan& plan) { return plan.particle_file.has_value(); });
    keep_first(scene.clouds, kClouds);
    for (demo::CloudPlan& plan : scene.clouds) {
        keep_first(plan.cores, kCores);
        keep_first(plan.lights, kLights);
        for (demo::CloudLight& light : plan.lights) keep_first(light.flashes, kKeys);
        plan.crown = std::min(plan.crown, kParticles / 2);
        plan.rim   = std::min(plan.rim, kParticles / 2);
        if (plan.stream) {
            plan.stream->count = std::min(plan.stream->count, kParticles / 2);
            plan.stream->bumps = std::min(plan.stream->bumps, 1);
        }
        cloud::Fractal& fractal = plan.settings.fractal;
        fractal.face_size       = std::min(fractal.face_size, kFaceSize);
        fractal.octaves         = std::min(fractal.octaves, kOctaves);
    }
    return scene;
}

}  // namespace fuzz
