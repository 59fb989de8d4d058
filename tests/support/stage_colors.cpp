// SPDX-License-Identifier: MIT
#include "tests/support/stage_colors.h"

#include <algorithm>

namespace test_support {

using namespace pipeline;

namespace {

double clamp01(double x) {
    return std::min(std::max(x, 0.0), 1.0);
}
double combined(TextureOp op, double a, double b, double blend, double a_alpha) {
    switch (op) {
        case TextureOp::Disable:
            return 0.0;
        case TextureOp::SelectArg1:
            return a;
        case TextureOp::SelectArg2:
            return b;
        case TextureOp::Modulate:
            return a * b;
        case TextureOp::Modulate2X:
            return 2.0 * a * b;
        case TextureOp::Modulate4X:
            return 4.0 * a * b;
        case TextureOp::Add:
            return a + b;
        case TextureOp::AddSigned:
            return a + b - 0.5;
        case TextureOp::AddSigned2X:
            return 2.0 * (a + b - 0.5);
        case TextureOp::Subtract:
            return a - b;
        case TextureOp::BlendDiffuseAlpha:
        case TextureOp::BlendTextureAlpha:
        case TextureOp::BlendFactorAlpha:
        case TextureOp::BlendCurrentAlpha:
            return a * blend + b * (1.0 - blend);
        case TextureOp::ModulateColorAddAlpha:
            return a * b + a_alpha;
    }
    return 0.0;
}

}  // namespace

RealColor real_color(Argb color) {
    return {(color.value >> 16 & 255) / 255.0, (color.value >> 8 & 255) / 255.0, (color.value & 255) / 255.0,
            (color.value >> 24) / 255.0};
}

RealColor shaded(const PipelineState& state, const StageColors& colors, bool has_fog) {
    RealColor current      = colors.diffuse;
    const RealColor factor = real_color(state.texture_factor);
    for (std::size_t i = 0; i < kTextureStages && state.stages[i].color_op != TextureOp::Disable; ++i) {
        const TextureStage& stage = state.stages[i];
        const auto source         = [&](ArgSource from) -> RealColor {
            switch (from) {
                case ArgSource::Diffuse:
                    return colors.diffuse;
                case ArgSource::Current:
                    return current;
                case ArgSource::Texture:
                    return colors.texels[i];
                case ArgSource::TFactor:
                    return factor;
                case ArgSource::Specular:
                    return {colors.specular[0], colors.specular[1], colors.specular[2], 1.0};
            }
            return {};
        };
        const auto value = [&](const TextureArg& arg, std::size_t channel) {
            const double x = source(arg.source)[arg.alpha_replicate ? 3 : channel];
            return arg.complement ? 1.0 - x : x;
        };
        RealColor next{};
        for (std::size_t channel = 0; channel < 4; ++channel) {
            const bool of_alpha    = channel == 3;
            const TextureOp op     = of_alpha ? stage.alpha_op : stage.color_op;
            const TextureArg& arg1 = of_alpha ? stage.alpha_arg1 : stage.color_arg1;
            const TextureArg& arg2 = of_alpha ? stage.alpha_arg2 : stage.color_arg2;
            const ArgSource by     = op == TextureOp::BlendDiffuseAlpha   ? ArgSource::Diffuse
                                     : op == TextureOp::BlendTextureAlpha ? ArgSource::Texture
                                     : op == TextureOp::BlendFactorAlpha  ? ArgSource::TFactor
                                                                          : ArgSource::Current;
            next[channel] =
                clamp01(combined(op, value(arg1, channel), value(arg2, channel), source(by)[3], value(arg1, 3)));
        }
        current = next;
    }
    const RealColor fog = real_color(state.fog.color);
    for (std::size_t i = 0; i < 3; ++i) {
        if (state.lighting.specular_enable) current[i] = clamp01(current[i] + colors.specular[i]);
        if (has_fog) current[i] = colors.fog * current[i] + (1.0 - colors.fog) * fog[i];
    }
    return current;
}

}  // namespace test_support
