// SPDX-License-Identifier: MIT
#include "pipeline/legalize/masked_alpha.h"

#include <algorithm>

#include "pipeline/check/chip_findings.h"
#include "pipeline/check/target_use.h"
#include "pipeline/legalize/drawn_alpha.h"
#include "pipeline/legalize/window_map.h"
#include "pipeline/validate/check_pass.h"

namespace pipeline {

namespace {

using enum BlendFactor;

constexpr ColorMask kNothing{.red = false, .green = false, .blue = false, .alpha = false};
constexpr ColorMask kAlphaAlone{.red = false, .green = false, .blue = false, .alpha = true};
constexpr ColorMask kColorAlone{.red = true, .green = true, .blue = true, .alpha = false};

bool has_alpha(TargetFormat format) {
    return format != TargetFormat::X8R8G8B8 && format != TargetFormat::R5G6B5 && format != TargetFormat::Psmct24;
}

// As it acts on the target: where there is no alpha, red stands for it.
ColorMask acting_mask(const PipelineState& state, const Target& target) {
    ColorMask mask = state.color_mask;
    if (!has_alpha(target.format)) mask.alpha = mask.red;
    return mask;
}

bool is_source(BlendFactor factor) {
    return factor == SourceColor || factor == SourceAlpha;
}
bool is_inverse_source(BlendFactor factor) {
    return factor == InvSourceColor || factor == InvSourceAlpha;
}
bool is_dest(BlendFactor factor) {
    return factor == DestColor || factor == DestAlpha;
}

// How alpha alone is written: a blend, and red, green and blue for it to leave the target's.
struct AlphaWrite {
    BlendState blend;
    std::uint32_t rgb = 0;
};
constexpr std::uint32_t kWhite = 0x00ffffff, kBlack = 0x00000000;
constexpr AlphaWrite kMultiplyAlpha{kMultiply, kWhite}, kAddAlpha{{One, One}, kBlack};

std::optional<AlphaWrite> alpha_write(const Frame& frame, const Pass& pass) {
    const auto [source, dest] = pass.state.blend;
    if ((source == Zero && is_source(dest)) || (is_dest(source) && dest == Zero)) return kMultiplyAlpha;
    if (source == Zero && is_inverse_source(dest)) return AlphaWrite{{Zero, InvSourceColor}, kBlack};
    if (source == One && dest == One) return kAddAlpha;
    if (source == One && is_inverse_source(dest)) return AlphaWrite{{One, InvSourceColor}, kBlack};
    if (pass.state.blend != kReplace) return std::nullopt;
    const DrawnAlpha drawn(frame, pass);
    if (drawn.is(0)) return kMultiplyAlpha;
    if (drawn.is(255)) return kAddAlpha;
    return std::nullopt;
}

// The chain's last stage; without one, one that keeps the vertex colour.
TextureStage& last_stage(PipelineState& state) {
    const int count = stage_count(state);
    if (count > 0) return state.stages[static_cast<std::size_t>(count - 1)];
    state.stages[0] = {.color_op = TextureOp::SelectArg2, .alpha_op = TextureOp::SelectArg2};
    return state.stages[0];
}

void give_color(PipelineState& state, std::uint32_t rgb) {
    TextureStage& stage            = last_stage(state);
    stage.color_op                 = TextureOp::SelectArg1;
    stage.color_arg1               = {.source = ArgSource::TFactor};
    stage.color_arg2               = {};
    state.texture_factor           = {(state.texture_factor.value & 0xff000000) | rgb};
    state.fog                      = {};
    state.lighting.specular_enable = false;
}

std::string text_of_blend(const BlendState& blend) {
    return "blend " + text_of(blend.source) + ' ' + text_of(blend.dest);
}

// These three change the pass, and say how; nothing if they cannot.
std::string write_alpha(const Frame& frame, Pass& pass) {
    const std::optional<AlphaWrite> write = alpha_write(frame, pass);
    if (!write) return {};
    pass.state.blend = write->blend;
    give_color(pass.state, write->rgb);
    return text_of_blend(write->blend) + (write->rgb == kWhite ? " of white" : " of black") + " and alpha";
}

// What the fragment's alpha must be for the blend to leave the target's.
std::optional<int> keeping_alpha(const BlendState& blend) {
    const auto [source, dest] = blend;
    if (source == SourceAlpha || source == InvSourceAlpha || dest == SourceAlpha || dest == InvSourceAlpha)
        return std::nullopt;
    if (dest == One || dest == InvSourceColor) return 0;
    if ((source == Zero && dest == SourceColor) || (is_dest(source) && dest == Zero)) return 255;
    return std::nullopt;
}

// x - x is 0 and x + (1 - x) is 255, whatever the arguments hold.
void give_alpha(PipelineState& state, int alpha) {
    TextureStage& stage = last_stage(state);
    stage.alpha_op      = alpha == 0 ? TextureOp::Subtract : TextureOp::Add;
    stage.alpha_arg1    = {.source = ArgSource::Current};
    stage.alpha_arg2    = {.source = ArgSource::Current, .complement = alpha != 0};
}

std::string keep_alpha(Pass& pass) {
    const std::optional<int> alpha = keeping_alpha(pass.state.blend);
    if (!alpha || pass.state.alpha_test.func != CompareFunc::Always) return {};
    give_alpha(pass.state, *alpha);
    return text_of_blend(pass.state.blend) + " of alpha " + std::to_string(*alpha);
}

std::string replace_mask(const Frame& frame, const Target& target, Pass& pass) {
    if (pass.state.dither.mode != DitherMode::None) return {};  // it changes what a blend leaves
    const ColorMask mask = acting_mask(pass.state, target);
    if (mask == kAlphaAlone) return write_alpha(frame, pass);
    if (mask == kColorAlone) return keep_alpha(pass);
    if (mask != kNothing) return {};
    pass.state.blend = {Zero, One};
    return text_of_blend(pass.state.blend);
}

bool has_rules(const Arithmetic& arithmetic) {
    return arithmetic.blend == BlendRule::Nearest255 && arithmetic.blend_source == BlendSource::Bytes &&
           arithmetic.combine != CombineRule::GsShift7;
}

}  // namespace

Frame mask_by_blending(Frame frame, const Profile& profile, RewriteNotes& notes) {
    if (profile.states.color_mask != MaskKind::None) return frame;
    if (!has_rules(frame.arithmetic) || !has_rules(profile.arithmetic)) return frame;
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        Pass& pass           = frame.passes[i];
        const Target* target = find_target(frame, pass.color);
        if (target == nullptr || !draws(pass) || acting_mask(pass.state, *target) == ColorMask{}) continue;
        std::string how = replace_mask(frame, *target, pass);
        if (how.empty()) continue;
        pass.state.color_mask = {};
        notes.push_back({"masked_alpha", place_of(frame, i), "the chip has no colour mask", std::move(how)});
    }
    return frame;
}

}  // namespace pipeline
