// SPDX-License-Identifier: MIT
#include "demo/cloud_motion.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "cloud/bounds.h"
#include "cloud/generate.h"
#include "demo/gltf_particles.h"
#include "demo/noise.h"
#include "demo/trigonometry.h"

namespace demo {
namespace {

constexpr double kFlickersPerSecond = 9.0;
constexpr float kLeastRadius        = 0.01f;  // metres; cloud::bake refuses less than a tenth of it

cloud::Turn turned(double degrees) {
    const double angle = radians(std::fmod(degrees, 360.0));
    return cloud::Turn(static_cast<float>(cosine(angle)), static_cast<float>(sine(angle)));
}

cloud::Mat3 stretching(const CloudPlan& plan) {
    return {plan.stretch.x, 0.0f, 0.0f, 0.0f, plan.stretch.y, 0.0f, 0.0f, 0.0f, plan.stretch.z};
}

CloudKey key_at(const CloudPlan& plan, double seconds) {
    return plan.keys.empty() ? CloudKey{} : plan.keys.linear(seconds);
}

// Full at once, then fading; several flashes add.
float strength_at(const CloudLight& light, double seconds) {
    float strength = light.flashes.empty() ? 1.0f : 0.0f;
    for (const CloudLight::Flash& flash : light.flashes) {
        const double share = (seconds - flash.start_s) / flash.length_s;
        if (share < 0.0 || share >= 1.0) continue;
        const auto left = static_cast<float>(1.0 - share);
        strength += left * left;
    }
    const float flicker = noise(static_cast<float>(seconds * kFlickersPerSecond), 0.5f, 7);
    return strength * (1.0f - light.flicker * (0.5f + 0.5f * std::clamp(1.4f * flicker, -1.0f, 1.0f)));
}

// In the cloud's own place, before its keys.
std::vector<cloud::Particle> particles_at(const SceneCloud& scene_cloud, double seconds) {
    const CloudPlan& plan = scene_cloud.plan;
    if (!plan.stream && !scene_cloud.file) return scene_cloud.grown.particles;
    std::vector<cloud::Particle> particles =
        plan.stream ? stream_particles(*plan.stream, seconds) : scene_cloud.file->at(seconds);
    for (cloud::Particle& particle : particles) {
        particle.shape  = stretching(plan) * particle.shape;
        particle.center = plan.position + plan.scale * particle.center;
        particle.radius = std::max(particle.radius * plan.scale, kLeastRadius);
        particle.color *= plan.color;
    }
    return particles;
}

void apply_size(const CloudKey& key, Vec3 middle, std::vector<cloud::Particle>& particles) {
    if (key.spread == 1.0f && key.size == 1.0f) return;  // nothing is rounded
    for (cloud::Particle& particle : particles) {
        particle.center = middle + key.spread * (particle.center - middle);
        particle.radius = std::max(particle.radius * key.size, kLeastRadius);
    }
}

}  // namespace

cloud::Cloud grow_cloud(const CloudPlan& plan) {
    std::vector<CloudPlan::Core> places = plan.cores;
    if (plan.cumulus)
        for (const cloud::Particle& core : cumulus_cores(*plan.cumulus)) places.push_back({core.center, core.radius});
    std::vector<cloud::Particle> cores;
    for (const CloudPlan::Core& core : places)
        cores.push_back({.center     = plan.position + plan.scale * core.center,
                         .radius     = plan.scale * core.radius,
                         .color      = plan.color,
                         .alpha      = 1.0f,
                         .generation = 0});
    cloud::Growth growth;
    growth.crown.count = plan.crown;
    growth.rim.count   = plan.rim;
    growth.jitter      = plan.jitter;
    growth.seed        = plan.seed;

    cloud::Cloud cloud = plan.settings;
    cloud.particles    = cloud::grow(cores, growth);
    for (cloud::Particle& particle : cloud.particles) particle.shape = stretching(plan);
    cloud.base_y = plan.position.y + plan.scale * cloud.base_y;
    cloud.blur_m *= plan.scale;
    return cloud;
}

cloud::Cloud cloud_at(const SceneCloud& scene_cloud, double seconds) {
    const CloudPlan& plan = scene_cloud.plan;
    const CloudKey key    = key_at(plan, seconds);
    cloud::Cloud cloud    = scene_cloud.grown;
    cloud.particles       = particles_at(scene_cloud, seconds);
    apply_size(key, plan.position, cloud.particles);
    for (cloud::Particle& particle : cloud.particles) {
        particle.center += key.offset;
        particle.color *= key.color;
    }
    cloud.base_y += key.offset.y;
    cloud.opacity *= std::clamp(key.opacity, 0.0f, 1.0f);
    cloud.dissolve = std::clamp(cloud.dissolve + key.dissolve, 0.0f, 1.0f);
    if (cloud.box) {
        cloud.box->low += key.offset;
        cloud.box->high += key.offset;
    }
    for (const CloudLight& light : plan.lights) {
        const float strength = strength_at(light, seconds);
        if (!(strength > 0.0f)) continue;
        cloud.lights.push_back({.center = plan.position + key.offset + plan.scale * light.light.center,
                                .color  = light.light.color * strength,
                                .range  = plan.scale * light.light.range});
    }
    if (plan.box_turn_deg != 0.0) cloud.box_turn = turned(plan.box_turn_deg * seconds);
    if (plan.has_second_box) cloud.second_box_turn = turned(plan.second_box_turn_deg * seconds);
    const bool is_seen = std::any_of(cloud.particles.begin(), cloud.particles.end(),
                                     [](const cloud::Particle& particle) { return particle.alpha > 0.0f; });
    if (!is_seen) cloud.particles.clear();
    return cloud;
}

std::vector<ThrownLight> thrown_lights(const CloudPlan& plan, double seconds) {
    const CloudKey key = key_at(plan, seconds);
    std::vector<ThrownLight> thrown;
    for (const CloudLight& light : plan.lights) {
        const Vec3 color     = light.light.color * strength_at(light, seconds) * std::clamp(key.opacity, 0.0f, 1.0f);
        const float greatest = std::max({color.x, color.y, color.z});
        if (greatest * light.scene_range > 0.0f)
            thrown.push_back({.center = plan.position + key.offset + plan.scale * light.light.center,
                              .color  = color / std::max(greatest, 1.0f),
                              .range  = plan.scale * light.scene_range});
    }
    return thrown;
}

bool reshapes(const CloudPlan& plan) {
    return plan.stream || plan.particle_file || !plan.keys.empty();
}

bool moves(const CloudPlan& plan) {
    return reshapes(plan) || !plan.lights.empty() || plan.box_turn_deg != 0.0 || plan.second_box_turn_deg != 0.0;
}

cloud::Box box_over_time(const SceneCloud& scene_cloud, double last_s) {
    constexpr int kMoments = 120;
    const CloudPlan& plan  = scene_cloud.plan;
    last_s                 = std::max(last_s, plan.keys.last_seconds());
    if (plan.stream) last_s = std::max(last_s, plan.stream->life_s);
    if (scene_cloud.file) last_s = std::max(last_s, scene_cloud.file->duration());
    cloud::Box box{Vec3(1e30f), Vec3(-1e30f)};
    for (int i = 0; i <= kMoments; ++i) {
        const double seconds                   = last_s * i / kMoments;
        std::vector<cloud::Particle> particles = particles_at(scene_cloud, seconds);
        apply_size(key_at(scene_cloud.plan, seconds), scene_cloud.plan.position, particles);
        for (const cloud::Particle& particle : particles) {
            if (particle.alpha <= 0.0f) continue;
            const cloud::Sphere sphere = cloud::bounding_sphere(particle, scene_cloud.grown);
            box.low                    = glm::min(box.low, sphere.center - sphere.radius);
            box.high                   = glm::max(box.high, sphere.center + sphere.radius);
        }
    }
    if (!(box.low.x <= box.high.x)) box = {scene_cloud.plan.position - 1.0f, scene_cloud.plan.position + 1.0f};
    return box;
}

}  // namespace demo
