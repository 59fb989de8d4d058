// SPDX-License-Identifier: MIT
#include "pipeline/emit/gx_tev.h"

#include <algorithm>

namespace pipeline {

namespace {

constexpr TevUnit kPreviousAlpha{"GX_CA_ZERO", "GX_CA_ZERO", "GX_CA_ZERO", "GX_CA_APREV"};

struct Reads {
    bool argument1 = false, argument2 = false;
};
Reads reads_of(TextureOp op) {
    return {op != TextureOp::Disable && op != TextureOp::SelectArg2,
            op != TextureOp::Disable && op != TextureOp::SelectArg1};
}

ArgSource blend_source(TextureOp op) {
    switch (op) {
        case TextureOp::BlendDiffuseAlpha:
            return ArgSource::Diffuse;
        case TextureOp::BlendTextureAlpha:
            return ArgSource::Texture;
        case TextureOp::BlendFactorAlpha:
            return ArgSource::TFactor;
        default:
            return ArgSource::Current;
    }
}
bool is_blend(TextureOp op) {
    return op == TextureOp::BlendDiffuseAlpha || op == TextureOp::BlendTextureAlpha ||
           op == TextureOp::BlendFactorAlpha || op == TextureOp::BlendCurrentAlpha;
}

// The names of a frame's arguments in one stage.
class Arguments {
  public:
    Arguments(const TextureStage& stage, bool is_first, const TevInputs& inputs, TexelKind texel)
        : is_first_(is_first), is_rectangle_(inputs.is_rectangle), texel_(texel) {
        const auto look = [&](TextureOp op, const TextureArg& arg1, const TextureArg& arg2, bool is_color) {
            const Reads reads = reads_of(op);
            if (reads.argument1) look_at(arg1.source, is_color && !arg1.alpha_replicate);
            if (reads.argument2) look_at(arg2.source, is_color && !arg2.alpha_replicate);
            if (is_blend(op)) look_at(blend_source(op), false);
        };
        look(stage.color_op, stage.color_arg1, stage.color_arg2, true);
        look(stage.alpha_op, stage.alpha_arg1, stage.alpha_arg2, false);
    }

    bool reads_diffuse() const { return reads_diffuse_; }
    bool reads_specular() const { return reads_specular_; }
    bool needs_specular_register() const { return reads_diffuse_ && reads_specular_; }
    bool reads_texture() const { return reads_texture_; }

    // For GX_SetTevColorIn.
    std::string_view color(const TextureArg& arg) const {
        if (arg.alpha_replicate) return color_of_alpha(arg.source);
        switch (actual(arg.source)) {
            case ArgSource::Diffuse:
                return "GX_CC_RASC";
            case ArgSource::Current:
                return "GX_CC_CPREV";
            case ArgSource::Texture:
                if (texel_ == TexelKind::White) return "GX_CC_ONE";
                return texel_ == TexelKind::Alpha ? "GX_CC_ZERO" : "GX_CC_TEXC";
            case ArgSource::TFactor:
                return "GX_CC_C0";
            case ArgSource::Specular:
                if (is_rectangle_) return "GX_CC_ZERO";
                return needs_specular_register() ? "GX_CC_C1" : "GX_CC_RASC";
        }
        return "GX_CC_ZERO";
    }

    std::string_view color_of_alpha(ArgSource source) const {
        switch (actual(source)) {
            case ArgSource::Diffuse:
                return "GX_CC_RASA";
            case ArgSource::Current:
                return "GX_CC_APREV";
            case ArgSource::Texture:
                return has_texel_alpha() ? "GX_CC_TEXA" : "GX_CC_ONE";
            case ArgSource::TFactor:
                return "GX_CC_A0";
            case ArgSource::Specular:
                return "GX_CC_ONE";
        }
        return "GX_CC_ZERO";
    }

    // For GX_SetTevAlphaIn; KONST is 1 in all stages.
    std::string_view alpha(ArgSource source) const {
        switch (actual(source)) {
            case ArgSource::Diffuse:
                return "GX_CA_RASA";
            case ArgSource::Current:
                return "GX_CA_APREV";
            case ArgSource::Texture:
                return has_texel_alpha() ? "GX_CA_TEXA" : "GX_CA_KONST";
            case ArgSource::TFactor:
                return "GX_CA_A0";
            case ArgSource::Specular:
                return "GX_CA_KONST";
        }
        return "GX_CA_ZERO";
    }

  private:
    ArgSource actual(ArgSource source) const {
        return source == ArgSource::Current && is_first_ ? ArgSource::Diffuse : source;
    }
    bool has_texel_alpha() const { return texel_ == TexelKind::Color || texel_ == TexelKind::Alpha; }

    void look_at(ArgSource source, bool is_color) {
        const ArgSource from = actual(source);
        reads_diffuse_       = reads_diffuse_ || from == ArgSource::Diffuse;
        reads_specular_      = reads_specular_ || (from == ArgSource::Specular && is_color && !is_rectangle_);
        const bool is_read =
            is_color ? texel_ == TexelKind::Color || texel_ == TexelKind::Luminance : has_texel_alpha();
        reads_texture_ = reads_texture_ || (from == ArgSource::Texture && is_read);
    }

