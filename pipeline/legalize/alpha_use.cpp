// SPDX-License-Identifier: MIT
#include "pipeline/legalize/alpha_use.h"

#include <algorithm>

#include "pipeline/check/target_use.h"
#include "pipeline/legalize/window_map.h"

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

// Where a pass reads the alpha of a target, as far as it is the pass's own: nothing if it does not.
std::optional<PixelRect> area_read(const Frame& frame, const Pass& pass, TargetId target) {
    std::optional<PixelRect> area;
    const auto add = [&](const PixelRect& rect) {
        area = area ? PixelRect{std::min(area->x0, rect.x0), std::min(area->y0, rect.y0), std::max(area->x1, rect.x1),
                                std::max(area->y1, rect.y1)}
                    : rect;
    };
    if (pass.color == target && draws(pass) && reads_dest_alpha(pass.state)) add(limit_of(frame, pass));
    for_each_texture(pass, [&](std::size_t, std::size_t stage, const TextureBinding& binding) {
        const Target& whole = frame.targets[static_cast<std::size_t>(target.index)];
        if (binding.target == target && reads_texture_alpha(pass.state, stage)) add({0, 0, whole.width, whole.height});
    });
    for (const Draw& draw : pass.draws) {
        const auto* copy = std::get_if<CopyRectangle>(&draw);
        if (copy != nullptr && copy->source == target && copy->channels != CopyChannels::GreenToAlpha) add(copy->from);
    }
    return area;
}

bool copies_alpha_over(const Pass& pass, const PixelRect& area) {
    return std::any_of(pass.draws.begin(), pass.draws.end(), [&](const Draw& draw) {
        const auto* copy = std::get_if<CopyRectangle>(&draw);
        if (copy == nullptr || copy->channels == CopyChannels::AlphaToColor) return false;
        const int step = copy->halve ? 2 : 1;
        return contains({copy->x, copy->y, copy->x + (copy->from.x1 - copy->from.x0) / step,
                         copy->y + (copy->from.y1 - copy->from.y0) / step},
                        area);
    });
}

// Do two passes cover the same pixels, whatever else they do? Window triangles at the same places.
bool is_of_same_shape(const Frame& frame, const Pass& a, const Pass& b) {
    if (a.draws.size() != b.draws.size() || a.state.scissor != b.state.scissor ||
        a.state.viewport != b.state.viewport || a.state.cull != b.state.cull)
        return false;
    for (std::size_t i = 0; i < a.draws.size(); ++i) {
        const auto *one   = std::get_if<DrawWindowTriangles>(&a.draws[i]),
                   *other = std::get_if<DrawWindowTriangles>(&b.draws[i]);
        if (one == nullptr || other == nullptr || one->index_count != other->index_count) return false;
        for (std::uint32_t k = 0; k < one->index_count; ++k) {
            const WindowVertex &v = frame.window_vertices[frame.indices[one->first_index + k]],
                               &w = frame.window_vertices[frame.indices[other->first_index + k]];
            if (v.x != w.x || v.y != w.y) return false;
        }
    }
    return true;
}

// Does a pass write all alpha of what `reader` reads within the area?
bool writes_alpha(const Frame& frame, const Pass& pass, const Pass& reader, const PixelRect& area) {
    if (copies_alpha_over(pass, area)) return true;
    const PipelineState& state = pass.state;
    const bool surely = draws(pass) && state.color_mask.alpha && state.blend == kReplace && !uses_depth(pass) &&
                        state.alpha_test == AlphaTestState{} && state.dest_alpha_test == DestAlphaTest::Off;
    return surely &&
           (covers(frame, pass, area) || (reader.color == pass.color && is_of_same_shape(frame, pass, reader)));
}

bool clears_color(const Frame& frame, const Pass& pass) {
    const Target& target = frame.targets[static_cast<std::size_t>(pass.color.index)];
    return pass.clear.color && contains(limit_of(frame, pass), {0, 0, target.width, target.height});
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

bool is_alpha_needed(const Frame& frame, std::size_t index) {
    const TargetId target = frame.passes[index].color;
    if (find_target(frame, target) == nullptr) return false;
    for (std::size_t i = index + 1; i < frame.passes.size(); ++i) {
        const Pass& reader = frame.passes[i];
        if (reader.color == target && clears_color(frame, reader)) return false;
        const std::optional<PixelRect> area = area_read(frame, reader, target);
        if (!area) continue;
        bool is_new = false;
        for (std::size_t k = index + 1; k < i && !is_new; ++k)
            is_new = frame.passes[k].color == target && writes_alpha(frame, frame.passes[k], reader, *area);
        if (!is_new) return true;
    }
    return false;
}

bool is_alpha_read(const Frame& frame, TargetId target) {
    return std::any_of(frame.passes.begin(), frame.passes.end(),
                       [&](const Pass& pass) { return reads_alpha_in(pass, target); });
}

}  // namespace pipeline
