// SPDX-License-Identifier: MIT
// The order of a scene's passes: all that stands behind the clouds or reaches into them, the clouds, then what stands
// in front, so that a cloud's soft edge, which has no depth of its own, never lies over a nearer thing.
#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "cloud/baselines/slice_cloud.h"
#include "cloud/baselines/sprite_cloud.h"
#include "cloud/bounds.h"
#include "cloud/mega_particles/mega_particles.h"
#include "cloud/merge.h"
#include "demo/camera_matrices.h"
#include "demo/cloud_motion.h"
#include "demo/precision.h"
#include "demo/scene.h"
#include "demo/scene_build.h"
#include "demo/scene_data.h"
#include "demo/texture_pyramid.h"
#include "demo/thrown_light.h"

namespace demo {
namespace {

namespace pl = pipeline;

// Stage 0: texture times light. Opaque, whatever alpha the vertices have, and the texture.
void use_texture(pl::PipelineState& state) {
    pl::TextureStage& stage = state.stages[0];
    stage.color_op          = pl::TextureOp::Modulate;
    stage.alpha_op          = pl::TextureOp::SelectArg2;
    stage.color_arg2        = {.source = pl::ArgSource::Diffuse};
    stage.alpha_arg2        = {.source = pl::ArgSource::TFactor};
    stage.filter            = pl::TextureFilter::Linear;
    stage.mip_filter        = pl::MipFilter::Linear;
}

// Stage 1: times two times a second texture.
void use_detail(pl::PipelineState& state) {
    pl::TextureStage& stage = state.stages[1];
    stage.color_op          = pl::TextureOp::Modulate2X;
    stage.alpha_op          = pl::TextureOp::SelectArg2;
    stage.coords            = pl::CoordSource::Vertex1;
    stage.filter            = pl::TextureFilter::Linear;
    stage.mip_filter        = pl::MipFilter::Linear;
}

// Rock comes through the ground, where it is bare first.
void blend_by_texture(pl::PipelineState& state) {
    state.blend                = pl::kAlphaOver;
    state.stages[0].alpha_op   = pl::TextureOp::Modulate4X;
    state.stages[0].alpha_arg2 = {.source = pl::ArgSource::Diffuse};
}

SceneDescription in_weather(const SceneDescription& description, double seconds) {
    SceneDescription now    = description;
    const WeatherPath& path = description.weather;
    now.weather             = {};
    const auto set          = [&](const Track<Vec3>& track, Vec3& value) {
        if (!track.empty()) value = track.linear(seconds);
    };
    set(path.to_sun, now.light.to_sun);
    // Between opposite suns there is none.
    const float length = glm::length(now.light.to_sun);
    now.light.to_sun   = length > 1e-3f ? now.light.to_sun / length : description.light.to_sun;
    set(path.sun, now.light.sun);
    set(path.sky, now.light.sky);
    set(path.bounce, now.light.bounce);
    set(path.zenith, now.sky.zenith);
    set(path.horizon, now.sky.horizon);
    set(path.glow, now.sky.glow);
    return now;
}

class SceneFrame {
  public:
    SceneFrame(const Scene& scene, Size size, int index, const FrameOptions& options)
        : scene_(scene),
          about_(scene.description),
          geometry_(scene.geometry),
          options_(options),
          seconds_(index / about_.fps) {
        const auto width = static_cast<std::int32_t>(size.width), height = static_cast<std::int32_t>(size.height);
        eye_ = eye_at(about_.camera, index, seconds_);
        pl::Camera camera{.name       = "scene",
                          .view       = look_at(eye_, target_at(about_.camera, seconds_)),
                          .projection = perspective(about_.camera.vfov_deg, static_cast<double>(width) / height,
                                                    about_.camera.near_m, about_.camera.far_m)};
        // x / w grows by 2 shift / width; w is -z.
        camera.projection[2][0] -= 2.0f * options.shift_px.x / static_cast<float>(width);
        camera.projection[2][1] += 2.0f * options.shift_px.y / static_cast<float>(height);
        view_          = {.eye        = eye_,
                          .view       = camera.view,
                          .projection = camera.projection,
                          .width      = width,
                          .height     = height,
                          .near_m     = static_cast<float>(about_.camera.near_m)};
        frame_.output  = {0};
        frame_.targets = {{"back buffer", pl::TargetFormat::A8R8G8B8, width, height},
                          {"depth", pl::TargetFormat::D24, width, height}};
        frame_.cameras.push_back(camera);
        frame_.textures = geometry_.textures;
        frame_.vertices = geometry_.vertices;
        frame_.indices  = geometry_.indices;
    }

