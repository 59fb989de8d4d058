// SPDX-License-Identifier: MIT
#include "pipeline/legalize/alpha_use.h"

#include <algorithm>

#include "pipeline/check/target_use.h"

namespace pipeline {

namespace {

bool is_dest_alpha(BlendFactor factor) {
    return factor == BlendFactor::DestAlpha || factor == BlendFactor::InvDestAlpha;
}

bool reads_dest_alpha(const PipelineState& state) {
    return is_dest_alpha(state.blend.source) || is_dest_alpha(state.blend.dest) ||
           (state.gs_blend.c == GsAlpha::Ad && state.gs_blend.a != state.gs_blend.b) ||
           state.dest_alpha_test != DestAlphaTest::Off;
}

bool reads_alpha_in(const Pass& pass, TargetId target) {
    if (pass.color == target && draws(pass) && reads_dest_alpha(pass.state)) return true;
    bool reads = false;
    for_each_texture(pass, [&](std::size_t, std::size_t stage, const TextureBinding& binding) {
        reads = reads || (binding.target == target && reads_texture_alpha(pass.state, stage));
    });
    for (const Draw& draw : pass.draws) {
        const auto* copy = std::get_if<CopyRectangle>(&draw);
        reads            = reads || (copy != nullptr && copy->source == target);
    }
    return reads;
}

}  // namespace

bool keeps_alpha(TargetFormat format) {
    return format == TargetFormat::A8R8G8B8 || format == TargetFormat::A1R5G5B5 || format == TargetFormat::R6G6B6A6 ||
           format == TargetFormat::Psmct32 || format == TargetFormat::Psmct16;
}

bool reads_texture_alpha(const PipelineState& state, std::size_t index) {
    if (index >= static_cast<std::size_t>(stage_count(state))) return false;
    const TextureStage& stage = state.stages[index];
    if (stage.color_op == TextureOp::BlendTextureAlpha || stage.alpha_op == TextureOp::BlendTextureAlpha) return true;
    const auto is_read = [&](TextureOp op, int number, const TextureArg& arg, bool in_color) {
        const TextureOp other = number == 1 ? TextureOp::SelectArg2 : TextureOp::SelectArg1;
        const bool adds_alpha = number == 1 && op == TextureOp::ModulateColorAddAlpha;
        return op != TextureOp::Disable && op != other && arg.source == ArgSource::Texture &&
               (!in_color || arg.alpha_replicate || adds_alpha);
    };
    return is_read(stage.color_op, 1, stage.color_arg1, true) || is_read(stage.color_op, 2, stage.color_arg2, true) ||
           is_read(stage.alpha_op, 1, stage.alpha_arg1, false) || is_read(stage.alpha_op, 2, stage.alpha_arg2, false);
}

bool is_alpha_read(const Frame& frame, TargetId target) {
    return std::any_of(frame.passes.begin(), frame.passes.end(),
                       [&](const Pass& pass) { return reads_alpha_in(pass, target); });
}

}  // namespace pipeline
