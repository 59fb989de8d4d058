// SPDX-License-Identifier: MIT
// A cloud as its scene file describes it, with all that changes over time. Lengths in metres, times in seconds, colours
// factors 0..1 unless said otherwise.
#pragma once

#include <optional>
#include <vector>

#include "cloud/cloud.h"
#include "cloud/cumulus.h"
#include "demo/file_reference.h"
#include "demo/particle_stream.h"
#include "demo/track.h"

namespace demo {

// How a whole cloud changes: moved, its particles and their distances scaled, tinted, let through and dissolved.
struct CloudKey {
    Vec3 offset = Vec3(0.0f), color = Vec3(1.0f);
    float size = 1.0f, spread = 1.0f, opacity = 1.0f, dissolve = 0.0f;
    CloudKey operator+(const CloudKey& k) const {
        return {offset + k.offset, color + k.color,     size + k.size,
                spread + k.spread, opacity + k.opacity, dissolve + k.dissolve};
    }
    CloudKey operator*(float f) const {
        return {offset * f, color * f, size * f, spread * f, opacity * f, dissolve * f};
    }
};

// A light in or near a cloud. Without flashes it always shines; flicker: how much of it comes and goes, 0..1. It reaches
// light.range into the cloud, and scene_range on what stands around; 0: only the cloud.
struct CloudLight {
    cloud::InnerLight light;
    float scene_range = 0.0f;
    float flicker     = 0.0f;
    struct Flash {
        double start_s, length_s;
    };
    std::vector<Flash> flashes;
};

// settings without particles. These grow on cores, which are given or made, or stream, or come from a file; all around
// the cloud's position.
struct CloudPlan {
    struct Core {
        Vec3 center;
        float radius;
    };
    cloud::Cloud settings;
    std::vector<Core> cores;
    std::optional<cloud::CumulusShape> cumulus;
    std::optional<ParticleStream> stream;
    std::optional<FileReference> particle_file;
    Vec3 position = Vec3(0.0f);
    float scale   = 1.0f;
    Vec3 stretch  = Vec3(1.0f);  // of each particle's axes: an anvil's are flat
    Vec3 color    = Vec3(1.0f);
    int crown = 0, rim = 0;     // particles to grow
    float jitter       = 0.0f;  // of their places and sizes
    std::uint32_t seed = 1;     // of the jitter
    // Over time.
    Track<CloudKey> keys;
    std::vector<CloudLight> lights;
    double box_turn_deg = 0.0, second_box_turn_deg = 0.0;  // degrees a second
    bool has_second_box = false;
};

}  // namespace demo