    pl::Frame build() && {
        if (!geometry_.terrain.empty()) terrain();
        solids("solids", geometry_.solids_behind);
        throw_light(0, frame_.passes.size());
        sky();
        frame_.passes.front().clear = {.color = fog_color(), .depth = 1.0f};
        const bool clouds_last      = are_order_free();
        if (clouds_last) objects_in_front();
        const std::size_t first_cloud_pass = frame_.passes.size();
        clouds();
        const std::size_t end_cloud_pass = frame_.passes.size();
        if (!clouds_last) objects_in_front();
        if (options_.flat_scene)
            for (std::size_t i = 0; i < frame_.passes.size(); ++i)
                if (i < first_cloud_pass || i >= end_cloud_pass) flatten(frame_.passes[i]);
        return std::move(frame_);
    }

  private:
    pl::Pass& add_pass(std::string label) {
        frame_.passes.push_back({.label  = std::move(label),
                                 .color  = {0},
                                 .depth  = {1},
                                 .camera = {0},
                                 .clear  = {},
                                 .state  = {},
                                 .draws  = {}});
        return frame_.passes.back();
    }

    // Opaque, in the one colour.
    void flatten(pl::Pass& pass) {
        pass.state.blend  = pl::kReplace;
        pass.state.fog    = {};
        pass.state.stages = {};
        if (pass.clear.color) pass.clear.color = to_argb(*options_.flat_scene);
        for (std::size_t i = 0; i < geometry_.vertices.size(); ++i)
            frame_.vertices[i].diffuse = to_argb(*options_.flat_scene);
        for (pl::Draw& draw : pass.draws)
            if (auto* triangles = std::get_if<pl::DrawTriangles>(&draw)) triangles->textures = {};
    }

    // Those that change are baked anew; of these the fractal stays.
    cloud::BakedCloud baked_now(const SceneCloud& cloud) const {
        cloud::BakedCloud baked = cloud.baked;
        if (moves(cloud.plan)) {
            cloud::Cloud now = cloud_at(cloud, seconds_);
            if (reshapes(cloud.plan))
                baked = bake_cloud(about_, now, &cloud.baked);
            else
                baked.cloud = std::move(now);
        }
        if (options_.mode && *options_.mode != baked.cloud.mode) {
            baked.cloud.mode = *options_.mode;
            baked            = bake_cloud(about_, baked.cloud);  // each mode has its own code in the fractal
        }
        if (options_.order) baked.cloud.order = *options_.order;
        if (!options_.has_detail) baked.cloud.detail = cloud::Detail::None;
        return baked;
    }

    bool are_order_free() const {
        if (options_.order) return *options_.order == cloud::Order::OrderFree;
        return std::all_of(scene_.clouds.begin(), scene_.clouds.end(),
                           [](const SceneCloud& cloud) { return cloud.grown.order == cloud::Order::OrderFree; });
    }

    void clouds() {
        if (!options_.has_clouds) return;
        std::vector<cloud::BakedCloud> clouds;
        for (std::size_t i = 0; i < scene_.clouds.size(); ++i)
            if (!options_.only_cloud || *options_.only_cloud == i) clouds.push_back(baked_now(scene_.clouds[i]));
        std::erase_if(clouds, [](const cloud::BakedCloud& cloud) { return cloud.cloud.particles.empty(); });
        if (clouds.empty()) return;
        const cloud::SceneTargets targets{.back_buffer = {0}, .depth = {1}, .camera = {0}, .fog = fog()};
        switch (options_.technique) {
            case Technique::MegaParticles:
                return cloud::append_mega_particles(frame_, targets, view_, cloud::merge_touching(std::move(clouds)),
                                                    options_.mega_particles);
            case Technique::Sprites:
                return cloud::append_sprite_clouds(frame_, targets, view_, clouds);
            case Technique::Slices:
                return cloud::append_slice_clouds(frame_, targets, view_, clouds);
        }
    }

    pl::DrawTriangles draw_of(const TexturedRange& range, int second_texture) const {
        pl::DrawTriangles draw{
            .first_index = range.first_index, .index_count = range.index_count, .world = Mat4(1.0f), .textures = {}};
        draw.textures[0].texture = {range.texture};
        draw.textures[1].texture = {second_texture};
        return draw;
    }

    // The dome goes with the eye, behind all else: last of what is opaque, where nothing nearer hides it. It is as far
    // as the camera sees in any direction.
    void sky() {
        pl::Pass& pass   = add_pass("sky");
        pass.state.depth = {.func = pl::CompareFunc::LessEqual, .write = false};
        for (const TexturedRange& range : {geometry_.sky, geometry_.stars}) {
            if (range.index_count == 0) continue;
            pl::DrawTriangles dome = draw_of(range, -1);
            dome.world             = Mat4(static_cast<float>(0.999 * about_.camera.far_m));
            dome.world[3]          = pipeline::Vec4(eye_, 1.0f);
            pass.draws.emplace_back(dome);
        }
    }

