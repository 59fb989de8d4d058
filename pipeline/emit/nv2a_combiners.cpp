// SPDX-License-Identifier: MIT
#include "pipeline/emit/nv2a_combiners.h"

#include <string_view>

namespace pipeline {
namespace {

enum Register : std::uint32_t {
    kZero = 0,
    kC0   = 1,  // COMBINER_FACTOR0
    kFog  = 3,  // the fog's colour, and its factor in alpha
    kV0   = 4,  // diffuse
    kV1   = 5,  // specular
    kT0   = 8,
    kR0   = 12,
};
constexpr std::uint32_t kAlpha  = 0x10;
// Mappings: max(0, x) is 0; 1 - max(0, x); 2 max(0, x) - 1.
constexpr std::uint32_t kInvert = 0x20, kExpand = 0x40;
constexpr std::uint32_t kOne = kZero | kInvert, kMinusOne = kZero | kExpand;

constexpr std::uint32_t kToR0 = kR0 << 8;
enum Scale : std::uint32_t {
    kIdentity  = 0x00u << 12,
    kBias      = 0x08u << 12,  // - 1/2
    kTwice     = 0x10u << 12,
    kBiasTwice = 0x18u << 12,  // - 1/2, then twice
    kFourfold  = 0x20u << 12,
};

std::uint32_t word(std::uint32_t a, std::uint32_t b, std::uint32_t c = kZero, std::uint32_t d = kZero) {
    return a << 24 | b << 16 | c << 8 | d;
}

// One stage's view of the registers, for colour or for alpha.
struct Inputs {
    std::uint32_t stage;
    Nv2aTexel texel;
    bool of_alpha;

