// SPDX-License-Identifier: MIT
#include "demo/vectors/chip_limits.h"

#include <algorithm>

namespace demo {

using namespace pipeline;

namespace {

template <class T>
bool is_among(const T& value, const std::vector<T>& values) {
    return std::find(values.begin(), values.end(), value) != values.end();
}

template <NamedEnum Enum>
std::string text(Enum value) {
    return std::string(enum_name(value));
}

const Target& at(const Frame& frame, TargetId id) {
    return frame.targets[static_cast<std::size_t>(id.index)];
}

bool is_copy(const Draw& draw) {
    return std::holds_alternative<CopyRectangle>(draw);
}

// How a frame uses a target.
struct Uses {
    bool drawn = false, copied_to = false;
};
Uses uses_of(const Frame& frame, TargetId id) {
    Uses uses;
    for (const Pass& pass : frame.passes) {
        if (pass.color != id) continue;
        uses.drawn     = uses.drawn || pass.clear.color || !std::all_of(pass.draws.begin(), pass.draws.end(), &is_copy);
        uses.copied_to = uses.copied_to || std::any_of(pass.draws.begin(), pass.draws.end(), &is_copy);
    }
    return uses;
}

bool is_usable(const ChipFormats& formats, TargetFormat format, const Uses& uses) {
    return (!uses.drawn || is_among(format, formats.draw)) &&
           (!uses.copied_to || is_among(format, formats.copy_targets));
}

bool reads(TextureOp op, int argument) {
    return op != TextureOp::Disable && op != (argument == 1 ? TextureOp::SelectArg2 : TextureOp::SelectArg1);
}

// The arguments that a stage reads.
std::vector<TextureArg> arguments_of(const TextureStage& stage) {
    std::vector<TextureArg> arguments;
    if (reads(stage.color_op, 1)) arguments.push_back(stage.color_arg1);
    if (reads(stage.color_op, 2)) arguments.push_back(stage.color_arg2);
    if (reads(stage.alpha_op, 1)) arguments.push_back(stage.alpha_arg1);
    if (reads(stage.alpha_op, 2)) arguments.push_back(stage.alpha_arg2);
    return arguments;
}

// What the Graphics Synthesizer's TFX and TCC can say: the colour functions, and those of alpha that go with each.
enum class GsSource { Other, Vertex, Texel };
GsSource selected(TextureOp op, const TextureArg& arg1, const TextureArg& arg2) {
    if (op != TextureOp::SelectArg1 && op != TextureOp::SelectArg2) return GsSource::Other;
    const ArgSource source = (op == TextureOp::SelectArg1 ? arg1 : arg2).source;
    return source == ArgSource::Texture ? GsSource::Texel : GsSource::Vertex;
}
bool is_gs_function(const TextureStage& stage) {
    const GsSource color = selected(stage.color_op, stage.color_arg1, stage.color_arg2),
                   alpha = selected(stage.alpha_op, stage.alpha_arg1, stage.alpha_arg2);
    const auto has_both  = [](const TextureArg& one, const TextureArg& other) {
        return (one.source == ArgSource::Texture) != (other.source == ArgSource::Texture);
    };
    const bool alphas_meet = has_both(stage.alpha_arg1, stage.alpha_arg2);
    if (color == GsSource::Vertex) return alpha == GsSource::Vertex;  // no texture
    if (color == GsSource::Texel) return alpha != GsSource::Other;    // DECAL
    if (!has_both(stage.color_arg1, stage.color_arg2)) return false;
    if (stage.color_op == TextureOp::Modulate)
        return alpha == GsSource::Vertex || (stage.alpha_op == TextureOp::Modulate && alphas_meet);
    if (stage.color_op == TextureOp::ModulateColorAddAlpha && stage.color_arg2.source == ArgSource::Texture)
        return alpha != GsSource::Other || (stage.alpha_op == TextureOp::Add && alphas_meet);
    return false;
}

// Each check says what the chip lacks, or nothing.

std::string targets(const Frame& frame, const Profile& profile) {
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(frame.targets.size()); ++i) {
        const TargetFormat format = at(frame, {i}).format;
        const Uses uses           = uses_of(frame, {i});
        if (is_depth(format)) {
            if (!is_among(format, profile.formats.depth)) return "depth of " + text(format);
        } else if (uses.drawn && !is_among(format, profile.formats.draw)) {
            return "drawing to " + text(format);
        } else if (uses.copied_to && !is_among(format, profile.formats.copy_targets)) {
            return "copies to " + text(format);
        }
    }
    return {};
}

std::string depth_pairs(const Frame& frame, const Profile& profile) {
    for (const Pass& pass : frame.passes) {
        if (!pass.color || !pass.depth) continue;
        const TargetFormat color = at(frame, pass.color).format, depth = at(frame, pass.depth).format;
        if (!go_together(profile.formats, color, depth)) return text(depth) + " beside " + text(color);
    }
    return {};
}

std::string copies(const Frame& frame, const Profile& profile) {
    for (const Pass& pass : frame.passes) {
        for (const Draw& draw : pass.draws) {
            for (const TextureBinding& binding : textures_of(draw))
                if (binding.target && !profile.formats.reads_targets) return "textures that were drawn to, not copied";
            const auto* copy = std::get_if<CopyRectangle>(&draw);
            if (copy == nullptr) continue;
            if (copy->halve ? !profile.formats.copies_halve : !profile.formats.copies)
                return copy->halve ? "halving copies" : "copies";
            if (at(frame, pass.color).format != at(frame, copy->source).format && !profile.formats.copies_convert)
                return "copies from one format to another";
        }
    }
    return {};
}

std::string blend(const Pass& pass, const Profile& profile) {
    const PipelineState& state = pass.state;
    const bool is_gs           = profile.arithmetic.blend == BlendRule::GsShift7;
    if (is_gs && state.blend != kReplace) return "blend by two factors";
    if (!is_gs && state.gs_blend != GsBlend{}) return "blend by register ALPHA";
    if (!is_among(state.blend.source, profile.states.source_factors))
        return "blend factor " + text(state.blend.source) + " for the source";
    if (!is_among(state.blend.dest, profile.states.dest_factors))
        return "blend factor " + text(state.blend.dest) + " for the destination";
    return {};
}

std::string dither(const Pass& pass, const Profile& profile) {
    const DitherMode mode = pass.state.dither.mode;
    return is_among(mode, profile.states.dithers) ? "" : "dither " + text(mode);
}

std::string color_mask(const Pass& pass, const Profile& profile) {
    const ColorMask& mask = pass.state.color_mask;
    if (mask == ColorMask{}) return {};
    if (profile.states.color_mask == MaskKind::None) return "colour mask";
    const bool is_apart = mask.red != mask.green || mask.green != mask.blue;
    return is_apart && profile.states.color_mask == MaskKind::ColorAndAlpha ? "mask for red, green or blue alone" : "";
}

std::string tests(const Pass& pass, const Profile& profile) {
    const PipelineState& state = pass.state;
    if (pass.depth && !is_among(state.depth.func, profile.states.depth_funcs))
        return "depth function " + text(state.depth.func);
    if (!is_among(state.alpha_test.fail, profile.states.alpha_fails))
        return "write of fragments that fail the alpha test (" + text(state.alpha_test.fail) + ")";
    if (state.dest_alpha_test != DestAlphaTest::Off && !profile.states.dest_alpha_test)
        return "test of the alpha in the target";
    if (state.scissor != PixelRect{} && !profile.states.scissor) return "scissor";
    return {};
}

std::string triangles(const Pass& pass, const Profile& profile) {
    const bool has_triangles = std::any_of(pass.draws.begin(), pass.draws.end(), [](const Draw& draw) {
        return std::holds_alternative<DrawTriangles>(draw);
    });
    if (!has_triangles) return {};
    if (pass.state.cull != CullMode::None && !profile.states.culling) return "culling";
    if (pass.state.shade != ShadeMode::Flat || profile.states.flat == FlatVertex::First) return {};
    return profile.states.flat == FlatVertex::None ? "flat shading" : "flat shading by the first vertex";
}

std::string specular_addition(const Pass& pass, const Profile& profile) {
    const bool is_asked = pass.state.lighting.specular_enable;
    return is_asked && !profile.states.specular_addition ? "addition of a second colour" : "";
}

std::string stages(const Pass& pass, const Profile& profile) {
    const ChipStates& states = profile.states;
    const int count          = stage_count(pass.state);
    if (count > states.stages) return states.stages == 1 ? "second texture stage" : "so many texture stages";
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const TextureStage& stage = pass.state.stages[i];
        for (const TextureArg& argument : arguments_of(stage)) {
            if (!is_among(argument.source, states.arguments)) return "stage argument " + text(argument.source);
            if (argument.complement && !states.complement) return "complement of a stage argument";
            if (argument.alpha_replicate && !states.alpha_replicate) return "stage argument of alpha in every channel";
        }
        for (const TextureOp op : {stage.color_op, stage.alpha_op})
            if (!has_rule(profile.arithmetic.combine, op)) return "texture function " + text(op);
        if (profile.arithmetic.combine == CombineRule::GsShift7 && !is_gs_function(stage))
            return "texture function " + text(stage.color_op) + " with " + text(stage.alpha_op) +
                   " of alpha and such arguments";
        for (const TextureAddress address : {stage.address_u, stage.address_v})
            if (!is_among(address, states.addresses)) return "texture address " + text(address);
        if (!is_among(stage.mip_filter, states.mip_filters))
            return "level of detail by the texels that a pixel spans (mip filter " + text(stage.mip_filter) + ")";
    }
    return {};
}

