// SPDX-License-Identifier: MIT
// A texture stage in the sense of Direct3D 7 (D3DTEXTUREOP, D3DTA, D3DTSS_*): where the coordinates come from, how the
// texture is filtered, and how the texel is combined with the colour so far (Current; Diffuse in stage 0).
// Every stage's result is clamped to [0, 1]. With a, b the arguments, each op rounds its exact result once, by
// Arithmetic::combine:
//   MODULATE a*b (2X, 4X: times 2, 4)   ADD a + b   ADDSIGNED a + b - 1/2   ADDSIGNED2X 2(a + b - 1/2)   SUBTRACT a - b
//   BLENDxALPHA a*x + b*(1 - x), x the alpha of DIFFUSE, TEXTURE, TFACTOR or CURRENT
//   MODULATECOLOR_ADDALPHA a*b + (alpha of a): with DIFFUSE and TEXTURE, the Graphics Synthesizer's HIGHLIGHT
// The first stage whose color_op is Disable ends the chain; alpha_op must then be Disable as well.
#pragma once

#include <cstdint>

#include "pipeline/frame/arithmetic.h"
#include "pipeline/frame/fields.h"
#include "pipeline/frame/math_types.h"

namespace pipeline {

enum class TextureOp : std::uint8_t {
    Disable,
    SelectArg1,
    SelectArg2,
    Modulate,
    Modulate2X,
    Modulate4X,
    Add,
    AddSigned,
    AddSigned2X,
    Subtract,
    BlendDiffuseAlpha,
    BlendTextureAlpha,
    BlendFactorAlpha,
    BlendCurrentAlpha,
    ModulateColorAddAlpha,
};
template <>
struct EnumNames<TextureOp> {
    static constexpr std::array<std::string_view, 15> names{"DISABLE",
                                                            "SELECTARG1",
                                                            "SELECTARG2",
                                                            "MODULATE",
                                                            "MODULATE2X",
                                                            "MODULATE4X",
                                                            "ADD",
                                                            "ADDSIGNED",
                                                            "ADDSIGNED2X",
                                                            "SUBTRACT",
                                                            "BLENDDIFFUSEALPHA",
                                                            "BLENDTEXTUREALPHA",
                                                            "BLENDFACTORALPHA",
                                                            "BLENDCURRENTALPHA",
                                                            "MODULATECOLOR_ADDALPHA"};
};

// TFactor is PipelineState::texture_factor. Specular has alpha 1.
enum class ArgSource : std::uint8_t { Diffuse, Current, Texture, TFactor, Specular };
template <>
struct EnumNames<ArgSource> {
    static constexpr std::array<std::string_view, 5> names{"DIFFUSE", "CURRENT", "TEXTURE", "TFACTOR", "SPECULAR"};
};

// GS_SHIFT7 has these alone.
constexpr bool has_rule(CombineRule rule, TextureOp op) {
    return rule != CombineRule::GsShift7 || op == TextureOp::Disable || op == TextureOp::SelectArg1 ||
           op == TextureOp::SelectArg2 || op == TextureOp::Modulate || op == TextureOp::Add ||
           op == TextureOp::ModulateColorAddAlpha;
}

// alpha_replicate reads the source's alpha in every channel; complement then takes 1 - x.
struct TextureArg {
    ArgSource source                         = ArgSource::Current;
    bool complement                          = false;
    bool alpha_replicate                     = false;
    bool operator==(const TextureArg&) const = default;
};
template <SameStruct<TextureArg> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [source, complement, alpha_replicate] = state;
    visit("source", source);
    visit("complement", complement);
    visit("alpha_replicate", alpha_replicate);
}

enum class TextureFilter : std::uint8_t { Point, Linear };
template <>
struct EnumNames<TextureFilter> {
    static constexpr std::array<std::string_view, 2> names{"POINT", "LINEAR"};
};

enum class MipFilter : std::uint8_t { None, Point, Linear };
template <>
struct EnumNames<MipFilter> {
    static constexpr std::array<std::string_view, 3> names{"NONE", "POINT", "LINEAR"};
};

enum class TextureAddress : std::uint8_t { Wrap, Clamp, Mirror };
template <>
struct EnumNames<TextureAddress> {
    static constexpr std::array<std::string_view, 3> names{"WRAP", "CLAMP", "MIRROR"};
};

// Vertex0/1: the vertex's first or second pair. CameraPosition: the position in camera space, its w taken as 1, times `transform`
// (D3DTSS_TCI_CAMERASPACEPOSITION), then (u, v) = (x, y) / z of the result: D3DTTFF_COUNT3 | D3DTTFF_PROJECTED.
enum class CoordSource : std::uint8_t { Vertex0, Vertex1, CameraPosition };
template <>
struct EnumNames<CoordSource> {
    static constexpr std::array<std::string_view, 3> names{"VERTEX0", "VERTEX1", "CAMERAPOSITION"};
};

// One filter serves magnification and minification. transform is used by CameraPosition only.
struct TextureStage {
    TextureOp color_op                         = TextureOp::Disable;
    TextureArg color_arg1                      = {.source = ArgSource::Texture};
    TextureArg color_arg2                      = {.source = ArgSource::Current};
    TextureOp alpha_op                         = TextureOp::Disable;
    TextureArg alpha_arg1                      = {.source = ArgSource::Texture};
    TextureArg alpha_arg2                      = {.source = ArgSource::Current};
    TextureFilter filter                       = TextureFilter::Point;
    MipFilter mip_filter                       = MipFilter::None;
    TextureAddress address_u                   = TextureAddress::Wrap;
    TextureAddress address_v                   = TextureAddress::Wrap;
    CoordSource coords                         = CoordSource::Vertex0;
    Mat4 transform                             = Mat4(1.0f);
    bool operator==(const TextureStage&) const = default;
};
template <SameStruct<TextureStage> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [color_op, color_arg1, color_arg2, alpha_op, alpha_arg1, alpha_arg2, filter, mip_filter, address_u, address_v,
           coords, transform] = state;
    visit("color_op", color_op);
    visit("color_arg1", color_arg1);
    visit("color_arg2", color_arg2);
    visit("alpha_op", alpha_op);
    visit("alpha_arg1", alpha_arg1);
    visit("alpha_arg2", alpha_arg2);
    visit("filter", filter);
    visit("mip_filter", mip_filter);
    visit("address_u", address_u);
    visit("address_v", address_v);
    visit("coords", coords);
    visit("transform", transform);
}

inline constexpr int kTextureStages = 2;

}  // namespace pipeline
