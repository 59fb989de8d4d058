// SPDX-License-Identifier: MIT
#include "cloud/mega_particles/displacement.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "cloud/mega_particles/fractal_box.h"
#include "cloud/noise.h"

namespace cloud {

using namespace pipeline;

namespace {

constexpr int kCellPx   = 8;
constexpr int kOctaves  = 2;  // finer ones would slip through the grid
constexpr float kGain   = 0.6f;
constexpr float kLength = 0.55f;  // of two octaves of noise in either axis, at their usual greatest

// Noise in metres becomes pixels at the depth of the cloud.
struct Displacement {
    Vec3 origin;
    float cycles_per_m, amplitude_px;
    std::uint32_t seed;

    Vec2 at(Vec3 point) const {
        const Vec3 p = (point - origin) * cycles_per_m;
        return Vec2(fbm(p, kOctaves, kGain, seed), fbm(p, kOctaves, kGain, seed + 1)) * (amplitude_px / kLength);
    }
};

Displacement displacement_of(const CloudDraw& draw) {
    const Cloud& cloud = draw.baked.cloud;
    const Box box      = fractal_box(cloud, draw.baked.lit);
    const Vec3 size    = box.high - box.low;
    const float edge   = std::max({size.x, size.y, size.z, 1e-6f});
    return {box.low, cloud.fractal.cycles / edge, cloud.displacement * sigma_px(draw.blur), cloud.fractal.seed};
}

// In front of the near plane, wherever the cloud is: depth takes no part.
float grid_depth_m(const CloudDraw& draw) {
    return 1.2f * draw.view.near_m;
}

}  // namespace

Vec3 point_looked_at(std::span<const Particle> particles, Vec3 eye, Vec3 direction) {
    float first = 1e30f, nearest = 1e30f, nearest_at = 0.0f;
    for (const Particle& particle : particles) {
        // In the particle's own space it is a ball of radius 1.
        const Mat3 to_ball = glm::inverse(particle.shape) * (1.0f / particle.radius);
        const Vec3 from = to_ball * (eye - particle.center), along = to_ball * direction;
        const float length2   = glm::dot(along, along);
        const float closest   = std::max(-glm::dot(from, along) / length2, 0.0f);
        const Vec3 there      = from + closest * along;
        const float distance2 = glm::dot(there, there);
        if (distance2 < 1.0f) {
            const float enters = closest - std::sqrt((1.0f - distance2) / length2);
            first              = std::min(first, enters > 0.0f ? enters : closest);
        }
        const float passes_by = (std::sqrt(distance2) - 1.0f) * particle.radius;
        if (passes_by < nearest) nearest = passes_by, nearest_at = closest;
    }
    return eye + direction * (first < 1e30f ? first : nearest_at);
}

void append_displaced_composite(const CloudDraw& draw) {
    Frame& frame             = draw.frame;
    const Cloud& cloud       = draw.baked.cloud;
    const View& view         = draw.view;
    const bool premultiplied = cloud.mode == Mode::Premultiplied;
    const Displacement noise = displacement_of(draw);
    const PixelRect area     = grow(draw.bounds, 0, view.width, view.height);
    const Mat4 to_world      = glm::inverse(view.view);
    const float w            = grid_depth_m(draw);

    const int columns = (area.x1 - area.x0 + kCellPx - 1) / kCellPx, rows = (area.y1 - area.y0 + kCellPx - 1) / kCellPx;
    const auto first = static_cast<std::uint32_t>(frame.vertices.size());
    const Vec2 size(static_cast<float>(view.width), static_cast<float>(view.height));
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            const Vec2 uv =
                Vec2(static_cast<float>(area.x0 + column * kCellPx), static_cast<float>(area.y0 + row * kCellPx)) /
                size;
            // From clip space back to camera space, which looks along -z.
            const Mat4& p = view.projection;
            const Vec3 in_camera((2.0f * uv.x - 1.0f + p[2][0]) / p[0][0] * w,
                                 (1.0f - 2.0f * uv.y + p[2][1]) / p[1][1] * w, -w);
            const Vec3 position  = Vec3(to_world * Vec4(in_camera, 1.0f));
            const Vec3 looked_at = point_looked_at(cloud.particles, view.eye, glm::normalize(position - view.eye));
            frame.vertices.push_back({.position = position, .uv0 = uv + noise.at(looked_at) / size});
        }
    DrawTriangles grid;
    grid.first_index = static_cast<std::uint32_t>(frame.indices.size());
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const auto corner = first + static_cast<std::uint32_t>(row * (columns + 1) + column);
            const auto below  = corner + static_cast<std::uint32_t>(columns + 1);
            for (std::uint32_t index : {corner, below, corner + 1, corner + 1, below, below + 1})
                frame.indices.push_back(index);
        }
    grid.index_count = static_cast<std::uint32_t>(frame.indices.size()) - grid.first_index;

    Pass& pass  = append_pass(draw, "displace and composite", draw.scene.back_buffer, draw.bounds);
    pass.camera = draw.scene.camera;
    blend_over_scene(
        draw, pass.state,
        premultiplied ? BlendState{.source = BlendFactor::One, .dest = BlendFactor::InvSourceAlpha} : kAlphaOver);
    const float opacity = cloud.opacity * (1.0f - cloud.dissolve);
    Vec3 factor         = cloud.tint && cloud.mode != Mode::Article ? *cloud.tint : Vec3(1.0f);
    if (premultiplied) factor *= opacity;
    pass.state.texture_factor = to_argb(factor, opacity);

    show_texture(pass.state, premultiplied ? TextureFilter::Linear : TextureFilter::Point);
    TextureStage& own       = pass.state.stages[0];
    own.color_op            = TextureOp::Modulate;
    own.color_arg2          = {.source = ArgSource::TFactor};
    own.alpha_op            = TextureOp::Modulate;
    own.alpha_arg2          = {.source = ArgSource::TFactor};
    grid.textures[0].target = draw.targets.finished;
    if (!premultiplied) {
        own.coords              = CoordSource::CameraPosition;
        own.transform           = screen_coordinates(view.projection);
        TextureStage& displaced = pass.state.stages[1];
        displaced               = own;
        displaced.color_op      = TextureOp::SelectArg2;
        displaced.color_arg2    = {.source = ArgSource::Current};
        displaced.filter        = TextureFilter::Linear;
        displaced.coords        = CoordSource::Vertex0;
        displaced.transform     = Mat4(1.0f);
        grid.textures[1].target = draw.targets.finished;
    }
    pass.draws.push_back(grid);
}

}  // namespace cloud
