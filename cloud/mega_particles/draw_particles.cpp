// SPDX-License-Identifier: MIT
#include "cloud/mega_particles/draw_particles.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "cloud/particle_mesh.h"
#include "cloud/silver_lining.h"

namespace cloud {

using namespace pipeline;

namespace {

constexpr float kRimSigmas = 2.5f;

float distance_m(const CloudDraw& draw, std::size_t particle) {
    return glm::length(draw.baked.cloud.particles[particle].center - draw.view.eye);
}

// By the distance of the nearest point; equal ones in the cloud's order.
std::vector<std::size_t> front_to_back(const CloudDraw& draw) {
    const std::vector<Particle>& particles = draw.baked.cloud.particles;
    std::vector<float> nearest;
    for (std::size_t i = 0; i < particles.size(); ++i)
        nearest.push_back(distance_m(draw, i) - greatest_radius(particles[i]));
    std::vector<std::size_t> order(particles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return nearest[a] < nearest[b]; });
    return order;
}

int level_of(const CloudDraw& draw, std::size_t particle) {
    const float radius    = greatest_radius(draw.baked.cloud.particles[particle]);
    const float clearance = std::max(distance_m(draw, particle) - radius, draw.view.near_m);
    const int chosen      = choose_level(focal_px(draw.view) * radius / clearance, sigma_px(draw.blur));
    return std::max(chosen - draw.options.fewer_sphere_levels, 0);
}

// Room for so many more. It doubles, for what comes later would else move the whole list again.
template <class T>
void make_room(std::vector<T>& list, std::size_t more) {
    const std::size_t size = list.size() + more;
    if (size > list.capacity()) list.reserve(std::max(size, 2 * list.capacity()));
}

// Appends the spheres, in the given order, as one draw. vertex_of(particle, vertex) makes the vertices.
template <class VertexOf>
DrawTriangles append_spheres(const CloudDraw& draw, const std::vector<std::size_t>& order, int coarser,
                             VertexOf&& vertex_of) {
    Frame& frame = draw.frame;
    DrawTriangles triangles;
    triangles.first_index        = static_cast<std::uint32_t>(frame.indices.size());
    const auto level_of_its_mesh = [&](std::size_t particle) {
        return std::max(level_of(draw, particle) - coarser, 0);
    };
    const auto is_there  = [&](std::size_t particle) { return draw.baked.cloud.particles[particle].alpha > 0.0f; };
    std::size_t vertices = 0, indices = 0;
    for (std::size_t particle : order)
        if (is_there(particle)) {
            vertices += icosphere_vertices(level_of_its_mesh(particle));
            indices += 3 * icosphere_triangles(level_of_its_mesh(particle));
        }
    // And for the sides of a box around them.
    constexpr std::size_t kSides = 6;
    make_room(frame.vertices, vertices + 4 * kSides);
    make_room(frame.indices, indices + 6 * kSides);
    for (std::size_t particle : order) {
        if (!is_there(particle)) continue;
        const int level            = level_of_its_mesh(particle);
        const auto first           = static_cast<std::uint32_t>(frame.vertices.size());
        const LitVertex* const lit = &draw.baked.lit.vertices[particle * icosphere_vertices(kFinestLevel)];
        for (std::uint32_t v = 0; v < icosphere_vertices(level); ++v)
            frame.vertices.push_back(vertex_of(draw.baked.cloud.particles[particle], lit[v]));
        for (std::uint32_t index : icosphere().indices[static_cast<std::size_t>(level)])
            frame.indices.push_back(first + index);
    }
    triangles.index_count = static_cast<std::uint32_t>(frame.indices.size()) - triangles.first_index;
    return triangles;
}

// By how much the rim reaches beyond a particle.
float rim_m(const CloudDraw& draw, const Particle& particle) {
    const float sigma_per_metre = sigma_px(draw.blur) / focal_px(draw.view);
    return kRimSigmas * sigma_per_metre * glm::length(particle.center - draw.view.eye);
}

// Whether the near plane may lie in one of the spheres: then their insides must be drawn.
bool inside_a_particle(const CloudDraw& draw, bool with_rim) {
    const Cloud& cloud = draw.baked.cloud;
    return std::any_of(cloud.particles.begin(), cloud.particles.end(), [&](const Particle& particle) {
        const Sphere sphere = bounding_sphere(particle, cloud);
        const float reach   = near_reach_m(draw.view) + (with_rim ? rim_m(draw, particle) : 0.0f);
        return glm::length(sphere.center - draw.view.eye) < sphere.radius + reach;
    });
}

Vec3 seen_color(const CloudDraw& draw, const Particle& particle, const LitVertex& vertex) {
    const Cloud& cloud = draw.baked.cloud;
    const Vec3 color   = color_of(cloud, particle, vertex);
    if (cloud.silver_lining <= 0.0f) return color;
    return color + silver_lining(cloud, draw.baked.daylight, vertex, draw.view.eye) * particle.color;
}

// What the particles' target gets: grey, if one channel has to do.
Vec3 stored_color(const CloudDraw& draw, Vec3 color) {
    const Cloud& cloud = draw.baked.cloud;
    if (!cloud.tint) return color;
    if (cloud.mode == Mode::Article) return color * *cloud.tint;
    return Vec3(glm::dot(color, Vec3(0.299f, 0.587f, 0.114f)));
}

Pass& append_sphere_pass(const CloudDraw& draw, const std::string& what, PixelRect area) {
    Pass& pass      = append_pass(draw, what, draw.targets.particles, at_level(area, draw.blur.first_level));
    pass.depth      = draw.targets.depth;
    pass.camera     = draw.targets.camera;
    pass.state.fog  = draw.scene.fog;
    pass.state.cull = CullMode::Clockwise;
    return pass;
}

}  // namespace

