// SPDX-License-Identifier: MIT
#include "pipeline/check/idle_state.h"

#include <algorithm>

#include "pipeline/check/target_use.h"

namespace pipeline {
namespace {

bool has_alpha(TargetFormat format) {
    return format != TargetFormat::X8R8G8B8 && format != TargetFormat::R5G6B5 && format != TargetFormat::Psmct24;
}

bool reads_first(TextureOp op) {
    return op != TextureOp::Disable && op != TextureOp::SelectArg2;
}
bool reads_second(TextureOp op) {
    return op != TextureOp::Disable && op != TextureOp::SelectArg1;
}
bool reads(TextureOp op, const TextureArg& arg1, const TextureArg& arg2, ArgSource source) {
    if (op == TextureOp::BlendDiffuseAlpha && source == ArgSource::Diffuse) return true;
    if (op == TextureOp::BlendCurrentAlpha && source == ArgSource::Current) return true;
    return (reads_first(op) && arg1.source == source) || (reads_second(op) && arg2.source == source);
}
bool reads(const TextureStage& stage, ArgSource source) {
    return reads(stage.color_op, stage.color_arg1, stage.color_arg2, source) ||
           reads(stage.alpha_op, stage.alpha_arg1, stage.alpha_arg2, source);
}

// Is what it gives the same by every rule?
bool is_exact(TextureOp op) {
    return op == TextureOp::Disable || op == TextureOp::SelectArg1 || op == TextureOp::SelectArg2 ||
           op == TextureOp::Add || op == TextureOp::Subtract;
}

// What a pass does, as far as its state and what it draws tell.
class PassWork {
  public:
    PassWork(const Frame& frame, const Pass& pass)
        : frame_(frame), pass_(pass), state_(pass.state), stages_(stage_count(pass.state)) {
        for (const Draw& draw : pass.draws) {
            in_object_space = in_object_space || std::holds_alternative<DrawTriangles>(draw);
            draws_in_window = draws_in_window || std::holds_alternative<DrawWindowTriangles>(draw);
        }
        const Target* target    = find_target(frame, pass.color);
        const ColorMask& mask   = state_.color_mask;
        has_dest_alpha          = target != nullptr && has_alpha(target->format);
        writes_rgb              = target != nullptr && (mask.red || mask.green || mask.blue);
        const bool writes_alpha = has_dest_alpha && mask.alpha;
        writes_color            = pipeline::draws(pass) && (writes_rgb || writes_alpha);
        const bool tests_alpha  = state_.alpha_test.func != CompareFunc::Always;
        makes_color             = pipeline::draws(pass) && (writes_color || tests_alpha);
        const bool keeps        = target == nullptr || keeps_bytes(target->format);
        cuts                    = writes_color && !keeps;
    }

    bool in_object_space = false, draws_in_window = false;  // triangles
    bool has_dest_alpha = false, writes_rgb = false, writes_color = false, makes_color = false;
    bool cuts = false;  // the target keeps less than is written

    bool draws_triangles() const { return in_object_space || draws_in_window; }
    bool fogs() const { return draws_triangles() && makes_color && writes_rgb && state_.fog.mode != FogMode::None; }
    bool lights() const { return in_object_space && makes_color && state_.lighting.enabled; }
    bool adds_specular() const { return draws_triangles() && makes_color && state_.lighting.specular_enable; }
    bool reads_diffuse() const {
        return makes_color &&
               (stages_ == 0 || reads(state_.stages[0], ArgSource::Current) || any_stage_reads(ArgSource::Diffuse));
    }
    bool reads_specular() const { return adds_specular() || (makes_color && any_stage_reads(ArgSource::Specular)); }
    bool highlights() const {
        return lights() && state_.lighting.specular_enable &&
               std::any_of(state_.lighting.lights.begin(), state_.lighting.lights.end(),
                           [](const Light& light) { return light.specular != Vec3(0.0f); });
    }
    bool reads_ambient() const {
        return lights() && (state_.lighting.ambient != Vec3(0.0f) ||
                            std::any_of(state_.lighting.lights.begin(), state_.lighting.lights.end(),
                                        [](const Light& light) { return light.ambient != Vec3(0.0f); }));
    }
    bool blends() const {
        if (!writes_color) return false;
        return frame_.arithmetic.blend == BlendRule::GsShift7 ? state_.gs_blend != GsBlend{}
                                                              : state_.blend != BlendState{};
    }

