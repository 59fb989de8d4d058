// SPDX-License-Identifier: MIT
#include "cloud/mega_particles/composite.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "cloud/mega_particles/draw_particles.h"
#include "cloud/particle_mesh.h"

namespace cloud {

using namespace pipeline;

namespace {

constexpr float kReachSigmas = 10.0f;  // of the blur, before the surface
constexpr float kColorReach  = 1.5f;

float whiteout_reach_m(const Cloud& cloud, const View& view) {
    return std::max(kReachSigmas * cloud.blur_m, near_reach_m(view));
}

// Distance from the eye to the surface of the particle, about; negative inside.
float surface_m(const Particle& particle, Vec3 eye) {
    const Vec3 in_ball = glm::inverse(particle.shape) * (eye - particle.center);
    return glm::length(in_ball) - particle.radius;
}

// The mean colour of the surface around the eye: with distance d a vertex counts 1 / (1 + (d / reach)^2)^2, and less the
// less light finds it: what lies deep between particles is never seen.
Vec3 color_around(const BakedCloud& baked, Vec3 eye, float reach_m) {
    Vec3 sum(0.0f);
    float weights           = 0.0f;
    const std::size_t count = icosphere_vertices(kFinestLevel);
    for (std::size_t i = 0; i < baked.lit.vertices.size(); ++i) {
        const Particle& particle = baked.cloud.particles[i / count];
        const LitVertex& vertex  = baked.lit.vertices[i];
        const Vec3 away          = vertex.position - eye;
        const float share        = 1.0f / (1.0f + glm::dot(away, away) / (reach_m * reach_m));
        const float open         = vertex.occlusion * vertex.occlusion;
        const float weight       = share * share * open * open * particle.radius * particle.radius;
        sum += weight * color_of(baked.cloud, particle, vertex);
        weights += weight;
    }
    return weights > 0.0f ? sum / weights : baked.lit.mean_color;
}

}  // namespace

void append_composite(const CloudDraw& draw, TargetId finished) {
    const Cloud& cloud       = draw.baked.cloud;
    const bool premultiplied = cloud.mode == Mode::Premultiplied;
    const bool eroded        = cloud.mode == Mode::Skirt && cloud.detail == Detail::Fractal;  // tinted and dissolved
    const bool tinted        = cloud.tint && cloud.mode != Mode::Article && !eroded;
    Pass& pass = append_pass(draw, premultiplied ? "composite (ONE, INVSRCALPHA)" : "composite (SRCALPHA, INVSRCALPHA)",
                             draw.scene.back_buffer, draw.bounds);
    blend_over_scene(
        draw, pass.state,
        premultiplied ? BlendState{.source = BlendFactor::One, .dest = BlendFactor::InvSourceAlpha} : kAlphaOver);
    show_texture(pass.state, TextureFilter::Point);
    const float opacity = cloud.opacity * (eroded ? 1.0f : 1.0f - cloud.dissolve);
    Vec3 factor         = tinted ? *cloud.tint : Vec3(1.0f);
    if (premultiplied) factor *= opacity;
    TextureStage& stage = pass.state.stages[0];
    stage.alpha_op      = TextureOp::Modulate;
    stage.alpha_arg2    = {.source = ArgSource::TFactor};
    if (premultiplied || tinted) {
        stage.color_op   = TextureOp::Modulate;
        stage.color_arg2 = {.source = ArgSource::TFactor};
    }
    pass.state.texture_factor = to_argb(factor, opacity);
    pass.draws.push_back(blit(finished, draw.view.width, draw.view.height, 1.0f, 0.0f));
}

float whiteout(const Cloud& cloud, const View& view) {
    float nearest = 1.0f;
    for (const Particle& particle : cloud.particles)
        nearest =
            std::min(nearest, surface_m(particle, view.eye) / (whiteout_reach_m(cloud, view) * particle.alpha + 1e-6f));
    return std::min(1.0f - nearest, 1.0f) * cloud.opacity * (1.0f - cloud.dissolve);
}

void append_whiteout(const CloudDraw& draw) {
    const Cloud& cloud = draw.baked.cloud;
    const float alpha  = whiteout(cloud, draw.view);
    if (alpha <= 0.0f) return;
    Vec3 color = color_around(draw.baked, draw.view.eye, kColorReach * whiteout_reach_m(cloud, draw.view));
    if (cloud.tint) color *= *cloud.tint;
    Pass& pass = append_pass(draw, "whiteout: the eye is inside", draw.scene.back_buffer,
                             {0, 0, draw.view.width, draw.view.height});
    pass.state.blend = kAlphaOver;  // nearer things as well: what is around the eye is before all
    DrawRectangle all;
    all.x1    = static_cast<float>(draw.view.width);
    all.y1    = static_cast<float>(draw.view.height);
    all.color = to_argb(color, alpha);
    pass.draws.push_back(all);
}

}  // namespace cloud