void append_particles(const CloudDraw& draw) {
    const Mode mode    = draw.baked.cloud.mode;
    const bool article = mode == Mode::Article, on_black = mode == Mode::Premultiplied || mode == Mode::Black;
    // A smaller target goes on beyond the picture, and the blur reads what is there.
    const bool goes_on = draw.blur.first_level > 0;
    Pass& pass = append_sphere_pass(draw, "mega-particles, alpha 1", on_black || goes_on ? draw.halo : draw.bounds);
    pass.state.depth = {.func = CompareFunc::LessEqual, .write = true};
    if (on_black) pass.clear.color = Argb{0x00000000};
    if (inside_a_particle(draw, false)) pass.state.cull = CullMode::None;
    if (article) pass.state.lighting = daylight_state(draw.baked.daylight);
    pass.draws.push_back(
        append_spheres(draw, front_to_back(draw), 0, [&](const Particle& particle, const LitVertex& lit) {
            const Vec3 color = article ? lit.occlusion * particle.color : seen_color(draw, particle, lit);
            return Vertex{.position = lit.position,
                          .normal   = lit.normal,
                          .diffuse  = to_argb(stored_color(draw, color), particle.alpha)};
        }));
}

void append_skirt(const CloudDraw& draw) {
    const Argb mean = to_argb(stored_color(draw, draw.baked.lit.mean_color), 0.0f);
    if (!draw.options.skirt) {
        append_pass(draw, "clear to the mean colour, alpha 0", draw.targets.particles,
                    at_level(draw.halo, draw.blur.first_level))
            .clear.color = mean;
        return;
    }
    Pass& pass                             = append_sphere_pass(draw, "skirt: inflated particles, alpha 0", draw.halo);
    pass.clear.color                       = mean;
    pass.state.depth                       = {.func = CompareFunc::LessEqual, .write = false};
    std::vector<std::size_t> back_to_front = front_to_back(draw);
    std::reverse(back_to_front.begin(), back_to_front.end());
    // One level coarser: of the skirt only colour is seen, and that blurred.
    pass.draws.push_back(append_spheres(draw, back_to_front, 1, [&](const Particle& particle, const LitVertex& lit) {
        return Vertex{.position = lit.position + lit.normal * rim_m(draw, particle),
                      .normal   = lit.normal,
                      .diffuse  = to_argb(stored_color(draw, seen_color(draw, particle, lit)), 0.0f)};
    }));
}

void append_rim_mask(const CloudDraw& draw) {
    constexpr ColorMask kAlphaAlone{.red = false, .green = false, .blue = false, .alpha = true};
    // Inside the rim all of the scene is behind it.
    const bool everywhere = inside_a_particle(draw, true);
    Pass& start = append_pass(draw, everywhere ? "rim mask: everywhere" : "rim mask: nowhere", draw.scene.back_buffer,
                              draw.bounds);
    start.state.color_mask = kAlphaAlone;
    DrawRectangle all;
    all.x1    = static_cast<float>(draw.view.width);
    all.y1    = static_cast<float>(draw.view.height);
    all.color = {everywhere ? 0xff000000 : 0x00000000};
    start.draws.push_back(all);
    if (everywhere) return;

    Pass& mask      = append_pass(draw, "rim mask: where the scene is behind", draw.scene.back_buffer, draw.bounds);
    mask.depth      = draw.scene.depth;
    mask.camera     = draw.scene.camera;
    mask.state.cull = CullMode::Clockwise;
    mask.state.color_mask = kAlphaAlone;
    mask.state.depth      = {.func = CompareFunc::LessEqual, .write = false};
    // As fine as the particles, which would come through coarser ones in the folds between them.
    mask.draws.push_back(
        append_spheres(draw, front_to_back(draw), 0, [&](const Particle& particle, const LitVertex& lit) {
            return Vertex{.position = lit.position + lit.normal * rim_m(draw, particle),
                          .normal   = lit.normal,
                          .diffuse  = {0xffffffff}};
        }));
}

Vec3 color_of(const Cloud& cloud, const Particle& particle, const LitVertex& vertex) {
    Vec3 light = vertex.light;
    for (const InnerLight& inner : cloud.lights) {
        const Vec3 to_light   = inner.center - vertex.position;
        const float distance2 = glm::dot(to_light, to_light);
        const float left      = 1.0f - distance2 / (inner.range * inner.range);
        if (left <= 0.0f) continue;
        const float facing = distance2 > 0.0f ? glm::dot(vertex.normal, to_light) / std::sqrt(distance2) : 0.0f;
        light += inner.color * (left * left * (0.7f + 0.3f * facing));
    }
    return light * particle.color + particle.glow;
}

LightingState daylight_state(const Daylight& daylight) {
    LightingState state;
    state.enabled        = true;
    state.diffuse_source = state.ambient_source = ColorSource::Color1;
    state.ambient                               = daylight.sun * 0.5f + (daylight.sky + daylight.bounce) * 0.5f;
    const auto add_pair                         = [&](Vec3 to_light, Vec3 color) {
        for (float side : {1.0f, -1.0f})
            state.lights.push_back({.diffuse = color * side, .direction = to_light * -side});
    };
    add_pair(daylight.to_sun, daylight.sun * 0.5f);
    add_pair(Vec3(0.0f, 1.0f, 0.0f), (daylight.sky - daylight.bounce) * 0.5f);
    return state;
}

}  // namespace cloud
