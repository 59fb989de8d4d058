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

// How far before the surface it starts: so many standard deviations of the blur, but within so much of the largest radius.
constexpr float kReachSigmas = 10.0f, kReachRadii = 0.6f;
constexpr float kColorReach = 1.5f;  // of the surfaces whose colour it takes

float whiteout_reach_m(const Cloud& cloud, const View& view) {
    float largest = 0.0f;
    for (const Particle& particle : cloud.particles)
        if (particle.alpha > 0.0f) largest = std::max(largest, particle.radius);
    return std::max(std::min(kReachSigmas * cloud.blur_m, kReachRadii * largest), near_reach_m(view));
}

// Distance from the eye to the surface of the particle, about; negative inside.
float surface_m(const Cloud& cloud, const Particle& particle, Vec3 eye) {
    if (eye.y < cloud.base_y) eye.y = cloud.base_y + (eye.y - cloud.base_y) / kSquash;
    // In the axes of a ball of its radius; the gradient there tells what a metre is.
    const Mat3 to_ball = glm::inverse(particle.shape);
    const Vec3 q       = to_ball * (eye - particle.center);
    const float length = glm::length(q), slope = glm::length(glm::transpose(to_ball) * q);
    return slope > 0.0f ? (length - particle.radius) * length / slope : -particle.radius;
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
    const float reach = whiteout_reach_m(cloud, view);
    float most        = 0.0f;
    for (const Particle& particle : cloud.particles) {
        const float outside = surface_m(cloud, particle, view.eye) / reach;
        most                = std::max(most, particle.alpha * std::clamp(1.0f - outside, 0.0f, 1.0f));
    }
    return most * cloud.opacity * (1.0f - cloud.dissolve);
}

void append_whiteout(const CloudDraw& draw) {
    const Cloud& cloud = draw.baked.cloud;
    const float alpha  = whiteout(cloud, draw.view);
    if (alpha <= 0.0f) return;
    Vec3 color = color_around(draw.baked, draw.view.eye, kColorReach * whiteout_reach_m(cloud, draw.view));
    if (cloud.tint) color *= *cloud.tint;
    Pass& pass       = append_pass(draw, "whiteout: the eye is inside", draw.scene.back_buffer,
                                   {0, 0, draw.view.width, draw.view.height});
    pass.state.blend = kAlphaOver;  // nearer things as well: what is around the eye is before all
    DrawRectangle all;
    all.x1    = static_cast<float>(draw.view.width);
    all.y1    = static_cast<float>(draw.view.height);
    all.color = to_argb(color, alpha);
    pass.draws.push_back(all);
}

}  // namespace cloud
