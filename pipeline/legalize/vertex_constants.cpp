// SPDX-License-Identifier: MIT
#include "pipeline/legalize/vertex_constants.h"

#include "pipeline/check/chip_findings.h"
#include "pipeline/check/target_use.h"
#include "pipeline/legalize/vertex_changes.h"

namespace pipeline {

namespace {

constexpr std::uint32_t kRgb = 0x00ffffff, kAlpha = 0xff000000;

// The channels of vertex colours and of TFACTOR that a pass's stages read.
struct Reads {
    std::uint32_t vertex = 0, factor = 0;
};

void add_argument(const TextureArg& arg, std::size_t stage, std::uint32_t channels, Reads& reads) {
    if (arg.alpha_replicate) channels = kAlpha;
    if (arg.source == ArgSource::TFactor) reads.factor |= channels;
    if (arg.source == ArgSource::Diffuse || (arg.source == ArgSource::Current && stage == 0)) reads.vertex |= channels;
}
void add_op(TextureOp op, const TextureArg& arg1, const TextureArg& arg2, std::size_t stage, std::uint32_t channels,
            Reads& reads) {
    if (op != TextureOp::SelectArg2) add_argument(arg1, stage, channels, reads);
    if (op != TextureOp::SelectArg1) add_argument(arg2, stage, channels, reads);
    if (op == TextureOp::ModulateColorAddAlpha) add_argument(arg1, stage, kAlpha, reads);
    if (op == TextureOp::BlendDiffuseAlpha || (op == TextureOp::BlendCurrentAlpha && stage == 0))
        reads.vertex |= kAlpha;
    if (op == TextureOp::BlendFactorAlpha) reads.factor |= kAlpha;
}
Reads reads_of(const PipelineState& state) {
    Reads reads;
    for (std::size_t i = 0; i < static_cast<std::size_t>(stage_count(state)); ++i) {
        const TextureStage& stage = state.stages[i];
        add_op(stage.color_op, stage.color_arg1, stage.color_arg2, i, kRgb, reads);
        add_op(stage.alpha_op, stage.alpha_arg1, stage.alpha_arg2, i, kAlpha, reads);
    }
    return reads;
}

// What a pass's vertices become in `channels`.
struct Constant {
    std::uint32_t channels = 0, color = 0;
    bool operator==(const Constant&) const = default;
    Argb in(Argb old) const { return {(old.value & ~channels) | (color & channels)}; }
};

void read_vertex(TextureArg& arg, std::uint32_t channels, std::uint32_t moved) {
    if (arg.alpha_replicate) channels = kAlpha;
    if (arg.source == ArgSource::TFactor && (channels & moved) != 0) arg.source = ArgSource::Diffuse;
}

// The blend ops' own TFACTOR and alpha arguments have no DIFFUSE form that keeps the others, so that only arguments move.
bool blends_by_factor(const PipelineState& state) {
    return std::any_of(state.stages.begin(), state.stages.end(), [](const TextureStage& stage) {
        return stage.color_op == TextureOp::BlendFactorAlpha || stage.alpha_op == TextureOp::BlendFactorAlpha;
    });
}

Constant move_factor(PipelineState& state) {
    const Reads reads         = reads_of(state);
    const std::uint32_t moved = blends_by_factor(state) ? 0 : reads.factor & ~reads.vertex;
    for (TextureStage& stage : state.stages) {
        read_vertex(stage.color_arg1, kRgb, moved);
        read_vertex(stage.color_arg2, kRgb, moved);
        read_vertex(stage.alpha_arg1, kAlpha, moved);
        read_vertex(stage.alpha_arg2, kAlpha, moved);
    }
    return {moved, state.texture_factor.value};
}

bool selects_texture(const TextureStage& stage) {
    const auto is_plain = [](const TextureArg& arg) {
        return arg.source == ArgSource::Texture && !arg.complement && !arg.alpha_replicate;
    };
    return (stage.color_op == TextureOp::SelectArg1 && is_plain(stage.color_arg1)) ||
           (stage.color_op == TextureOp::SelectArg2 && is_plain(stage.color_arg2));
}

// DECAL has no product for alpha, MODULATE has.
Constant multiply_by_white(PipelineState& state) {
    TextureStage& stage = state.stages[0];
    if (stage_count(state) != 1 || !selects_texture(stage) || stage.alpha_op != TextureOp::Modulate) return {};
    stage.color_op   = TextureOp::Modulate;
    stage.color_arg1 = {.source = ArgSource::Texture};
    stage.color_arg2 = {.source = ArgSource::Diffuse};
    return {kRgb, kRgb};
}

// white_is_one: a product with 255 changes nothing.
Constant rewrite_state(PipelineState& state, const Profile& profile, bool white_is_one) {
    if (state.lighting.enabled) return {};
    Constant constant;
    if (!is_among(ArgSource::TFactor, profile.states.arguments)) constant = move_factor(state);
    if (profile.arithmetic.combine != CombineRule::GsShift7 || !white_is_one) return constant;
    const Constant white = multiply_by_white(state);
    return {constant.channels | white.channels,
            (constant.color & constant.channels & ~white.channels) | (white.color & white.channels)};
}

class Kinds {
  public:
    std::size_t of(const Constant& constant) {
        const auto found = std::find(constants_.begin(), constants_.end(), constant);
        if (found != constants_.end()) return static_cast<std::size_t>(found - constants_.begin());
        constants_.push_back(constant);
        return constants_.size() - 1;
    }
    std::vector<VertexChange> changes() const {
        std::vector<VertexChange> all;
        for (const Constant& constant : constants_)
            all.push_back(change_of_diffuse([constant](Argb diffuse) { return constant.in(diffuse); }));
        return all;
    }

  private:
    std::vector<Constant> constants_;
};

}  // namespace

Frame rewrite_vertex_constants(Frame frame, const Profile& profile, RewriteNotes& notes) {
    const bool white_is_one = frame.arithmetic.combine != CombineRule::GsShift7;
    Kinds kinds;
    std::vector<ChangedDraw> changed;
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        Pass& pass              = frame.passes[i];
        const Constant constant = draws(pass) ? rewrite_state(pass.state, profile, white_is_one) : Constant{};
        for (Draw& draw : pass.draws) {
            changed.push_back({&draw, kinds.of(constant)});
            if (auto* rectangle = std::get_if<DrawRectangle>(&draw)) rectangle->color = constant.in(rectangle->color);
        }
        if (constant.channels != 0)
            notes.push_back(
                {"vertex_constants", Place("pass", i, pass.label).text(),
                 "the chip's stages read no constant, and DECAL has no product for alpha",
                 "vertices' colours are " + text_of(Argb{constant.color}) + " in " + text_of(Argb{constant.channels})});
    }
    change_vertices(frame, changed, kinds.changes());
    return frame;
}

}  // namespace pipeline