    // Near blocks first, so that what they hide costs a depth test only; walls before the ground, which takes two
    // textures.
    void terrain() {
        const TerrainBlocks& terrain                  = geometry_.terrain;
        const pl::Camera& camera                      = frame_.cameras[0];
        const std::vector<const TerrainBlock*> blocks = visible_blocks(terrain, eye_, camera.view, camera.projection);
        const auto add_layer = [&](const char* label, std::vector<std::uint32_t> TerrainBlock::*layer, int texture,
                                   int second_texture) -> pl::PipelineState& {
            const std::size_t first = frame_.indices.size();
            for (const TerrainBlock* block : blocks) {
                const std::vector<std::uint32_t>& indices = block->*layer;
                frame_.indices.insert(frame_.indices.end(), indices.begin(), indices.end());
            }
            const TexturedRange range{static_cast<std::uint32_t>(first),
                                      static_cast<std::uint32_t>(frame_.indices.size() - first), texture};
            pl::Pass& pass = add_pass(label);
            set_solid_state(pass.state);
            use_texture(pass.state);
            if (range.index_count > 0) pass.draws.emplace_back(draw_of(range, second_texture));
            return pass.state;
        };
        add_layer("walls", &TerrainBlock::walls, terrain.rock_texture, -1);
        use_detail(add_layer("ground", &TerrainBlock::ground, terrain.ground_texture, terrain.detail_texture));
        pl::PipelineState& overlays = add_layer("walls over ground", &TerrainBlock::overlays, terrain.rock_texture, -1);
        blend_by_texture(overlays);
        overlays.depth.write = false;  // it is there already
    }

    void solids(const char* label, const std::vector<MovingRange>& ranges) {
        if (ranges.empty()) return;
        pl::Pass& pass = add_pass(label);
        set_solid_state(pass.state);
        use_texture(pass.state);
        for (const MovingRange& moving : ranges) {
            pl::DrawTriangles draw = draw_of(moving.range, -1);
            draw.world[3]          = pipeline::Vec4(moving.velocity * static_cast<float>(seconds_), 1.0f);
            pass.draws.emplace_back(draw);
        }
    }

    void objects_in_front() {
        const std::size_t first = frame_.passes.size();
        solids("objects in front", geometry_.solids_in_front);
        throw_light(first, frame_.passes.size());
    }

    std::optional<pl::PixelRect> bounds_of(const ThrownLight& light) const {
        cloud::Cloud ball;
        ball.particles.push_back({.center = light.center, .radius = light.range});
        return cloud::screen_bounds(ball, view_, 0, 1);
    }

    // On what these passes drew.
    void throw_light(std::size_t first_pass, std::size_t end_pass) {
        if (options_.flat_scene || first_pass == end_pass) return;
        for (const SceneCloud& cloud : scene_.clouds)
            for (const ThrownLight& light : thrown_lights(cloud.plan, seconds_)) {
                const std::optional<pl::PixelRect> reached = bounds_of(light);
                if (!reached) continue;
                if (!light_texture_) {
                    light_texture_.index = static_cast<std::int32_t>(frame_.textures.size());
                    frame_.textures.push_back(light_texture());
                }
                pl::Pass& pass     = add_pass("light of " + cloud.grown.name);
                pass.state         = thrown_light_state(light, view_.view, fog());
                pass.state.scissor = *reached;
                for (std::size_t i = first_pass; i < end_pass; ++i) {
                    if (!frame_.passes[i].state.depth.write) continue;  // it lies on what is drawn anyway
                    for (pl::Draw draw : frame_.passes[i].draws) {
                        auto& triangles       = std::get<pl::DrawTriangles>(draw);
                        triangles.textures[0] = triangles.textures[1] = {.texture = light_texture_, .target = {}};
                        pass.draws.push_back(draw);
                    }
                }
            }
    }

    void set_solid_state(pl::PipelineState& state) const {
        state.depth = {.func = pl::CompareFunc::LessEqual, .write = true};
        state.cull  = pl::CullMode::Clockwise;  // what shows its back
        state.fog   = fog();
    }

    pl::FogState fog() const {
        return {.mode    = pl::FogMode::Linear,
                .color   = fog_color(),
                .start   = about_.fog.start_m,
                .end     = about_.fog.end_m,
                .density = 1.0f,
                .range   = true};
    }

    pl::Argb fog_color() const { return to_argb(about_.fog.color.value_or(about_.sky.horizon)); }

    const Scene& scene_;
    const SceneDescription& about_;
    const SceneGeometry& geometry_;
    const FrameOptions& options_;
    double seconds_;
    Vec3 eye_ = Vec3(0.0f);
    cloud::View view_;
    pl::TextureId light_texture_;
    pl::Frame frame_;
};

}  // namespace

pipeline::Frame scene_frame(const Scene& scene, Size size, int index, const FrameOptions& wanted) {
    const FrameOptions options = with_precision(wanted);
    if (scene.description.weather.empty()) return SceneFrame(scene, size, index, options).build();
    // New light on everything.
    const Scene relit = build_scene(in_weather(scene.description, index / scene.description.fps));
    return SceneFrame(relit, size, index, options).build();
}

}  // namespace demo