    bool is_first_, is_rectangle_;
    TexelKind texel_;
    bool reads_diffuse_ = false, reads_specular_ = false, reads_texture_ = false;
};

// arg1, arg2: the arguments' names; alpha1: the alpha of the first; factor: of a blend.
TevUnit unit_of(TextureOp op, std::string_view zero, std::string_view arg1, std::string_view arg2,
                std::string_view alpha1, std::string_view factor) {
    TevUnit unit{zero, zero, zero, zero};
    switch (op) {
        case TextureOp::Disable:
            break;
        case TextureOp::SelectArg1:
            unit.d = arg1;
            break;
        case TextureOp::SelectArg2:
            unit.d = arg2;
            break;
        case TextureOp::Modulate4X:
        case TextureOp::Modulate2X:
        case TextureOp::Modulate:
            unit.b = arg1, unit.c = arg2;
            if (op == TextureOp::Modulate2X) unit.scale = "GX_CS_SCALE_2";
            if (op == TextureOp::Modulate4X) unit.scale = "GX_CS_SCALE_4";
            break;
        case TextureOp::AddSigned2X:
            unit.scale = "GX_CS_SCALE_2";
            [[fallthrough]];
        case TextureOp::AddSigned:
            unit.bias = "GX_TB_SUBHALF";
            [[fallthrough]];
        case TextureOp::Add:
            unit.a = arg1, unit.d = arg2;
            break;
        case TextureOp::Subtract:
            unit.a = arg2, unit.d = arg1;
            unit.op = "GX_TEV_SUB";
            break;
        case TextureOp::BlendDiffuseAlpha:
        case TextureOp::BlendTextureAlpha:
        case TextureOp::BlendFactorAlpha:
        case TextureOp::BlendCurrentAlpha:
            unit.a = arg2, unit.b = arg1, unit.c = factor;
            break;
        case TextureOp::ModulateColorAddAlpha:
            unit.b = arg1, unit.c = arg2, unit.d = alpha1;
            break;
    }
    return unit;
}

TevStage texture_stage(const TextureStage& stage, int index, const Arguments& arguments) {
    const auto color = [&](const TextureArg& arg) { return arguments.color(arg); };
    const auto alpha = [&](const TextureArg& arg) { return arguments.alpha(arg.source); };
    TevStage out{.what = index == 0 ? "stage 0" : "stage 1"};
    out.texture = arguments.reads_texture() ? index : -1;
    if (arguments.reads_diffuse())
        out.rasterized = "GX_COLOR0A0";
    else if (arguments.reads_specular())
        out.rasterized = "GX_COLOR1A1";
    out.color = unit_of(stage.color_op, "GX_CC_ZERO", color(stage.color_arg1), color(stage.color_arg2),
                        arguments.color_of_alpha(stage.color_arg1.source),
                        arguments.color_of_alpha(blend_source(stage.color_op)));
    out.alpha = unit_of(stage.alpha_op, "GX_CA_ZERO", alpha(stage.alpha_arg1), alpha(stage.alpha_arg2),
                        alpha(stage.alpha_arg1), arguments.alpha(blend_source(stage.alpha_op)));
    return out;
}

TevStage specular_to_register() {
    TevStage out{.what = "specular, for the next stage", .rasterized = "GX_COLOR1A1"};
    out.color     = {"GX_CC_ZERO", "GX_CC_ZERO", "GX_CC_ZERO", "GX_CC_RASC"};
    out.color.out = "GX_TEVREG1";
    out.alpha     = {"GX_CA_ZERO", "GX_CA_ZERO", "GX_CA_ZERO", "GX_CA_KONST"};
    out.alpha.out = "GX_TEVREG1";
    return out;
}

TevStage vertex_color() {
    TevStage out{.what = "vertex colour", .rasterized = "GX_COLOR0A0"};
    out.color = {"GX_CC_ZERO", "GX_CC_ZERO", "GX_CC_ZERO", "GX_CC_RASC"};
    out.alpha = {"GX_CA_ZERO", "GX_CA_ZERO", "GX_CA_ZERO", "GX_CA_RASA"};
    return out;
}

TevStage specular_addition() {
    TevStage out{.what = "specular addition", .rasterized = "GX_COLOR1A1", .alpha = kPreviousAlpha};
    out.color = {"GX_CC_RASC", "GX_CC_ZERO", "GX_CC_ZERO", "GX_CC_CPREV"};
    return out;
}

// Its factor, 1 for no fog, is the second vertex colour's alpha.
TevStage vertex_fog() {
    TevStage out{.what = "vertex fog", .rasterized = "GX_COLOR1A1", .alpha = kPreviousAlpha};
    out.color = {"GX_CC_C2", "GX_CC_CPREV", "GX_CC_RASA", "GX_CC_ZERO"};
    return out;
}

}  // namespace

bool TevProgram::reads(int texture) const {
    return std::any_of(stages.begin(), stages.end(), [&](const TevStage& stage) { return stage.texture == texture; });
}

TevProgram tev_program(const PipelineState& state, const TevInputs& inputs) {
    TevProgram program;
    const int count = stage_count(state);
    for (int i = 0; i < count; ++i) {
        const auto index          = static_cast<std::size_t>(i);
        const TextureStage& stage = state.stages[index];
        const Arguments arguments(stage, i == 0, inputs, inputs.texels[index]);
        if (arguments.needs_specular_register()) program.stages.push_back(specular_to_register());
        program.stages.push_back(texture_stage(stage, i, arguments));
        program.reads_specular = program.reads_specular || arguments.reads_specular();
    }
    if (count == 0) program.stages.push_back(vertex_color());
    if (state.lighting.specular_enable && !inputs.is_rectangle) {
        program.stages.push_back(specular_addition());
        program.reads_specular = true;
    }
    if (inputs.has_vertex_fog) {
        program.stages.push_back(vertex_fog());
        program.reads_fog = true;
    }
    return program;
}

}  // namespace pipeline
