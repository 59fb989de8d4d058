// SPDX-License-Identifier: MIT
#include "pipeline/legalize/gs_alpha.h"

#include <algorithm>
#include <functional>
#include <iterator>

#include "pipeline/check/chip_findings.h"
#include "pipeline/check/target_use.h"
#include "pipeline/legalize/alpha_use.h"
#include "pipeline/legalize/dest_alpha_test.h"
#include "pipeline/legalize/gs_blend.h"
#include "pipeline/legalize/vertex_changes.h"

namespace pipeline {

namespace {

enum class Operand { Vertex, Texel, Other };
Operand operand_of(const TextureArg& arg) {
    if (arg.complement || arg.alpha_replicate) return Operand::Other;
    if (arg.source == ArgSource::Texture) return Operand::Texel;
    return arg.source == ArgSource::Diffuse || arg.source == ArgSource::Current ? Operand::Vertex : Operand::Other;
}

// What an op makes of vertex colour and texel.
enum class Result { Vertex, Texel, Product, DoubleProduct, QuadProduct, Other };
Result result_of(TextureOp op, const TextureArg& arg1, const TextureArg& arg2) {
    const Operand one = operand_of(arg1), other = operand_of(arg2);
    const auto selected = [](Operand operand) {
        return operand == Operand::Vertex ? Result::Vertex : operand == Operand::Texel ? Result::Texel : Result::Other;
    };
    const bool is_of_both = one != Operand::Other && other != Operand::Other && one != other;
    switch (op) {
        case TextureOp::SelectArg1:
            return selected(one);
        case TextureOp::SelectArg2:
            return selected(other);
        case TextureOp::Modulate:
            return is_of_both ? Result::Product : Result::Other;
        case TextureOp::Modulate2X:
            return is_of_both ? Result::DoubleProduct : Result::Other;
        case TextureOp::Modulate4X:
            return is_of_both ? Result::QuadProduct : Result::Other;
        default:
            return Result::Other;
    }
}
Result color_of(const PipelineState& state) {
    const TextureStage& stage = state.stages[0];
    return stage_count(state) == 0 ? Result::Vertex : result_of(stage.color_op, stage.color_arg1, stage.color_arg2);
}
Result alpha_of(const PipelineState& state) {
    const TextureStage& stage = state.stages[0];
    return stage_count(state) == 0 ? Result::Vertex : result_of(stage.alpha_op, stage.alpha_arg1, stage.alpha_arg2);
}

bool exceeds_one(Result alpha) {
    return alpha == Result::DoubleProduct || alpha == Result::QuadProduct;
}

// TFX and TCC: MODULATE, DECAL, or no texture.
bool has_gs_function(const PipelineState& state) {
    const Result color = color_of(state), alpha = alpha_of(state);
    if (stage_count(state) > 1) return false;
    if (color == Result::Vertex) return alpha == Result::Vertex;
    if (color == Result::Texel) return alpha == Result::Texel || alpha == Result::Vertex;
    return (color == Result::Product || color == Result::DoubleProduct) &&
           (alpha == Result::Vertex || alpha == Result::Product || exceeds_one(alpha));
}

// Alpha above one is cut there by two passes, which blend and replace.
bool can_cut(const PipelineState& state) {
    return state.blend == kAlphaOver && state.alpha_test == AlphaTestState{} && !state.depth.write;
}

bool has_gs_format(const Frame& frame, TargetId id) {
    const Target* target = find_target(frame, id);
    return target == nullptr || target->format == TargetFormat::Psmct32 || target->format == TargetFormat::Psmct24 ||
           target->format == TargetFormat::Psmct16;
}

// Is the green that a copy takes for alpha read by nothing later?
bool is_last_use(const Frame& frame, std::size_t index, const CopyRectangle& copy) {
    for (std::size_t i = index + 1; i < frame.passes.size(); ++i) {
        const Pass& pass = frame.passes[i];
        bool reads = pass.color == copy.source && draws(pass), is_new = false;
        for_each_texture(pass, [&](std::size_t, std::size_t, const TextureBinding& binding) {
            reads = reads || binding.target == copy.source;
        });
        for (const Draw& draw : pass.draws) {
            const auto* other = std::get_if<CopyRectangle>(&draw);
            if (other == nullptr) continue;
            reads  = reads || other->source == copy.source;
            is_new = is_new || (pass.color == copy.source && other->channels == CopyChannels::AlphaToColor);
        }
        if (reads) return false;
        if (is_new) return true;
    }
    return copy.source != frame.output;
}

bool can_count_anew(const Frame& frame, std::size_t index) {
    const Pass& pass = frame.passes[index];
    if (!has_gs_format(frame, pass.color)) return false;
    for (const Draw& draw : pass.draws)
        if (const auto* copy = std::get_if<CopyRectangle>(&draw))
            if (copy->channels == CopyChannels::GreenToAlpha && !is_last_use(frame, index, *copy)) return false;
    if (!draws(pass)) return true;
    if (pass.state.dest_alpha_test != DestAlphaTest::Off && !is_tested_alpha_known(frame, index)) return false;
    return has_gs_function(pass.state) && has_gs_blend(frame, index) &&
           (!exceeds_one(alpha_of(pass.state)) || can_cut(pass.state));
}

constexpr std::uint8_t kOne = 0x80;

Argb with_gs_alpha(Argb color) {
    const auto alpha = static_cast<std::uint8_t>(color.value >> 24);
    return {(color.value & 0x00ffffff) | static_cast<std::uint32_t>(to_gs_scale(alpha)) << 24};
}
Argb in_gs_scale(Argb color) {
    std::uint32_t value = 0;
    for (int shift = 0; shift < 32; shift += 8)
        value |= static_cast<std::uint32_t>(to_gs_scale(static_cast<std::uint8_t>(color.value >> shift))) << shift;
    return {value};
}

// What MODULATE multiplies is in the chip's scale; other colours are whole bytes.
bool scales_colors(const PipelineState& state) {
    return color_of(state) == Result::Product;
}
// Twice a product has them as they are, which is twice as much; of four times it so has the texture.
bool scales_alpha(const PipelineState& state) {
    return !exceeds_one(alpha_of(state));
}
Argb scaled(Argb color, const PipelineState& state) {
    const Argb alpha = scales_alpha(state) ? with_gs_alpha(color) : color;
    const Argb all   = scales_colors(state) ? in_gs_scale(color) : color;
    return {(alpha.value & 0xff000000) | (all.value & 0x00ffffff)};
}

void scale_material(PipelineState& state) {
    constexpr float kScale = 128.0f / 255.0f;
    Material& material     = state.lighting.material;
    material.diffuse.w *= kScale;
    if (!scales_colors(state)) return;
    material.diffuse  = Vec4(Vec3(material.diffuse) * kScale, material.diffuse.w);
    material.ambient  = material.ambient * kScale;
    material.emissive = material.emissive * kScale;
}

void scale_vertices(Frame& frame) {
    constexpr std::size_t kAlpha = 1, kRgb = 2;
    const auto rgb_alone = [](Argb color) {
        return Argb{(color.value & 0xff000000) | (in_gs_scale(color).value & 0x00ffffff)};
    };
    const std::array<VertexChange, 4> kinds{VertexChange{}, change_of_diffuse(&with_gs_alpha),
                                            change_of_diffuse(rgb_alone), change_of_diffuse(&in_gs_scale)};
    std::vector<ChangedDraw> draws;
    for (Pass& pass : frame.passes)
        for (Draw& draw : pass.draws)
            draws.push_back({&draw, (scales_alpha(pass.state) ? kAlpha : 0) + (scales_colors(pass.state) ? kRgb : 0)});
    change_vertices(frame, draws, kinds);
}

// Whose alpha the draws of passes read for which `is_meant` holds.
template <class IsMeant>
std::vector<bool> textures_with_alpha(const Frame& frame, IsMeant&& is_meant) {
    std::vector<bool> reads(frame.textures.size());
    for (const Pass& pass : frame.passes)
        for_each_texture(pass, [&](std::size_t, std::size_t stage, const TextureBinding& binding) {
            if (binding.texture && reads_texture_alpha(pass.state, stage) && is_meant(pass))
                reads[static_cast<std::size_t>(binding.texture.index)] = true;
        });
    return reads;
}

bool keeps_texels_alpha(const Pass& pass) {
    return alpha_of(pass.state) == Result::QuadProduct;
}

// Textures whose alpha stays as it is; those that other passes need scaled are doubled.
std::vector<bool> split_kept_textures(Frame& frame) {
    std::vector<bool> kept   = textures_with_alpha(frame, &keeps_texels_alpha);
    std::vector<bool> scaled = textures_with_alpha(frame, std::not_fn(&keeps_texels_alpha));
    for (std::size_t i = 0, count = frame.textures.size(); i < count; ++i) {
        if (!kept[i] || !scaled[i]) continue;
        const TextureId old{static_cast<std::int32_t>(i)}, copy{static_cast<std::int32_t>(frame.textures.size())};
        frame.textures.push_back(frame.textures[i]);
        frame.textures.back().name += ", alpha to 255";
        kept[i] = false;
        kept.push_back(true);
        for (Pass& pass : frame.passes)
            for (Draw& draw : pass.draws)
                if (TextureBindings* bindings = bindings_of(draw); bindings != nullptr && keeps_texels_alpha(pass))
                    if ((*bindings)[0].texture == old) (*bindings)[0].texture = copy;
    }
    return kept;
}

void expand_grey(Texture& texture) {
    std::vector<std::uint8_t> texels;
    texels.reserve(texture.texels.size() * 4);
    for (const std::uint8_t grey : texture.texels) texels.insert(texels.end(), {grey, grey, grey, 0x80});
    texture.format = TextureFormat::A8R8G8B8;
    texture.texels = std::move(texels);
}

void scale_textures(Frame& frame, RewriteNotes& notes) {
    const std::vector<bool> kept        = split_kept_textures(frame);
    const std::vector<bool> reads_alpha = textures_with_alpha(frame, [](const Pass&) { return true; });
    for (std::size_t i = 0; i < frame.textures.size(); ++i) {
        Texture& texture = frame.textures[i];
        if (texture.format == TextureFormat::L8 && reads_alpha[i]) {
            expand_grey(texture);
            notes.push_back({"gs_alpha", Place("texture", i, texture.name).text(),
                             "L8 has alpha 255, and one is 0x80 on the chip", "L8 became A8R8G8B8 with alpha 0x80"});
            continue;
        }
        const std::size_t step = static_cast<std::size_t>(bytes_per_texel(texture.format));
        if (texture.format == TextureFormat::L8 || kept[i]) continue;
        for (std::size_t alpha = step - 1; alpha < texture.texels.size(); alpha += step)
            texture.texels[alpha] = to_gs_scale(texture.texels[alpha]);
    }
}

// The texture of one texel that stands for white.
class White {
  public:
    explicit White(Frame& frame) : frame_(frame) {}

