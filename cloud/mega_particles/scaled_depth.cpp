// SPDX-License-Identifier: MIT
#include "cloud/mega_particles/scaled_depth.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace cloud {

using namespace pipeline;

namespace {

class Scaled {
  public:
    Scaled(Frame& frame, const SceneTargets& scene, int level, int width, int height)
        : frame_(frame), from_(frame.targets[static_cast<std::size_t>(scene.depth.index)]), scale_(1 << level) {
        small_       = from_;
        small_.name  = from_.name + " 1/" + std::to_string(scale_);
        small_.width = width, small_.height = height;
        depth_ = {static_cast<std::int32_t>(frame.targets.size())};
        frame.targets.push_back(small_);
    }

    TargetId depth() const { return depth_; }

    // Through `viewport` of the picture; all of it if that is zero.
    CameraId camera(CameraId of, PixelRect viewport) {
        if (viewport == PixelRect{}) viewport = {0, 0, from_.width, from_.height};
        const auto known = std::find_if(cameras_.begin(), cameras_.end(), [&](const ScaledCamera& camera) {
            return camera.of == of && camera.viewport == viewport;
        });
        if (known != cameras_.end()) return known->scaled;
        Camera scaled = frame_.cameras[static_cast<std::size_t>(of.index)];
        scaled.name += " 1/" + std::to_string(scale_);
        // (1 + x/w) / 2 of the viewport is a pixel of the picture; that over `scale` is one of the small target.
        const auto width  = static_cast<float>(small_.width * scale_),
                   height = static_cast<float>(small_.height * scale_);
        Mat4 to_small(1.0f);
        to_small[0][0]    = static_cast<float>(viewport.x1 - viewport.x0) / width;
        to_small[3][0]    = static_cast<float>(viewport.x0 + viewport.x1) / width - 1.0f;
        to_small[1][1]    = static_cast<float>(viewport.y1 - viewport.y0) / height;
        to_small[3][1]    = 1.0f - static_cast<float>(viewport.y0 + viewport.y1) / height;
        scaled.projection = to_small * scaled.projection;
        cameras_.push_back({of, viewport, {static_cast<std::int32_t>(frame_.cameras.size())}});
        frame_.cameras.push_back(scaled);
        return cameras_.back().scaled;
    }

    // The pixels whose centres lie in that part of the picture.
    PixelRect area(const PixelRect& rect) const {
        const auto first_from = [&](int edge) { return (std::max(edge, 0) + (scale_ - 1) / 2) / scale_; };
        return {first_from(rect.x0), first_from(rect.y0), std::min(first_from(rect.x1), small_.width),
                std::min(first_from(rect.y1), small_.height)};
    }

    Pass pass(const Pass& full, const PixelRect& needed) {
        Pass small;
        small.label       = full.label + ", depth at 1/" + std::to_string(scale_);
        small.depth       = depth_;
        small.clear.depth = full.clear.depth;
        PixelRect within  = area(needed);
        for (const PixelRect& limit : {full.state.viewport, full.state.scissor})
            if (limit != PixelRect{}) within = common(within, area(limit));
        small.state.scissor = within;
        if (within.x0 >= within.x1 || within.y0 >= within.y1) return {};
        if (!full.state.depth.write) return small;
        if (full.state.dest_alpha_test != DestAlphaTest::Off)
            throw std::invalid_argument("target_scale: pass \"" + full.label +
                                        "\" writes depth where the back buffer has alpha");
        if (full.camera) small.camera = camera(full.camera, full.state.viewport);
        const bool tests_alpha = full.state.alpha_test.func != CompareFunc::Always;
        if (tests_alpha) {
            small.state          = full.state;
            small.state.scissor  = within;
            small.state.viewport = {};
        } else {
            small.state.depth = full.state.depth;
            small.state.cull  = full.state.cull;
        }
        for (const Draw& draw : full.draws)
            if (std::optional<Draw> copy = scaled(draw)) {
                if (TextureBindings* bindings = bindings_of(*copy); bindings && !tests_alpha) *bindings = {};
                small.draws.push_back(std::move(*copy));
            }
        return small;
    }

  private:
    struct ScaledCamera {
        CameraId of;
        PixelRect viewport;
        CameraId scaled;
    };

    static PixelRect common(const PixelRect& a, const PixelRect& b) {
        return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
    }

    std::optional<Draw> scaled(const Draw& draw) {
        const float times = 1.0f / static_cast<float>(scale_);
        if (const auto* rectangle = std::get_if<DrawRectangle>(&draw)) {
            DrawRectangle small = *rectangle;
            for (float* edge : {&small.x0, &small.y0, &small.x1, &small.y1}) *edge *= times;
            return small;
        }
        if (const auto* triangles = std::get_if<DrawWindowTriangles>(&draw)) {
            DrawWindowTriangles small = *triangles;
            small.first_index         = static_cast<std::uint32_t>(frame_.indices.size());
            for (std::uint32_t i = 0; i < triangles->index_count; ++i) {
                WindowVertex vertex = frame_.window_vertices[frame_.indices[triangles->first_index + i]];
                vertex.x *= times, vertex.y *= times;
                frame_.indices.push_back(static_cast<std::uint32_t>(frame_.window_vertices.size()));
                frame_.window_vertices.push_back(vertex);
            }
            return small;
        }
        if (std::holds_alternative<DrawTriangles>(draw)) return draw;
        return std::nullopt;  // a copy has no depth
    }

    Frame& frame_;
    Target from_, small_;
    TargetId depth_;
    int scale_;
    std::vector<ScaledCamera> cameras_;
};

}  // namespace

ScaledDepth append_scaled_depth(Frame& frame, const SceneTargets& scene, int level, int width, int height,
                                const PixelRect& area) {
    Scaled scaled(frame, scene, level, width, height);
    std::vector<Pass> passes;
    for (const Pass& pass : frame.passes)
        if (pass.depth == scene.depth && (pass.clear.depth || pass.state.depth.write))
            if (Pass small = scaled.pass(pass, area); small.depth) passes.push_back(std::move(small));
    for (Pass& pass : passes) frame.passes.push_back(std::move(pass));
    return {scaled.depth(), scaled.camera(scene.camera, {})};
}

}  // namespace cloud
