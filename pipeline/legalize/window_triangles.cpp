// SPDX-License-Identifier: MIT
#include "pipeline/legalize/window_triangles.h"

#include <algorithm>
#include <span>

#include "pipeline/check/target_use.h"
#include "pipeline/execute/window_triangles.h"
#include "pipeline/legalize/window_map.h"

namespace pipeline {

namespace {

// Of unsigned coordinates of 12.4 bits around a target of up to 2048 pixels, whose offset the program chooses.
constexpr float kGuardBandPx = 1024.0f;

PixelRect common(const PixelRect& a, const PixelRect& b) {
    return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

// What stands in a pass's state once its vertices say the rest.
void drop_vertex_state(const Frame& frame, Pass& pass) {
    PipelineState& state = pass.state;
    if (state.viewport != PixelRect{}) {
        const PixelRect limit = state.scissor == PixelRect{} ? state.viewport : common(state.viewport, state.scissor);
        const Target& target  = *find_target(frame, pass.color ? pass.color : pass.depth);
        if (limit.x0 >= limit.x1 || limit.y0 >= limit.y1) {  // nothing is left, which no scissor says
            pass.clear = {};
            pass.draws.clear();
        }
        const bool is_all = limit == PixelRect{0, 0, target.width, target.height};
        state.scissor     = is_all || pass.draws.empty() ? PixelRect{} : limit;
        state.viewport    = {};
    }
    pass.camera    = {};
    state.lighting = {.specular_enable = state.lighting.specular_enable};
    state.cull     = CullMode::None;
    state.shade    = ShadeMode::Gouraud;
    if (state.fog.mode != FogMode::None) state.fog = {.mode = FogMode::Linear, .color = state.fog.color};
    for (TextureStage& stage : state.stages) {
        stage.coords    = CoordSource::Vertex0;
        stage.transform = Mat4(1.0f);
    }
}

class WindowFrame {
  public:
    explicit WindowFrame(const Frame& frame) : vertices(frame.window_vertices), frame_(frame) {}

    DrawWindowTriangles append(const Pass& pass, const DrawTriangles& draw) {
        const WindowMesh mesh = to_window_triangles(frame_, pass, draw, viewport_of(frame_, pass), kGuardBandPx);
        const auto first      = static_cast<std::uint32_t>(vertices.size());
        const DrawWindowTriangles out{.first_index = static_cast<std::uint32_t>(indices.size()),
                                      .index_count = static_cast<std::uint32_t>(mesh.indices.size()),
                                      .textures    = draw.textures};
        vertices.insert(vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
        for (const std::uint32_t index : mesh.indices) indices.push_back(first + index);
        return out;
    }

    DrawWindowTriangles keep(DrawWindowTriangles draw) {
        const std::span used = std::span(frame_.indices).subspan(draw.first_index, draw.index_count);
        draw.first_index     = static_cast<std::uint32_t>(indices.size());
        indices.insert(indices.end(), used.begin(), used.end());
        return draw;
    }

    std::vector<WindowVertex> vertices;
    std::vector<std::uint32_t> indices;

  private:
    const Frame& frame_;
};

template <class Triangles>
bool has(const Pass& pass) {
    return std::any_of(pass.draws.begin(), pass.draws.end(),
                       [](const Draw& draw) { return std::holds_alternative<Triangles>(draw); });
}

}  // namespace

Frame rewrite_window_triangles(Frame frame, const Profile& profile, RewriteNotes& notes) {
    const auto has_both = [](const Pass& pass) { return has<DrawTriangles>(pass) && has<DrawWindowTriangles>(pass); };
    if (profile.states.transforms || std::none_of(frame.passes.begin(), frame.passes.end(), &has<DrawTriangles>) ||
        std::any_of(frame.passes.begin(), frame.passes.end(), has_both))
        return frame;
    WindowFrame window(frame);
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        Pass& pass              = frame.passes[i];
        const bool is_rewritten = has<DrawTriangles>(pass);
        for (Draw& draw : pass.draws) {
            if (const auto* triangles = std::get_if<DrawTriangles>(&draw))
                draw = window.append(pass, *triangles);
            else if (const auto* kept = std::get_if<DrawWindowTriangles>(&draw))
                draw = window.keep(*kept);
        }
        if (!is_rewritten) continue;
        drop_vertex_state(frame, pass);
        notes.push_back({"window_triangles", place_of(frame, i), "the chip takes triangles in window space alone",
                         "window_triangles, transformed, lit, clipped and culled"});
    }
    for (Pass& pass : frame.passes) pass.camera = {};
    frame.window_vertices = std::move(window.vertices);
    frame.indices         = std::move(window.indices);
    frame.vertices.clear();
    frame.cameras.clear();
    return frame;
}

}  // namespace pipeline
