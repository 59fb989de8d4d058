// SPDX-License-Identifier: MIT
#include "pipeline/emit/dx7_pass.h"

#include <algorithm>
#include <optional>

#include "pipeline/check/target_use.h"
#include "pipeline/emit/dx7_lighting.h"
#include "pipeline/emit/dx7_states.h"
#include "pipeline/emit/dx7_text.h"

namespace pipeline::dx7 {

namespace {

Geometry geometry_of(const Draw& draw) {
    return std::holds_alternative<DrawTriangles>(draw)         ? Geometry::Triangles
           : std::holds_alternative<DrawWindowTriangles>(draw) ? Geometry::WindowTriangles
                                                               : Geometry::Rectangles;
}

std::string corners(const UvRect& uv) {
    return "{" + list_of({uv.u0, uv.v0, uv.u1, uv.v1}) + "}";
}

class PassText {
  public:
    PassText(const Frame& frame, std::size_t index, const Surfaces& surfaces, const Data& data)
        : frame_(frame), pass_(frame.passes[index]), index_(index), surfaces_(surfaces), data_(data) {}

    std::string take() {
        text_ = "// Pass " + std::to_string(index_) + ' ' + quoted(pass_.label) + "\nstatic void pass_" +
                std::to_string(index_) + "() {\n";
        const bool is_copy_alone = !draws(pass_) && !pass_.clear.color && !pass_.clear.depth;
        if (used().color < 0)
            line("// Nothing is cleared or drawn.");
        else if (!is_copy_alone)
            begin();
        if (draws(pass_)) draw_all();
        for (const Draw& draw : pass_.draws)
            if (const auto* rectangle = std::get_if<CopyRectangle>(&draw)) copy(*rectangle);
        return std::move(text_) + "}\n";
    }

  private:
    const PassSurfaces& used() const { return surfaces_.passes[index_]; }
    static std::string target(int surface) { return "targets[" + std::to_string(surface) + ']'; }

    void line(const std::string& words) { text_ += "    " + words + '\n'; }
    void call(const std::string& words) { line("TRY(device->" + words + ");"); }

    void begin() {
        const Surface& color  = surfaces_.all[static_cast<std::size_t>(used().color)];
        const PixelRect& part = pass_.state.viewport;
        const bool is_whole   = part == PixelRect{};
        const auto number     = [](std::int32_t value) { return ", " + std::to_string(value); };
        line("// to " + quoted(color.name) + (used().depth < 0 ? "" : " with " + quoted(depth_name())));
        line("begin_pass(" + target(used().color) + ", " + (used().depth < 0 ? "nullptr" : target(used().depth)) +
             number(part.x0) + number(part.y0) + number(is_whole ? color.width : part.x1 - part.x0) +
             number(is_whole ? color.height : part.y1 - part.y0) + ");");
        const Clear& clear = pass_.clear;
        if (!clear.color && !clear.depth) return;
        call(std::string("Clear(0, nullptr, ") + (clear.color ? "D3DCLEAR_TARGET" : "") +
             (clear.color && clear.depth ? " | " : "") + (clear.depth ? "D3DCLEAR_ZBUFFER" : "") + ", " +
             literal(clear.color.value_or(Argb{0})) + ", " + literal(clear.depth.value_or(1.0f)) + ", 0)");
    }
    const std::string& depth_name() const { return surfaces_.all[static_cast<std::size_t>(used().depth)].name; }

    void draw_all() {
        current_ = states_of({}, Geometry::Triangles);
        if (draws_triangles(pass_)) set_scene();
        set_states(geometry_of(pass_.draws.front()));
        note_unknown();
        call("BeginScene()");
        for (std::size_t i = 0; i < pass_.draws.size(); ++i) draw(i);
        call("EndScene()");
    }

    // Camera and lights.
    void set_scene() {
        const bool has_camera = std::any_of(pass_.draws.begin(), pass_.draws.end(), [](const Draw& draw) {
            return std::holds_alternative<DrawTriangles>(draw);
        });
        if (!has_camera) return;
        const Camera& camera = frame_.cameras[static_cast<std::size_t>(pass_.camera.index)];
        line("// camera " + quoted(camera.name));
        set_matrix("VIEW", camera.view);
        set_matrix("PROJECTION", camera.projection);
        for (int i = 0; i < stage_count(pass_.state); ++i) {
            const TextureStage& stage = pass_.state.stages[static_cast<std::size_t>(i)];
            if (reads_texture(pass_.state, i) && stage.coords == CoordSource::CameraPosition)
                set_matrix("TEXTURE" + std::to_string(i), stage.transform);
        }
        if (!pass_.state.lighting.enabled) return;
        for (const std::string& words : lighting_calls(pass_.state.lighting)) line(words);
    }