    // A stage that reads something other than white. with_levels: of more than one level.
    bool samples(int stage, bool with_levels = false) const {
        if (!makes_color) return false;
        bool found = false;
        for_each_texture(pass_, [&](std::size_t, std::size_t at, const TextureBinding& binding) {
            const Texture* texture = find_texture(frame_, binding.texture);
            if (at == static_cast<std::size_t>(stage) && (!with_levels || (texture != nullptr && texture->levels > 1)))
                found = true;
        });
        return found;
    }
    bool filters() const {
        for (int i = 0; i < stages_; ++i) {
            const TextureStage& stage = state_.stages[static_cast<std::size_t>(i)];
            if ((stage.filter == TextureFilter::Linear && samples(i)) ||
                (stage.mip_filter == MipFilter::Linear && samples(i, true)))
                return true;
        }
        return false;
    }
    bool rounds_in_stages() const {
        return makes_color &&
               std::any_of(state_.stages.begin(), state_.stages.begin() + stages_,
                           [](const auto& stage) { return !is_exact(stage.color_op) || !is_exact(stage.alpha_op); });
    }
    // As a colour of what is lit, or as it is.
    bool reads_color(ColorSource source) const {
        if (!in_object_space) return false;
        if (!lights()) return source == ColorSource::Color1 ? reads_diffuse() : reads_specular();
        const LightingState& lighting = state_.lighting;
        return (reads_diffuse() && (lighting.diffuse_source == source || lighting.emissive_source == source ||
                                    (reads_ambient() && lighting.ambient_source == source))) ||
               (highlights() && lighting.specular_source == source);
    }
    bool reads_coords(CoordSource source) const {
        for (int i = 0; i < stages_; ++i)
            if (in_object_space && samples(i) && state_.stages[static_cast<std::size_t>(i)].coords == source)
                return true;
        return false;
    }

    int stages() const { return stages_; }

  private:
    bool any_stage_reads(ArgSource source) const {
        return std::any_of(state_.stages.begin(), state_.stages.begin() + stages_,
                           [&](const TextureStage& stage) { return reads(stage, source); });
    }