    void bind(Pass& pass) {
        if (!reads_texture(pass.state, 0)) return;
        for (Draw& draw : pass.draws) {
            TextureBindings* textures = bindings_of(draw);
            if (textures == nullptr || (*textures)[0].texture || (*textures)[0].target) continue;
            (*textures)[0].texture = white();
        }
    }

  private:
    TextureId white() {
        if (white_) return white_;
        white_ = {static_cast<std::int32_t>(frame_.textures.size())};
        frame_.textures.push_back({.name   = "white",
                                   .format = TextureFormat::A8R8G8B8,
                                   .width  = 1,
                                   .height = 1,
                                   .texels = {0xff, 0xff, 0xff, 0x80}});
        return white_;
    }

    Frame& frame_;
    TextureId white_;
};

// What nothing reads may still say what GS_SHIFT7 has not.
void drop_unread(Pass& pass) {
    const auto used = static_cast<std::size_t>(draws(pass) ? stage_count(pass.state) : 0);
    for (std::size_t i = used; i < pass.state.stages.size(); ++i) pass.state.stages[i] = {};
    if (used == 0) return;
    TextureStage& stage    = pass.state.stages[0];
    const auto drop_of_two = [](TextureOp op, TextureArg& arg1, TextureArg& arg2) {
        if (op == TextureOp::SelectArg1) arg2 = {.source = ArgSource::Current};
        if (op == TextureOp::SelectArg2) arg1 = {.source = ArgSource::Texture};
    };
    drop_of_two(stage.color_op, stage.color_arg1, stage.color_arg2);
    drop_of_two(stage.alpha_op, stage.alpha_arg1, stage.alpha_arg2);
}

void scale_pass(Pass& pass) {
    if (pass.clear.color) pass.clear.color = with_gs_alpha(*pass.clear.color);
    for (Draw& draw : pass.draws)
        if (auto* rectangle = std::get_if<DrawRectangle>(&draw))
            rectangle->color = scaled(rectangle->color, pass.state);
    PipelineState& state       = pass.state;
    state.alpha_test.reference = to_gs_scale(state.alpha_test.reference);
    if (state.lighting.enabled) scale_material(state);
    TextureStage& stage = state.stages[0];
    if (color_of(state) == Result::DoubleProduct) stage.color_op = TextureOp::Modulate;
    if (exceeds_one(alpha_of(state))) stage.alpha_op = TextureOp::Modulate;
}

// Blended where its alpha is below one, in place where it is not.
std::vector<Pass> cut_at_one(Pass pass) {
    Pass replacing  = pass;
    replacing.clear = {};
    replacing.label += ": alpha of one";
    replacing.state.blend      = kReplace;
    replacing.state.alpha_test = {.func = CompareFunc::GreaterEqual, .reference = kOne};
    pass.state.alpha_test      = {.func = CompareFunc::Less, .reference = kOne};
    return {std::move(pass), std::move(replacing)};
}

// A rectangle without textures over what a copy reads or writes.
Pass rectangle_over(const CopyRectangle& copy, TargetId target, std::string label, const BlendState& blend,
                    Argb color) {
    const bool is_source = target == copy.source;
    const auto x         = static_cast<float>(is_source ? copy.from.x0 : copy.x),
               y         = static_cast<float>(is_source ? copy.from.y0 : copy.y);
    DrawRectangle rectangle;
    rectangle.x0 = x, rectangle.x1 = x + static_cast<float>(copy.from.x1 - copy.from.x0);
    rectangle.y0 = y, rectangle.y1 = y + static_cast<float>(copy.from.y1 - copy.from.y0);
    rectangle.color = color;
    Pass pass{.label = std::move(label), .color = target, .clear = {}, .state = {}, .draws = {rectangle}};
    pass.state.blend            = blend;
    pass.state.color_mask.alpha = false;
    return pass;
}

constexpr BlendState kByOneMore{.source = BlendFactor::DestColor, .dest = BlendFactor::One};
constexpr BlendState kByAlpha{.source = BlendFactor::Zero, .dest = BlendFactor::SourceAlpha};

// What becomes alpha is counted to 0x80 before: half of it, rounded so that 255 is one, x + (x >> 6) of x = c >> 1. What alpha
// becomes is counted to 255 after: twice.
std::vector<Pass> with_scales(Pass pass) {
    std::vector<Pass> before, after;
    for (const Draw& draw : pass.draws) {
        const auto* copy = std::get_if<CopyRectangle>(&draw);
        if (copy == nullptr) continue;
        if (copy->channels == CopyChannels::GreenToAlpha) {
            before.push_back(rectangle_over(*copy, copy->source, pass.label + ": half", kByAlpha, {0x40000000}));
            before.push_back(
                rectangle_over(*copy, copy->source, pass.label + ": 128 for one", kByOneMore, {0x02040404}));
        }
        if (copy->channels == CopyChannels::AlphaToColor)
            after.push_back(rectangle_over(*copy, pass.color, pass.label + ": twice", kByOneMore, {0x80ffffff}));
    }
    before.push_back(std::move(pass));
    std::ranges::move(after, std::back_inserter(before));
    return before;
}

}  // namespace

Frame rewrite_gs_alpha(Frame frame, const Profile& profile, RewriteNotes& notes) {
    if (profile.arithmetic.combine != CombineRule::GsShift7 || frame.arithmetic.combine == CombineRule::GsShift7)
        return frame;
    for (std::size_t i = 0; i < frame.passes.size(); ++i)
        if (!can_count_anew(frame, i)) return frame;

    frame.arithmetic.combine = CombineRule::GsShift7;
    notes.push_back({"gs_alpha", "frame", "one is 0x80 for alpha and in products with texels",
                     "alpha, and colours that texels multiply, are counted to 0x80"});
    for (Pass& pass : frame.passes) drop_unread(pass);
    scale_vertices(frame);
    scale_textures(frame, notes);
    White white(frame);
    std::vector<Pass> passes;
    for (Pass& pass : frame.passes) {
        white.bind(pass);
        const bool is_cut = draws(pass) && exceeds_one(alpha_of(pass.state));
        if (draws(pass) || pass.clear.color) scale_pass(pass);
        std::ranges::move(is_cut ? cut_at_one(std::move(pass)) : with_scales(std::move(pass)),
                          std::back_inserter(passes));
    }
    frame.passes = std::move(passes);
    return frame;
}

}  // namespace pipeline
