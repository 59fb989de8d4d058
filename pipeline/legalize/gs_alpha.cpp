// SPDX-License-Identifier: MIT
#include "pipeline/legalize/gs_alpha.h"

#include "pipeline/check/chip_findings.h"
#include "pipeline/check/target_use.h"
#include "pipeline/legalize/alpha_use.h"
#include "pipeline/legalize/gs_blend.h"
#include "pipeline/legalize/vertex_colors.h"

namespace pipeline {

namespace {

enum class Operand { Vertex, Texel, Other };
Operand operand_of(const TextureArg& arg) {
    if (arg.complement || arg.alpha_replicate) return Operand::Other;
    if (arg.source == ArgSource::Texture) return Operand::Texel;
    return arg.source == ArgSource::Diffuse || arg.source == ArgSource::Current ? Operand::Vertex : Operand::Other;
}

// What an op makes of vertex colour and texel.
enum class Result { Vertex, Texel, Product, DoubleProduct, Other };
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

// TFX and TCC: MODULATE, DECAL, or no texture.
bool has_gs_function(const PipelineState& state) {
    const Result color = color_of(state), alpha = alpha_of(state);
    if (stage_count(state) > 1) return false;
    if (color == Result::Vertex) return alpha == Result::Vertex;
    if (color == Result::Texel) return alpha == Result::Texel || alpha == Result::Vertex;
    return color != Result::Other && (alpha == Result::Vertex || alpha == Result::Product);
}

bool has_gs_format(const Frame& frame, TargetId id) {
    const Target* target = find_target(frame, id);
    return target == nullptr || target->format == TargetFormat::Psmct32 || target->format == TargetFormat::Psmct24 ||
           target->format == TargetFormat::Psmct16;
}

bool can_count_anew(const Frame& frame, const Pass& pass) {
    if (!has_gs_format(frame, pass.color)) return false;
    if (!draws(pass)) return true;
    return has_gs_function(pass.state) && has_gs_blend(frame, pass) && pass.state.dest_alpha_test == DestAlphaTest::Off;
}

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
Argb scaled(Argb color, const PipelineState& state) {
    return scales_colors(state) ? in_gs_scale(color) : with_gs_alpha(color);
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
    constexpr std::size_t kAlpha = 0, kAll = 1;
    const std::array<Recolor, 2> kinds{[](Vertex& vertex) {
                                           vertex.diffuse  = with_gs_alpha(vertex.diffuse);
                                           vertex.specular = with_gs_alpha(vertex.specular);
                                       },
                                       [](Vertex& vertex) {
                                           vertex.diffuse  = in_gs_scale(vertex.diffuse);
                                           vertex.specular = in_gs_scale(vertex.specular);
                                       }};
    std::vector<DrawColors> draws;
    for (Pass& pass : frame.passes)
        for (Draw& draw : pass.draws)
            if (auto* triangles = std::get_if<DrawTriangles>(&draw))
                draws.push_back({triangles, scales_colors(pass.state) ? kAll : kAlpha});
    recolor_vertices(frame, draws, kinds);
}

// Is the texture's alpha read by a draw of any pass?
std::vector<bool> textures_with_alpha(const Frame& frame) {
    std::vector<bool> reads(frame.textures.size());
    for (const Pass& pass : frame.passes)
        for_each_texture(pass, [&](std::size_t, std::size_t stage, const TextureBinding& binding) {
            if (binding.texture && reads_texture_alpha(pass.state, stage))
                reads[static_cast<std::size_t>(binding.texture.index)] = true;
        });
    return reads;
}

void expand_grey(Texture& texture) {
    std::vector<std::uint8_t> texels;
    texels.reserve(texture.texels.size() * 4);
    for (const std::uint8_t grey : texture.texels) texels.insert(texels.end(), {grey, grey, grey, 0x80});
    texture.format = TextureFormat::A8R8G8B8;
    texture.texels = std::move(texels);
}

void scale_textures(Frame& frame, RewriteNotes& notes) {
    const std::vector<bool> reads_alpha = textures_with_alpha(frame);
    for (std::size_t i = 0; i < frame.textures.size(); ++i) {
        Texture& texture = frame.textures[i];
        if (texture.format == TextureFormat::L8 && reads_alpha[i]) {
            expand_grey(texture);
            notes.push_back({"gs_alpha", Place("texture", i, texture.name).text(),
                             "L8 has alpha 255, and one is 0x80 on the chip", "L8 became A8R8G8B8 with alpha 0x80"});
            continue;
        }
        const std::size_t step = static_cast<std::size_t>(bytes_per_texel(texture.format));
        if (texture.format == TextureFormat::L8) continue;
        for (std::size_t alpha = step - 1; alpha < texture.texels.size(); alpha += step)
            texture.texels[alpha] = to_gs_scale(texture.texels[alpha]);
    }
}

// The textures of one texel that stand for white, one for what is multiplied and one for what is selected.
class Whites {
  public:
    explicit Whites(Frame& frame) : frame_(frame) {}

    void bind(Pass& pass) {
        if (!reads_texture(pass.state, 0)) return;
        for (Draw& draw : pass.draws) {
            TextureBindings* textures = nullptr;
            if (auto* triangles = std::get_if<DrawTriangles>(&draw)) textures = &triangles->textures;
            if (auto* rectangle = std::get_if<DrawRectangle>(&draw)) textures = &rectangle->textures;
            if (textures == nullptr || (*textures)[0].texture || (*textures)[0].target) continue;
            (*textures)[0].texture = white(scales_colors(pass.state) ? 0x80 : 0xff);
        }
    }

  private:
    TextureId white(std::uint8_t color) {
        TextureId& id = color == 0x80 ? one_ : white_;
        if (id) return id;
        id = {static_cast<std::int32_t>(frame_.textures.size())};
        frame_.textures.push_back({.name   = color == 0x80 ? "one" : "white",
                                   .format = TextureFormat::A8R8G8B8,
                                   .width  = 1,
                                   .height = 1,
                                   .texels = {color, color, color, 0x80}});
        return id;
    }

    Frame& frame_;
    TextureId one_, white_;
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
    if (color_of(state) == Result::DoubleProduct) state.stages[0].color_op = TextureOp::Modulate;
}

}  // namespace

Frame rewrite_gs_alpha(Frame frame, const Profile& profile, RewriteNotes& notes) {
    if (profile.arithmetic.combine != CombineRule::GsShift7 || frame.arithmetic.combine == CombineRule::GsShift7)
        return frame;
    const auto can = [&](const Pass& pass) { return can_count_anew(frame, pass); };
    if (!std::all_of(frame.passes.begin(), frame.passes.end(), can)) return frame;

    frame.arithmetic.combine = CombineRule::GsShift7;
    notes.push_back({"gs_alpha", "frame", "one is 0x80 for alpha and in products with texels",
                     "alpha, and colours that texels multiply, are counted to 0x80"});
    for (Pass& pass : frame.passes) drop_unread(pass);
    scale_vertices(frame);
    scale_textures(frame, notes);
    Whites whites(frame);
    for (Pass& pass : frame.passes) {
        whites.bind(pass);
        if (draws(pass) || pass.clear.color) scale_pass(pass);
    }
    return frame;
}

}  // namespace pipeline
