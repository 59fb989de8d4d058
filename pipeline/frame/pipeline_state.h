// SPDX-License-Identifier: MIT
// All fixed-function state of a pass. Default values mean "off": a default state writes the vertex colour, opaque.
#pragma once

#include <array>
#include <cstdint>

#include "pipeline/frame/blend_state.h"
#include "pipeline/frame/fields.h"
#include "pipeline/frame/lighting_state.h"
#include "pipeline/frame/math_types.h"
#include "pipeline/frame/test_state.h"
#include "pipeline/frame/texture_state.h"

namespace pipeline {

// Which way a triangle's vertices turn on the screen (y down) for it to be dropped. Rectangles are never culled.
enum class CullMode : std::uint8_t { None, Clockwise, CounterClockwise };
template <>
struct EnumNames<CullMode> {
    static constexpr std::array<std::string_view, 3> names{"NONE", "CW", "CCW"};
};

// Flat takes both colours and the fog of the first vertex.
enum class ShadeMode : std::uint8_t { Flat, Gouraud };
template <>
struct EnumNames<ShadeMode> {
    static constexpr std::array<std::string_view, 2> names{"FLAT", "GOURAUD"};
};

// Vertex fog on d = |z| in camera space, or the distance from the eye if `range`:
// f = (end - d) / (end - start), exp(-density d) or exp(-(density d)^2), clamped; colour = f * colour + (1 - f) * fog,
// rounded by Arithmetic::fog.
enum class FogMode : std::uint8_t { None, Linear, Exp, Exp2 };
template <>
struct EnumNames<FogMode> {
    static constexpr std::array<std::string_view, 4> names{"NONE", "LINEAR", "EXP", "EXP2"};
};

struct FogState {
    FogMode mode                           = FogMode::None;
    Argb color                             = {0xff000000};
    float start                            = 0.0f;
    float end                              = 1.0f;
    float density                          = 1.0f;
    bool range                             = false;
    bool operator==(const FogState&) const = default;
};
template <SameStruct<FogState> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [mode, color, start, end, density, range] = state;
    visit("mode", mode);
    visit("color", color);
    visit("start", start);
    visit("end", end);
    visit("density", density);
    visit("range", range);
}

// Half-open rectangle of pixels. All zero means "the whole target".
struct PixelRect {
    std::int32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    bool operator==(const PixelRect&) const = default;
};
template <SameStruct<PixelRect> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [x0, y0, x1, y1] = state;
    visit("x0", x0);
    visit("y0", y0);
    visit("x1", x1);
    visit("y1", y1);
}

struct PipelineState {
    BlendState blend;
    GsBlend gs_blend;
    DitherState dither;
    ColorMask color_mask;
    DepthState depth;
    AlphaTestState alpha_test;
    DestAlphaTest dest_alpha_test = DestAlphaTest::Off;
    CullMode cull                 = CullMode::None;
    ShadeMode shade               = ShadeMode::Gouraud;
    FogState fog;
    Argb texture_factor = {0xffffffff};
    std::array<TextureStage, kTextureStages> stages;
    LightingState lighting;
    PixelRect viewport;  // maps clip space to pixels and depth 0..1; limits all drawing, as the scissor does
    PixelRect scissor;
    bool operator==(const PipelineState&) const = default;
};
template <SameStruct<PipelineState> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [blend, gs_blend, dither, color_mask, depth, alpha_test, dest_alpha_test, cull, shade, fog, texture_factor,
           stages, lighting, viewport, scissor] = state;
    visit("blend", blend);
    visit("gs_blend", gs_blend);
    visit("dither", dither);
    visit("color_mask", color_mask);
    visit("depth", depth);
    visit("alpha_test", alpha_test);
    visit("dest_alpha_test", dest_alpha_test);
    visit("cull", cull);
    visit("shade", shade);
    visit("fog", fog);
    visit("texture_factor", texture_factor);
    visit("stages", stages);
    visit("lighting", lighting);
    visit("viewport", viewport);
    visit("scissor", scissor);
}

// The stages in use: those before the first whose color_op is Disable.
constexpr int stage_count(const PipelineState& state) {
    int count = 0;
    while (count < kTextureStages && state.stages[static_cast<std::size_t>(count)].color_op != TextureOp::Disable)
        ++count;
    return count;
}

}  // namespace pipeline