    // Without mapping; a constant one is the zero register inverted.
    std::uint32_t source(ArgSource source, bool alpha) const {
        const std::uint32_t channel = alpha ? kAlpha : 0;
        switch (source) {
            case ArgSource::Diffuse:
                return kV0 | channel;
            case ArgSource::Current:
                return (stage == 0 ? kV0 : kR0) | channel;
            case ArgSource::Texture:
                if (texel == Nv2aTexel::Nothing) return kOne;
                return texel == Nv2aTexel::Alpha && !alpha ? kZero : (kT0 + stage) | channel;
            case ArgSource::TFactor:
                return kC0 | channel;
            case ArgSource::Specular:
                return alpha ? kOne : kV1;
        }
        return kZero;
    }
    std::uint32_t arg(const TextureArg& arg) const {
        return source(arg.source, of_alpha || arg.alpha_replicate) ^ (arg.complement ? kInvert : 0u);
    }
    std::uint32_t alpha_of(ArgSource from) const { return source(from, true); }
};

struct Words {
    std::uint32_t in = 0, out = kToR0;
};

Words lerp(std::uint32_t a, std::uint32_t b, std::uint32_t by) {
    return {word(a, by, b, by ^ kInvert)};
}

Words combine(TextureOp op, const TextureArg& arg1, const TextureArg& arg2, const Inputs& inputs) {
    const std::uint32_t a = inputs.arg(arg1), b = inputs.arg(arg2);
    switch (op) {
        case TextureOp::Disable:
            break;
        case TextureOp::SelectArg1:
            return {word(a, kOne)};
        case TextureOp::SelectArg2:
            return {word(b, kOne)};
        case TextureOp::Modulate:
            return {word(a, b)};
        case TextureOp::Modulate2X:
            return {word(a, b), kToR0 | kTwice};
        case TextureOp::Modulate4X:
            return {word(a, b), kToR0 | kFourfold};
        case TextureOp::Add:
            return {word(a, kOne, b, kOne)};
        case TextureOp::AddSigned:
            return {word(a, kOne, b, kOne), kToR0 | kBias};
        case TextureOp::AddSigned2X:
            return {word(a, kOne, b, kOne), kToR0 | kBiasTwice};
        case TextureOp::Subtract:
            return {word(a, kOne, b, kMinusOne)};
        case TextureOp::BlendDiffuseAlpha:
            return lerp(a, b, inputs.alpha_of(ArgSource::Diffuse));
        case TextureOp::BlendTextureAlpha:
            return lerp(a, b, inputs.alpha_of(ArgSource::Texture));
        case TextureOp::BlendFactorAlpha:
            return lerp(a, b, inputs.alpha_of(ArgSource::TFactor));
        case TextureOp::BlendCurrentAlpha:
            return lerp(a, b, inputs.alpha_of(ArgSource::Current));
        case TextureOp::ModulateColorAddAlpha:
            return {word(a, b, inputs.alpha_of(arg1.source) ^ (arg1.complement ? kInvert : 0u), kOne)};
    }
    return {word(kV0 | (inputs.of_alpha ? kAlpha : 0u), kOne)};
}

void add(Nv2aCombiners& combiners, const Words& color, const Words& alpha) {
    const std::uint32_t i  = combiners.count++;
    combiners.color_in[i]  = color.in;
    combiners.color_out[i] = color.out;
    combiners.alpha_in[i]  = alpha.in;
    combiners.alpha_out[i] = alpha.out;
}

std::string input_text(std::uint32_t input, bool of_alpha) {
    static constexpr std::string_view kNames[16] = {"0",  "C0", "C1", "FOG", "V0", "V1", "6",     "7",
                                                    "T0", "T1", "T2", "T3",  "R0", "R1", "V1+R0", "EF"};
    const std::uint32_t mapping                  = input & 0xe0;
    if ((input & 0xf) == kZero) return mapping == kInvert ? "1" : mapping == kExpand ? "-1" : "0";
    std::string text(kNames[input & 0xf]);
    if ((input & kAlpha) != 0 && !of_alpha) text += ".a";
    return mapping == kInvert ? "1 - " + text : text;
}

}  // namespace

bool reads_second_color(const PipelineState& state) {
    if (state.lighting.specular_enable) return true;
    const auto is_second = [](const TextureArg& arg) { return arg.source == ArgSource::Specular; };
    for (int i = 0; i < stage_count(state); ++i) {
        const TextureStage& stage = state.stages[static_cast<std::size_t>(i)];
        if (is_second(stage.color_arg1) || is_second(stage.color_arg2) || is_second(stage.alpha_arg1) ||
            is_second(stage.alpha_arg2))
            return true;
    }
    return false;
}

Nv2aCombiners nv2a_combiners(const PipelineState& state, const Nv2aTexels& texels, bool has_fog) {
    Nv2aCombiners combiners;
    for (int i = 0; i < stage_count(state); ++i) {
        const auto index          = static_cast<std::size_t>(i);
        const TextureStage& stage = state.stages[index];
        const auto inputs         = [&](bool of_alpha) {
            return Inputs{static_cast<std::uint32_t>(i), texels[index], of_alpha};
        };
        add(combiners, combine(stage.color_op, stage.color_arg1, stage.color_arg2, inputs(false)),
            combine(stage.alpha_op, stage.alpha_arg1, stage.alpha_arg2, inputs(true)));
    }
    if (combiners.count == 0) add(combiners, {word(kV0, kOne)}, {word(kV0 | kAlpha, kOne)});
    if (state.lighting.specular_enable) add(combiners, {word(kR0, kOne, kV1, kOne)}, {word(kR0 | kAlpha, kOne)});
    combiners.final_abcd = has_fog ? word(kFog | kAlpha, kR0, kFog) : word(kZero, kZero, kZero, kR0);
    combiners.final_efg  = word(kZero, kZero, kR0 | kAlpha);
    return combiners;
}

std::string inputs_text(std::uint32_t in, bool of_alpha) {
    std::string text;
    for (int i = 0; i < 4; ++i) {
        text += i == 0 ? "" : ", ";
        text += "ABCD"[i];
        text += " = " + input_text(in >> (24 - 8 * i) & 0xff, of_alpha);
    }
    return text;
}

std::string output_text(std::uint32_t out) {
    switch (out & 0x3f000) {
        case kBias:
            return "R0 = A B + C D - 1/2";
        case kTwice:
            return "R0 = 2 (A B + C D)";
        case kBiasTwice:
            return "R0 = 2 (A B + C D - 1/2)";
        case kFourfold:
            return "R0 = 4 (A B + C D)";
        default:
            return "R0 = A B + C D";
    }
}

}  // namespace pipeline
