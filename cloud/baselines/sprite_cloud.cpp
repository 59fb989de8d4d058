// SPDX-License-Identifier: MIT
#include "cloud/baselines/sprite_cloud.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <string>
#include <vector>

#include "cloud/baselines/farthest_first.h"
#include "cloud/baselines/soft_disc.h"
#include "cloud/mega_particles/cloud_draw.h"

namespace cloud {

using namespace pipeline;

namespace {

constexpr float kCornerOfASquare = 1.4142136f;

// The sprites' distances ahead of the eye are those of all their corners: a quad that faces the camera is parallel to
// the picture.
struct Facing {
    const View& view;
    Mat4 clip        = view.projection * view.view;
    Mat4 from_camera = glm::transpose(view.view);  // of directions
    Vec3 right = Vec3(from_camera[0]), up = Vec3(from_camera[1]);

    float ahead_m(const Sprite& sprite) const { return (clip * Vec4(sprite.center, 1.0f)).w; }

    bool sees(const Sprite& sprite) const {
        const Vec4 center = clip * Vec4(sprite.center, 1.0f);
        const float reach = sprite.radius * kCornerOfASquare;
        return center.w > view.near_m && std::abs(center.x) < center.w + reach * std::abs(view.projection[0][0]) &&
               std::abs(center.y) < center.w + reach * std::abs(view.projection[1][1]);
    }
};

void append_quad(Frame& frame, const Facing& facing, const Sprite& sprite) {
    const auto first  = static_cast<std::uint32_t>(frame.vertices.size());
    const float near  = facing.view.near_m;
    const float fade  = std::clamp((facing.ahead_m(sprite) - near) / sprite.radius, 0.0f, 1.0f);
    const Argb color  = to_argb(sprite.color, sprite.alpha * fade);
    const Vec3 across = (sprite.cosine * facing.right + sprite.sine * facing.up) * sprite.radius;
    const Vec3 along  = (sprite.cosine * facing.up - sprite.sine * facing.right) * sprite.radius;
    for (int corner = 0; corner < 4; ++corner) {
        const bool is_right = corner == 1 || corner == 2, is_low = corner >= 2;
        Vertex vertex;
        vertex.position = sprite.center + (is_right ? across : -across) + (is_low ? -along : along);
        vertex.diffuse  = color;
        vertex.uv0      = Vec2(is_right ? 1.0f : 0.0f, is_low ? 1.0f : 0.0f);
        frame.vertices.push_back(vertex);
    }
    for (const std::uint32_t index : {0u, 1u, 2u, 0u, 2u, 3u}) frame.indices.push_back(first + index);
}

TextureId append_disc(Frame& frame) {
    frame.textures.push_back({.name   = "soft disc",
                              .format = TextureFormat::A8,
                              .width  = kSoftDiscSize,
                              .height = kSoftDiscSize,
                              .levels = 1,
                              .texels = soft_disc_texels()});
    return {static_cast<std::int32_t>(frame.textures.size()) - 1};
}

// The vertex's colour, and alpha times the disc's.
void show_disc(TextureStage& stage) {
    stage.color_op   = TextureOp::SelectArg1;
    stage.color_arg1 = {.source = ArgSource::Diffuse};
    stage.alpha_op   = TextureOp::Modulate;
    stage.alpha_arg2 = {.source = ArgSource::Diffuse};
    stage.filter     = TextureFilter::Linear;
    stage.address_u = stage.address_v = TextureAddress::Clamp;
}

void append_pass(Frame& frame, const SceneTargets& scene, const std::string& name, const DrawTriangles& quads) {
    Pass& pass            = frame.passes.emplace_back();
    pass.label            = name + ": sprites, back to front";
    pass.color            = scene.back_buffer;
    pass.depth            = scene.depth;
    pass.camera           = scene.camera;
    pass.state.blend      = kAlphaOver;
    pass.state.depth      = {.func = CompareFunc::LessEqual, .write = false};
    pass.state.fog        = scene.fog;
    pass.state.alpha_test = {
        .func = CompareFunc::Greater, .reference = 0, .fail = AlphaFail::Keep};  // clear texels change nothing
    show_disc(pass.state.stages[0]);
    pass.draws = {quads};
}

}  // namespace

void append_sprite_clouds(Frame& frame, const SceneTargets& scene, const View& view,
                          std::span<const SpriteCloud> clouds) {
    const Facing facing{view};
    TextureId disc;
    std::vector<float> distances;
    for (const SpriteCloud& each : clouds) distances.push_back(nearest_particle_m(each.cloud, view.eye));
    for (const std::size_t index : farthest_first(distances)) {
        const SpriteCloud& from = clouds[index];
        const float opacity     = from.cloud.opacity * (1.0f - from.cloud.dissolve);
        if (opacity <= 0.0f) continue;
        std::vector<Sprite> seen;
        std::vector<float> ahead;
        for (const Sprite& sprite : from.sprites) {
            if (!facing.sees(sprite)) continue;
            seen.push_back(sprite);
            seen.back().alpha *= opacity;
            ahead.push_back(facing.ahead_m(sprite));
        }
        if (seen.empty()) continue;
        if (!disc) disc = append_disc(frame);
        DrawTriangles quads;
        quads.first_index = static_cast<std::uint32_t>(frame.indices.size());
        for (const std::size_t next : farthest_first(ahead)) append_quad(frame, facing, seen[next]);
        quads.index_count         = static_cast<std::uint32_t>(frame.indices.size()) - quads.first_index;
        quads.textures[0].texture = disc;
        append_pass(frame, scene, from.cloud.name, quads);
    }
}

void append_sprite_clouds(Frame& frame, const SceneTargets& scene, const View& view, std::span<const BakedCloud> clouds,
                          const SpriteOptions& options) {
    std::vector<SpriteCloud> made;
    for (const BakedCloud& baked : clouds) made.push_back(make_sprites(baked, options));
    append_sprite_clouds(frame, scene, view, made);
}

}  // namespace cloud
