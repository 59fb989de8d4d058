// SPDX-License-Identifier: MIT
#include "pipeline/truth/fragment.h"

namespace pipeline::truth {
namespace {

// What a stage chooses from.
struct Sources {
    Color diffuse, current, texel, factor, specular;
};

const Color& source_of(const Sources& from, ArgSource source) {
    switch (source) {
        case ArgSource::Diffuse:
            return from.diffuse;
        case ArgSource::Current:
            return from.current;
        case ArgSource::Texture:
            return from.texel;
        case ArgSource::TFactor:
            return from.factor;
        case ArgSource::Specular:
            return from.specular;
    }
    return from.current;
}

Color argument(const Sources& from, const TextureArg& arg) {
    const Color& source = source_of(from, arg.source);
    const Color value   = arg.alpha_replicate ? Color(source.a) : source;
    return arg.complement ? 1.0 - value : value;
}

// one: the value that multiplies as one.
Color operate(TextureOp op, const Color& a, const Color& b, const Sources& from, double one) {
    const auto mix = [&](const Color& by) { return a * by.a + b * (1.0 - by.a); };
    switch (op) {
        case TextureOp::Disable:
            return from.current;
        case TextureOp::SelectArg1:
            return a;
        case TextureOp::SelectArg2:
            return b;
        case TextureOp::Modulate:
            return a * b / one;
        case TextureOp::Modulate2X:
            return 2.0 * a * b / one;
        case TextureOp::Modulate4X:
            return 4.0 * a * b / one;
        case TextureOp::Add:
            return a + b;
        case TextureOp::AddSigned:
            return a + b - 0.5;
        case TextureOp::AddSigned2X:
            return 2.0 * (a + b - 0.5);
        case TextureOp::Subtract:
            return a - b;
        case TextureOp::BlendDiffuseAlpha:
            return mix(from.diffuse);
        case TextureOp::BlendTextureAlpha:
            return mix(from.texel);
        case TextureOp::BlendFactorAlpha:
            return mix(from.factor);
        case TextureOp::BlendCurrentAlpha:
            return mix(from.current);
        case TextureOp::ModulateColorAddAlpha:
            return a * b / one + a.a;
    }
    return a;
}

Color stage_result(const TextureStage& stage, const Sources& from, double one) {
    const Color color =
        operate(stage.color_op, argument(from, stage.color_arg1), argument(from, stage.color_arg2), from, one);
    const Color alpha =
        operate(stage.alpha_op, argument(from, stage.alpha_arg1), argument(from, stage.alpha_arg2), from, one);
    return clamp01(Color(glm::dvec3(color), alpha.a));
}

bool reads_texel(const TextureStage& stage) {
    const auto is_texel = [](const TextureArg& arg) { return arg.source == ArgSource::Texture; };
    return is_texel(stage.color_arg1) || is_texel(stage.color_arg2) || is_texel(stage.alpha_arg1) ||
           is_texel(stage.alpha_arg2) || stage.color_op == TextureOp::BlendTextureAlpha ||
           stage.alpha_op == TextureOp::BlendTextureAlpha;
}

}  // namespace

Color combined(const FragmentSetup& setup, const Fragment& fragment) {
    const PipelineState& state = setup.state;
    const double one           = setup.arithmetic.combine == CombineRule::GsShift7 ? 128.0 / 255.0 : 1.0;
    Sources from{.diffuse  = fragment.diffuse,
                 .current  = fragment.diffuse,
                 .texel    = Color(1.0),
                 .factor   = to_color(state.texture_factor),
                 .specular = Color(glm::dvec3(fragment.specular), 1.0)};
    for (std::size_t i = 0; i < static_cast<std::size_t>(stage_count(state)); ++i) {
        const TextureStage& stage = state.stages[i];
        if (reads_texel(stage)) from.texel = read(setup.textures[i], stage, fragment.points[i]);
        from.current = stage_result(stage, from, one);
    }
    glm::dvec3 color(from.current);
    if (state.lighting.specular_enable) color = glm::min(color + glm::dvec3(fragment.specular), 1.0);
    if (setup.has_fog) {
        const double f = fragment.specular.a;
        color          = f * color + (1.0 - f) * glm::dvec3(to_color(state.fog.color));
    }
    return Color(color, from.current.a);
}

}  // namespace pipeline::truth
