// SPDX-License-Identifier: MIT
#include "pipeline/legalize/gs_blend.h"

#include "pipeline/check/chip_findings.h"
#include "pipeline/check/target_use.h"
#include "pipeline/legalize/alpha_use.h"
#include "pipeline/legalize/gs_alpha.h"

namespace pipeline {

namespace {

// constant + scale * alpha
struct Coefficient {
    int constant = 0, scale = 0;
    bool operator==(const Coefficient&) const = default;
};
struct Factor {
    Coefficient coefficient;
    std::optional<GsAlpha> alpha;  // nothing for a constant
};

std::optional<Factor> factor_of(BlendFactor factor) {
    switch (factor) {
        case BlendFactor::Zero:
            return Factor{{0, 0}, {}};
        case BlendFactor::One:
            return Factor{{1, 0}, {}};
        case BlendFactor::SourceAlpha:
            return Factor{{0, 1}, GsAlpha::As};
        case BlendFactor::InvSourceAlpha:
            return Factor{{1, -1}, GsAlpha::As};
        case BlendFactor::DestAlpha:
            return Factor{{0, 1}, GsAlpha::Ad};
        case BlendFactor::InvDestAlpha:
            return Factor{{1, -1}, GsAlpha::Ad};
        case BlendFactor::SourceColor:
        case BlendFactor::InvSourceColor:
        case BlendFactor::DestColor:
        case BlendFactor::InvDestColor:
            break;
    }
    return {};
}

// Of a colour in ((A - B) * C >> 7) + D; with FIX 0x80, which is one, C is no variable.
Coefficient coefficient_of(GsColor color, const GsBlend& blend) {
    const Coefficient in{blend.d == color ? 1 : 0, (blend.a == color ? 1 : 0) - (blend.b == color ? 1 : 0)};
    return blend.c == GsAlpha::Fix ? Coefficient{in.constant + in.scale, 0} : in;
}

std::optional<GsBlend> find_operands(GsAlpha c, const Coefficient& source, const Coefficient& dest) {
    for (const GsColor a : all_of<GsColor>())
        for (const GsColor b : all_of<GsColor>())
            for (const GsColor d : all_of<GsColor>()) {
                GsBlend blend{.a = a, .b = b, .c = c, .d = d};
                if (c == GsAlpha::Fix) blend.fix = 0x80;
                if (coefficient_of(GsColor::Cs, blend) == source && coefficient_of(GsColor::Cd, blend) == dest)
                    return blend;
            }
    return {};
}

// ZERO, ONE keeps the alpha that is there; every other blend of alpha gives something that is neither that nor the fragment's.
constexpr BlendState kKeep{.source = BlendFactor::Zero, .dest = BlendFactor::One};

constexpr BlendState kByOneMore{.source = BlendFactor::DestColor, .dest = BlendFactor::One};
constexpr BlendState kInvert{.source = BlendFactor::InvDestColor, .dest = BlendFactor::Zero};
constexpr GsBlend kTwice{.a = GsColor::Cd, .b = GsColor::Zero, .c = GsAlpha::Fix, .d = GsColor::Cd, .fix = 0x80};
constexpr GsBlend kAlphaMore{.a = GsColor::Cd, .b = GsColor::Zero, .c = GsAlpha::As, .d = GsColor::Cd};
constexpr GsBlend kRest{.a = GsColor::Cs, .b = GsColor::Cd, .c = GsAlpha::Fix, .d = GsColor::Zero, .fix = 0x80};

bool is_white(Argb color) {
    return (color.value & 0x00ffffff) == 0x00ffffff;
}

// Grey, and its alpha the same, in the scale that alpha has in the frame.
bool is_own_alpha(const Frame& frame, Argb color) {
    const auto grey = static_cast<std::uint8_t>(color.value), alpha = static_cast<std::uint8_t>(color.value >> 24);
    const bool is_gs = frame.arithmetic.combine == CombineRule::GsShift7;
    return (color.value & 0x00ffffff) == grey * 0x010101u && alpha == (is_gs ? to_gs_scale(grey) : grey);
}

// Are the fragments' red, green and blue those of vertices alone, and does `is` hold for all of these?
template <class Is>
bool draws_colors(const Frame& frame, const Pass& pass, Is&& is) {
    const PipelineState& state = pass.state;
    if (state.fog.mode != FogMode::None || state.lighting.enabled || state.lighting.specular_enable) return false;
    const TextureStage& stage = state.stages[0];
    const bool selects_vertex =
        stage.color_op == TextureOp::SelectArg1 && stage.color_arg1 == TextureArg{.source = ArgSource::Diffuse};
    if (stage_count(state) > 1 || (stage_count(state) == 1 && !selects_vertex)) return false;
    const auto are = [&](const auto& triangles, const auto& vertices) {
        const auto first = frame.indices.begin() + static_cast<std::ptrdiff_t>(triangles.first_index);
        return std::all_of(first, first + static_cast<std::ptrdiff_t>(triangles.index_count),
                           [&](std::uint32_t vertex) { return is(vertices[vertex].diffuse); });
    };
    return std::all_of(pass.draws.begin(), pass.draws.end(), [&](const Draw& draw) {
        if (const auto* rectangle = std::get_if<DrawRectangle>(&draw)) return bool(is(rectangle->color));
        if (const auto* triangles = std::get_if<DrawTriangles>(&draw)) return are(*triangles, frame.vertices);
        return are(std::get<DrawWindowTriangles>(draw), frame.window_vertices);
    });
}

std::optional<GsBlend> gs_blend_of(const Frame& frame, const Pass& pass) {
    const BlendState& blend = pass.state.blend;
    if (blend == kByOneMore && draws_colors(frame, pass, &is_white)) return kTwice;
    if (blend == kByOneMore && stage_count(pass.state) == 0 &&
        draws_colors(frame, pass, [&](Argb color) { return is_own_alpha(frame, color); }))
        return kAlphaMore;
    if (blend == kInvert && draws_colors(frame, pass, &is_white)) return kRest;
    return gs_blend_of(blend);
}

}  // namespace

std::optional<GsBlend> gs_blend_of(const BlendState& blend) {
    const std::optional<Factor> source = factor_of(blend.source), dest = factor_of(blend.dest);
    if (!source || !dest || (source->alpha && dest->alpha && *source->alpha != *dest->alpha)) return {};
    const std::optional<GsAlpha> alpha = source->alpha ? source->alpha : dest->alpha;
    const GsAlpha c                    = alpha.value_or(GsAlpha::As);
    if (const auto found = find_operands(c, source->coefficient, dest->coefficient)) return found;
    return alpha ? std::nullopt : find_operands(GsAlpha::Fix, source->coefficient, dest->coefficient);
}

bool has_gs_blend(const Frame& frame, std::size_t index) {
    const Pass& pass = frame.passes[index];
    if (pass.state.dither.mode == DitherMode::Flipper2x2) return false;
    const Target* target = find_target(frame, pass.color);
    if (!draws(pass) || target == nullptr) return true;
    const PipelineState& state = pass.state;
    if (!gs_blend_of(frame, pass)) return false;
    return state.blend == kReplace || state.blend == kKeep || !state.color_mask.alpha || !keeps_alpha(target->format) ||
           !is_alpha_needed(frame, index);
}

Frame rewrite_gs_blend(Frame frame, const Profile& profile, RewriteNotes& notes) {
    if (profile.arithmetic.blend != BlendRule::GsShift7 || frame.arithmetic.blend == BlendRule::GsShift7 ||
        frame.arithmetic.combine != CombineRule::GsShift7)
        return frame;
    for (std::size_t i = 0; i < frame.passes.size(); ++i)
        if (!has_gs_blend(frame, i)) return frame;

    frame.arithmetic.blend = BlendRule::GsShift7;
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        PipelineState& state = frame.passes[i].state;
        if (state.blend == kReplace) continue;
        const std::string why = "the chip blends by register ALPHA, not " + differing_fields(state.blend, kReplace);
        // Without a colour target no blend shows.
        state.gs_blend        = gs_blend_of(frame, frame.passes[i]).value_or(GsBlend{});
        if (state.blend == kKeep) state.color_mask.alpha = false;
        state.blend = kReplace;
        notes.push_back({"gs_blend", Place("pass", i, frame.passes[i].label).text(), why,
                         "gs_blend { " + differing_fields(state.gs_blend, {}) + " }"});
    }
    return frame;
}

}  // namespace pipeline
