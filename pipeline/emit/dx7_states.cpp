// SPDX-License-Identifier: MIT
#include "pipeline/emit/dx7_states.h"

#include "pipeline/emit/dx7_text.h"
#include "pipeline/validate/check_pass.h"

namespace pipeline::dx7 {

namespace {

std::string truth(bool value) {
    return value ? "TRUE" : "FALSE";
}

class States {
  public:
    void render(std::string_view name, std::string value) {
        list_.push_back({"D3DRENDERSTATE_" + std::string(name), std::move(value)});
    }
    void stage(int stage, std::string_view name, std::string value) {
        list_.push_back({std::to_string(stage) + ", D3DTSS_" + std::string(name), std::move(value)});
    }
    std::vector<State> take() { return std::move(list_); }

  private:
    std::vector<State> list_;
};

void add_tests(const Pass& pass, States& out) {
    const DepthState depth           = pass.depth ? pass.state.depth : DepthState{};
    const AlphaTestState& alpha_test = pass.state.alpha_test;
    const bool tests_alpha           = alpha_test.func != CompareFunc::Always;
    // D3DZB_FALSE turns off writing as well.
    out.render("ZENABLE", depth == DepthState{} ? "D3DZB_FALSE" : "D3DZB_TRUE");
    out.render("ZWRITEENABLE", truth(depth.write));
    out.render("ZFUNC", constant("D3DCMP_", depth.func));
    out.render("ALPHATESTENABLE", truth(tests_alpha));
    out.render("ALPHAREF", std::to_string(tests_alpha ? alpha_test.reference : 0));
    out.render("ALPHAFUNC", constant("D3DCMP_", alpha_test.func));
}

void add_blend(const BlendState& blend, States& out) {
    out.render("ALPHABLENDENABLE", truth(blend != kReplace));
    out.render("SRCBLEND", constant("D3DBLEND_", blend.source));
    out.render("DESTBLEND", constant("D3DBLEND_", blend.dest));
}

void add_fog(const FogState& state, Geometry geometry, States& out) {
    const FogState fog       = geometry == Geometry::Rectangles || state.mode == FogMode::None ? FogState{} : state;
    // Without a mode the fog is the alpha of a vertex's specular colour.
    const FogMode mode       = geometry == Geometry::Triangles ? fog.mode : FogMode::None;
    const FogState by_vertex = mode == FogMode::None ? FogState{} : fog;
    const auto number        = [](float value) { return "as_dword(" + literal(value) + ')'; };
    out.render("FOGENABLE", truth(fog.mode != FogMode::None));
    out.render("FOGCOLOR", literal(fog.color));
    out.render("FOGVERTEXMODE", constant("D3DFOG_", mode));
    out.render("FOGSTART", number(by_vertex.start));
    out.render("FOGEND", number(by_vertex.end));
    out.render("FOGDENSITY", number(by_vertex.density));
    out.render("RANGEFOGENABLE", truth(by_vertex.range));
}

void add_lighting(const LightingState& state, Geometry geometry, States& out) {
    LightingState lighting;
    if (geometry == Geometry::Triangles && state.enabled) lighting = state;
    out.render("LIGHTING", truth(lighting.enabled));
    out.render("SPECULARENABLE", truth(state.specular_enable));
    out.render("LOCALVIEWER", truth(lighting.local_viewer));
    out.render("NORMALIZENORMALS", truth(lighting.normalize_normals));
    out.render("DIFFUSEMATERIALSOURCE", constant("D3DMCS_", lighting.diffuse_source));
    out.render("AMBIENTMATERIALSOURCE", constant("D3DMCS_", lighting.ambient_source));
    out.render("SPECULARMATERIALSOURCE", constant("D3DMCS_", lighting.specular_source));
    out.render("EMISSIVEMATERIALSOURCE", constant("D3DMCS_", lighting.emissive_source));
}

bool reads_first(TextureOp op) {
    return op != TextureOp::Disable && op != TextureOp::SelectArg2;
}
bool reads_second(TextureOp op) {
    return op != TextureOp::Disable && op != TextureOp::SelectArg1;
}

std::string argument(const TextureArg& argument) {
    return constant("D3DTA_", argument.source) + (argument.complement ? " | D3DTA_COMPLEMENT" : "") +
           (argument.alpha_replicate ? " | D3DTA_ALPHAREPLICATE" : "");
}

void add_function(const TextureStage& stage, int index, States& out) {
    const TextureStage plain;
    const auto add = [&](std::string_view name, bool is_read, const TextureArg& own, const TextureArg& other) {
        out.stage(index, name, argument(is_read ? own : other));
    };
    out.stage(index, "COLOROP", constant("D3DTOP_", stage.color_op));
    add("COLORARG1", reads_first(stage.color_op), stage.color_arg1, plain.color_arg1);
    add("COLORARG2", reads_second(stage.color_op), stage.color_arg2, plain.color_arg2);
    out.stage(index, "ALPHAOP", constant("D3DTOP_", stage.alpha_op));
    add("ALPHAARG1", reads_first(stage.alpha_op), stage.alpha_arg1, plain.alpha_arg1);
    add("ALPHAARG2", reads_second(stage.alpha_op), stage.alpha_arg2, plain.alpha_arg2);
}

std::string coordinates(CoordSource source, int index, Geometry geometry) {
    if (geometry != Geometry::Triangles) return std::to_string(index);
    switch (source) {
        case CoordSource::Vertex0:
            return "0";
        case CoordSource::Vertex1:
            return "1";
        case CoordSource::CameraPosition:
            return "D3DTSS_TCI_CAMERASPACEPOSITION";
    }
    return "0";
}

void add_sampling(const TextureStage& stage, bool is_read, int index, Geometry geometry, States& out) {
    TextureStage sampled;
    if (is_read) sampled = stage;
    const bool projects = geometry == Geometry::Triangles && sampled.coords == CoordSource::CameraPosition;
    out.stage(index, "MAGFILTER", constant("D3DTFG_", sampled.filter));
    out.stage(index, "MINFILTER", constant("D3DTFN_", sampled.filter));
    out.stage(index, "MIPFILTER", constant("D3DTFP_", sampled.mip_filter));
    out.stage(index, "ADDRESSU", constant("D3DTADDRESS_", sampled.address_u));
    out.stage(index, "ADDRESSV", constant("D3DTADDRESS_", sampled.address_v));
    out.stage(index, "TEXCOORDINDEX", is_read ? coordinates(stage.coords, index, geometry) : std::to_string(index));
    out.stage(index, "TEXTURETRANSFORMFLAGS", projects ? "D3DTTFF_COUNT3 | D3DTTFF_PROJECTED" : "D3DTTFF_DISABLE");
}

}  // namespace

std::vector<State> states_of(const Pass& pass, Geometry geometry) {
    const PipelineState& state = pass.state;
    States out;
    add_tests(pass, out);
    add_blend(state.blend, out);
    out.render("CULLMODE", constant("D3DCULL_", geometry == Geometry::Rectangles ? CullMode::None : state.cull));
    out.render("SHADEMODE", constant("D3DSHADE_", state.shade));
    add_fog(state.fog, geometry, out);
    out.render("TEXTUREFACTOR", literal(state.texture_factor));
    add_lighting(state.lighting, geometry, out);
    const int count = stage_count(state);
    for (int i = 0; i < kTextureStages; ++i) {
        const TextureStage off;
        add_function(i < count ? state.stages[static_cast<std::size_t>(i)] : off, i, out);
        add_sampling(state.stages[static_cast<std::size_t>(i)], reads_texture(state, i), i, geometry, out);
    }
    return out.take();
}

std::vector<State> reset_states() {
    std::vector<State> states = states_of({}, Geometry::Triangles);
    for (const State& other : std::initializer_list<State>{
             {"D3DRENDERSTATE_AMBIENT", "0x00000000"},
             {"D3DRENDERSTATE_COLORVERTEX", "TRUE"},
             {"D3DRENDERSTATE_FOGTABLEMODE", "D3DFOG_NONE"},
             {"D3DRENDERSTATE_FILLMODE", "D3DFILL_SOLID"},
             {"D3DRENDERSTATE_TEXTUREPERSPECTIVE", "TRUE"},
             {"D3DRENDERSTATE_CLIPPING", "TRUE"},
             {"D3DRENDERSTATE_CLIPPLANEENABLE", "0"},
             {"D3DRENDERSTATE_DITHERENABLE", "FALSE"},
             {"D3DRENDERSTATE_ANTIALIAS", "D3DANTIALIAS_NONE"},
             {"D3DRENDERSTATE_STENCILENABLE", "FALSE"},
             {"D3DRENDERSTATE_COLORKEYENABLE", "FALSE"},
             {"D3DRENDERSTATE_VERTEXBLEND", "D3DVBLEND_DISABLE"},
             {"D3DRENDERSTATE_ZBIAS", "0"},
             {"D3DRENDERSTATE_WRAP0", "0"},
             {"D3DRENDERSTATE_WRAP1", "0"},
         })
        states.push_back(other);
    return states;
}

std::string set_state(const State& state) {
    const bool is_stage = state.name.find(',') != std::string::npos;
    return std::string("TRY(device->") + (is_stage ? "SetTextureStageState(" : "SetRenderState(") + state.name + ", " +
           state.value + "));";
}

bool reads_specular_alpha(const PipelineState& state) {
    const auto reads = [](TextureOp op, const TextureArg& arg1, const TextureArg& arg2, bool is_alpha) {
        const auto is_alpha_of_it = [&](const TextureArg& arg) {
            return arg.source == ArgSource::Specular &&
                   (is_alpha || arg.alpha_replicate || op == TextureOp::ModulateColorAddAlpha);
        };
        return (reads_first(op) && is_alpha_of_it(arg1)) || (reads_second(op) && is_alpha_of_it(arg2));
    };
    for (int i = 0; i < stage_count(state); ++i) {
        const TextureStage& stage = state.stages[static_cast<std::size_t>(i)];
        if (reads(stage.color_op, stage.color_arg1, stage.color_arg2, false) ||
            reads(stage.alpha_op, stage.alpha_arg1, stage.alpha_arg2, true))
            return true;
    }
    return false;
}

}  // namespace pipeline::dx7