    void set_matrix(const std::string& name, const Mat4& matrix) {
        line("set_transform(D3DTRANSFORMSTATE_" + name + ", {" + list_of(matrix) + "});");
    }

    void set_states(Geometry geometry) {
        std::vector<State> wanted = states_of(pass_, geometry);
        for (std::size_t i = 0; i < wanted.size(); ++i)
            if (wanted[i] != current_[i]) line(set_state(wanted[i]));
        current_ = std::move(wanted);
    }

    void note_unknown() {
        if (reads_specular_alpha(pass_.state) && pass_.state.fog.mode != FogMode::None)
            line("// Not known: the alpha of D3DTA_SPECULAR while that of vertices holds their fog. The frame has 1.");
        const auto is_for_color = [](const TextureStage& stage) {
            return stage.alpha_op == TextureOp::ModulateColorAddAlpha;
        };
        const auto& stages = pass_.state.stages;
        if (std::any_of(stages.begin(), stages.begin() + stage_count(pass_.state), is_for_color))
            line("// Not known: D3DTOP_MODULATECOLOR_ADDALPHA of alpha. The help has it for D3DTSS_COLOROP only.");
    }

    void draw(std::size_t i) {
        const Draw& draw = pass_.draws[i];
        set_states(geometry_of(draw));
        set_textures(textures_of(draw));
        if (const auto* rectangle = std::get_if<DrawRectangle>(&draw)) return draw_rectangle(*rectangle);
        if (const auto* triangles = std::get_if<DrawTriangles>(&draw)) set_world(triangles->world);
        const MeshRange& meshes = data_.draws[index_][i];
        for (std::size_t mesh = 0; mesh < meshes.count; ++mesh)
            line("draw_mesh(" + std::to_string(meshes.first + mesh) + ");");
    }

    void draw_rectangle(const DrawRectangle& draw) {
        line("draw_rectangle(" + list_of({draw.x0, draw.y0, draw.x1, draw.y1, draw.depth}) + ", " +
             literal(draw.color) + ", " + corners(draw.uv[0]) + ", " + corners(draw.uv[1]) + ");");
    }

    void set_world(const Mat4& world) {
        if (world_ && *world_ == world) return;
        world_ = world;
        set_matrix("WORLD", world);
    }

    void set_textures(const TextureBindings& bindings) {
        for (int stage = 0; stage < kTextureStages; ++stage) {
            if (!reads_texture(pass_.state, stage)) continue;
            const auto i                  = static_cast<std::size_t>(stage);
            const TextureBinding& binding = bindings[i];
            if (bound_[i] && *bound_[i] == binding) continue;
            bound_[i]                = binding;
            const std::string number = std::to_string(stage);
            if (binding.texture)
                bind(number, "textures[" + std::to_string(binding.texture.index) + ']',
                     quoted(frame_.textures[static_cast<std::size_t>(binding.texture.index)].name));
            else if (binding.target)
                bind(number, target(binding.target.index),
                     quoted(frame_.targets[static_cast<std::size_t>(binding.target.index)].name));
            else
                bind(number, "white", "nothing is bound");
        }
    }
    void bind(const std::string& stage, const std::string& what, const std::string& name) {
        line("TRY(device->SetTexture(" + stage + ", " + what + "));  // " + name);
    }

    void copy(const CopyRectangle& copy) {
        const PixelRect& from = copy.from;
        const auto number     = [](std::int32_t value) { return std::to_string(value); };
        line("copy(" + target(used().color) + ", " + number(copy.x) + ", " + number(copy.y) + ", " +
             target(copy.source.index) + ", {" + number(from.x0) + ", " + number(from.y0) + ", " + number(from.x1) +
             ", " + number(from.y1) + "});  // " +
             quoted(frame_.targets[static_cast<std::size_t>(copy.source.index)].name));
    }

    const Frame& frame_;
    const Pass& pass_;
    std::size_t index_;
    const Surfaces& surfaces_;
    const Data& data_;
    std::string text_;
    std::vector<State> current_;
    std::optional<Mat4> world_;
    std::array<std::optional<TextureBinding>, kTextureStages> bound_;
};

}  // namespace

std::string pass_function(const Frame& frame, std::size_t pass, const Surfaces& surfaces, const Data& data) {
    return PassText(frame, pass, surfaces, data).take();
}

}  // namespace pipeline::dx7