    const Frame& frame_;
    const Pass& pass_;
    const PipelineState& state_;
    int stages_;
};

void take_idle_blend(const PassWork& work, BlendRule rule, const PipelineState& other, PipelineState& state) {
    if (!work.writes_color || rule == BlendRule::GsShift7) state.blend = other.blend;
    if (!work.writes_color || rule != BlendRule::GsShift7) state.gs_blend = other.gs_blend;
    if (!work.writes_color) state.dither = other.dither;
    const bool dithers = work.cuts && state.dither.mode != DitherMode::None;
    if (!dithers || state.dither.mode != DitherMode::GsDimx) state.dither.matrix = other.dither.matrix;
    if (!work.cuts) state.dither.mode = other.dither.mode;
    if (!work.has_dest_alpha) state.color_mask.alpha = other.color_mask.alpha;
    if (!work.writes_color || rule != BlendRule::GsShift7) return;

    GsBlend& blend = state.gs_blend;
    if (blend.a == blend.b) blend.c = other.gs_blend.c;
    if (blend.a == blend.b || blend.c != GsAlpha::Fix) blend.fix = other.gs_blend.fix;
    if (blend.a == blend.b && blend.d == GsColor::Cs) blend.pabe = other.gs_blend.pabe;
    if (blend.a == blend.b && !dithers) blend.colclamp = other.gs_blend.colclamp;
    if (!work.has_dest_alpha) blend.fba = other.gs_blend.fba;
}

// A stage's ops stay: where the chain ends matters as long as there is one.
void take_idle_stage(const PassWork& work, int index, const TextureStage& other, TextureStage& stage) {
    const bool is_on = index < work.stages();
    if (!is_on || !reads_first(stage.color_op)) stage.color_arg1 = other.color_arg1;
    if (!is_on || !reads_second(stage.color_op)) stage.color_arg2 = other.color_arg2;
    if (!is_on || !reads_first(stage.alpha_op)) stage.alpha_arg1 = other.alpha_arg1;
    if (!is_on || !reads_second(stage.alpha_op)) stage.alpha_arg2 = other.alpha_arg2;
    stage.alpha_arg1.alpha_replicate = other.alpha_arg1.alpha_replicate;
    stage.alpha_arg2.alpha_replicate = other.alpha_arg2.alpha_replicate;
    if (!work.samples(index)) {
        stage.filter    = other.filter;
        stage.address_u = other.address_u;
        stage.address_v = other.address_v;
    }
    if (!work.samples(index, true)) stage.mip_filter = other.mip_filter;
    if (!work.in_object_space || !work.samples(index)) stage.coords = other.coords;
    if (!work.reads_coords(CoordSource::CameraPosition)) stage.transform = other.transform;
}

void take_idle_lighting(const PassWork& work, const LightingState& other, LightingState& lighting) {
    if (!work.draws_triangles() || !work.makes_color) lighting.specular_enable = other.specular_enable;
    if (!work.in_object_space || !work.makes_color) lighting.enabled = other.enabled;
    if (!work.lights()) {
        const bool enabled = lighting.enabled, specular_enable = lighting.specular_enable;
        lighting                 = other;
        lighting.enabled         = enabled;
        lighting.specular_enable = specular_enable;
        return;
    }
    if (!work.highlights()) {
        lighting.local_viewer      = other.local_viewer;
        lighting.specular_source   = other.specular_source;
        lighting.material.specular = other.material.specular;
        lighting.material.power    = other.material.power;
    }
    if (!work.reads_ambient()) lighting.ambient_source = other.ambient_source;
    if (lighting.lights.empty()) lighting.normalize_normals = other.normalize_normals;
}

void take_idle_fog(const PassWork& work, const FogState& other, FogState& fog) {
    if (!work.draws_triangles() || !work.makes_color || !work.writes_rgb) fog.mode = other.mode;
    if (!work.fogs()) fog.color = other.color;
    const bool is_made = work.fogs() && work.in_object_space;  // else vertices have it
    if (!is_made) fog.range = other.range;
    if (!is_made || fog.mode != FogMode::Linear) fog.start = other.start, fog.end = other.end;
    if (!is_made || fog.mode == FogMode::Linear) fog.density = other.density;
}

}  // namespace

PipelineState with_idle_state_of(const Frame& frame, const Pass& pass, const PipelineState& other) {
    PipelineState state = pass.state;
    const PassWork work(frame, pass);
    if (!draws(pass)) {
        state          = other;
        state.viewport = pass.state.viewport;
        state.scissor  = pass.state.scissor;
        return state;
    }
    take_idle_fog(work, other.fog, state.fog);
    take_idle_blend(work, frame.arithmetic.blend, other, state);
    take_idle_lighting(work, other.lighting, state.lighting);
    if (!pass.color) state.color_mask = other.color_mask, state.dest_alpha_test = other.dest_alpha_test;
    if (!pass.depth) state.depth = other.depth;
    if (state.alpha_test.func == CompareFunc::Always) {
        state.alpha_test.reference = other.alpha_test.reference;
        state.alpha_test.fail      = other.alpha_test.fail;
    }
    if (!work.draws_triangles()) state.cull = other.cull;
    if (!work.draws_triangles() || !work.makes_color) state.shade = other.shade;
    if (!work.makes_color) {
        state.texture_factor = other.texture_factor;
        state.stages         = other.stages;
        return state;
    }
    for (int i = 0; i < kTextureStages; ++i)
        take_idle_stage(work, i, other.stages[static_cast<std::size_t>(i)], state.stages[static_cast<std::size_t>(i)]);
    return state;
}

Arithmetic with_idle_rules_of(const Frame& frame, const Arithmetic& other) {
    Arithmetic rules      = other;
    const Arithmetic& own = frame.arithmetic;
    for (const Pass& pass : frame.passes) {
        if (!draws(pass)) continue;
        const PassWork work(frame, pass);
        rules.snap         = own.snap;
        rules.pixel_center = own.pixel_center;
        if (work.draws_triangles() && uses_depth(pass)) rules.vertex_depth = own.vertex_depth;
        if (work.draws_triangles() && work.makes_color) rules.gouraud = own.gouraud;
        if (work.filters()) rules.filter = own.filter;
        if (work.rounds_in_stages()) rules.combine = own.combine;
        if (work.fogs()) rules.fog = own.fog;
        if (work.blends()) rules.blend = own.blend;
        // What is cut before is not dithered.
        const bool dithers = pass.state.dither.mode != DitherMode::None;
        if (work.cuts && (work.blends() || dithers)) rules.blend_source = own.blend_source;
    }
    return rules;
}

bool writes_color(const Frame& frame, const Pass& pass) {
    return PassWork(frame, pass).writes_color;
}

std::vector<std::string_view> vertex_attributes(const Frame& frame, const Pass& pass) {
    const PassWork work(frame, pass);
    std::vector<std::string_view> names;
    const auto add = [&](bool needed, std::string_view name) {
        if (needed) names.push_back(name);
    };
    add(work.in_object_space, "position");
    add(work.lights() && !pass.state.lighting.lights.empty(), "normal");
    add(work.reads_color(ColorSource::Color1), "diffuse");
    add(work.reads_color(ColorSource::Color2), "specular");
    add(work.reads_coords(CoordSource::Vertex0), "uv0");
    add(work.reads_coords(CoordSource::Vertex1), "uv1");
    return names;
}

}  // namespace pipeline