constexpr std::string (*kFrameRules[])(const Frame&, const Profile&) = {&targets, &depth_pairs, &copies};
constexpr std::string (*kPassRules[])(const Pass&, const Profile&)   = {
      &blend, &dither, &color_mask, &tests, &triangles, &specular_addition, &stages};

}  // namespace

Frame put_on_chip(Frame frame, const Profile& profile) {
    frame.arithmetic = profile.arithmetic;
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(frame.targets.size()); ++i) {
        TargetFormat& format = frame.targets[static_cast<std::size_t>(i)].format;
        if (is_usable(profile.formats, format, uses_of(frame, {i}))) continue;
        if (format == TargetFormat::A8R8G8B8) format = profile.formats.with_alpha;
        if (format == TargetFormat::X8R8G8B8) format = profile.formats.opaque;
    }
    return frame;
}

std::string what_is_missing(const Frame& frame, const Profile& profile) {
    const std::string chip = std::string(profile.name) + " has no ";
    for (const auto rule : kFrameRules)
        if (const std::string missing = rule(frame, profile); !missing.empty()) return chip + missing;
    for (const Pass& pass : frame.passes)
        for (const auto rule : kPassRules)
            if (const std::string missing = rule(pass, profile); !missing.empty()) return chip + missing;
    return {};
}

}  // namespace demo
