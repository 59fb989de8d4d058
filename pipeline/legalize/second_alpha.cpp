// SPDX-License-Identifier: MIT
#include "pipeline/legalize/second_alpha.h"

#include <algorithm>
#include <map>

#include "pipeline/check/chip_findings.h"
#include "pipeline/check/target_use.h"
#include "pipeline/legalize/alpha_use.h"
#include "pipeline/legalize/vertex_changes.h"
#include "pipeline/legalize/window_map.h"

namespace pipeline {

namespace {

constexpr ColorMask kAlphaAlone{.red = false, .green = false, .blue = false, .alpha = true};
constexpr ColorMask kColorAlone{.red = true, .green = true, .blue = true, .alpha = false};
constexpr BlendState kByDestAlpha{.source = BlendFactor::DestAlpha, .dest = BlendFactor::InvDestAlpha};
constexpr BlendState kAdd{.source = BlendFactor::One, .dest = BlendFactor::One};
constexpr BlendState kByAlpha{.source = BlendFactor::Zero, .dest = BlendFactor::SourceAlpha};
constexpr BlendState kInvert{.source = BlendFactor::InvDestColor, .dest = BlendFactor::Zero};
constexpr BlendState kByOneMore{.source = BlendFactor::DestColor, .dest = BlendFactor::One};
constexpr std::uint8_t kHalf = 127;

bool is_plain(const TextureArg& arg, ArgSource source) {
    return arg == TextureArg{.source = source};
}
// An op of two sources, in either order.
bool is_of(const TextureArg& arg1, const TextureArg& arg2, ArgSource one, ArgSource other) {
    return (is_plain(arg1, one) && is_plain(arg2, other)) || (is_plain(arg1, other) && is_plain(arg2, one));
}
bool selects(TextureOp op, const TextureArg& arg1, const TextureArg& arg2, ArgSource source) {
    return (op == TextureOp::SelectArg1 && is_plain(arg1, source)) ||
           (op == TextureOp::SelectArg2 && is_plain(arg2, source));
}

// What the first stage makes of its texel's alpha.
enum class FirstAlpha { Texel, Product, Difference };
std::optional<FirstAlpha> first_alpha(const TextureStage& stage) {
    if (selects(stage.alpha_op, stage.alpha_arg1, stage.alpha_arg2, ArgSource::Texture)) return FirstAlpha::Texel;
    if (stage.alpha_op == TextureOp::Modulate &&
        is_of(stage.alpha_arg1, stage.alpha_arg2, ArgSource::Texture, ArgSource::TFactor))
        return FirstAlpha::Product;
    if (stage.alpha_op == TextureOp::Subtract && is_plain(stage.alpha_arg1, ArgSource::Texture) &&
        is_plain(stage.alpha_arg2, ArgSource::TFactor))
        return FirstAlpha::Difference;
    return {};
}

bool has_first_color(const TextureStage& stage) {
    return selects(stage.color_op, stage.color_arg1, stage.color_arg2, ArgSource::Texture) ||
           (stage.color_op == TextureOp::Modulate &&
            is_of(stage.color_arg1, stage.color_arg2, ArgSource::Texture, ArgSource::TFactor));
}

enum class SecondAlpha { Product, SignedSum };
std::optional<SecondAlpha> second_alpha(const TextureStage& stage) {
    if (!selects(stage.color_op, stage.color_arg1, stage.color_arg2, ArgSource::Current)) return {};
    if (stage.alpha_op == TextureOp::Modulate &&
        is_of(stage.alpha_arg1, stage.alpha_arg2, ArgSource::Texture, ArgSource::TFactor))
        return SecondAlpha::Product;
    if (stage.alpha_op == TextureOp::AddSigned2X &&
        is_of(stage.alpha_arg1, stage.alpha_arg2, ArgSource::Texture, ArgSource::Current))
        return SecondAlpha::SignedSum;
    return {};
}

bool tests_nothing(const PipelineState& state) {
    return state.depth == DepthState{} && state.alpha_test.func == CompareFunc::Always &&
           state.dest_alpha_test == DestAlphaTest::Off && state.fog.mode == FogMode::None &&
           !state.lighting.specular_enable && state.dither == DitherState{} && state.gs_blend == GsBlend{};
}

// A texture whose every texel is below one half.
bool is_below_half(const Texture& texture) {
    return texture.format == TextureFormat::A8 &&
           std::all_of(texture.texels.begin(), texture.texels.end(), [](std::uint8_t a) { return a <= kHalf; });
}

class Rewriter {
  public:
    explicit Rewriter(Frame& frame) : frame_(frame) {}

    // Empty if the pass is no such one.
    std::vector<Pass> split(std::size_t index) {
        const Pass& pass = frame_.passes[index];
        if (!is_candidate(index)) return {};
        const SecondAlpha second = *second_alpha(pass.state.stages[1]);
        if (second == SecondAlpha::Product && pass.state.blend == kAlphaOver) return by_product(pass);
        if (second == SecondAlpha::SignedSum && first_alpha(pass.state.stages[0]) && has_fractals(pass))
            return by_sum(pass);
        return {};
    }

  private:
    bool is_candidate(std::size_t index) const {
        const Pass& pass           = frame_.passes[index];
        const PipelineState& state = pass.state;
        const bool in_window       = std::all_of(pass.draws.begin(), pass.draws.end(), [](const Draw& draw) {
            return std::holds_alternative<DrawWindowTriangles>(draw);
        });
        const Target* target       = find_target(frame_, pass.color);
        const ColorMask& mask      = state.color_mask;
        const bool blends =
            state.blend == kAlphaOver && mask.red && mask.green && mask.blue && !is_alpha_needed(frame_, index);
        // Elsewhere alpha becomes 0, within the limits that a clear has too.
        const bool replaces =
            state.blend == kReplace && mask == ColorMask{} && pass.clear.color && (pass.clear.color->value >> 24) == 0;
        const PixelRect limit = limit_of(pass);
        return limit.x0 < limit.x1 && limit.y0 < limit.y1 && !pass.draws.empty() && in_window && target != nullptr &&
               keeps_alpha(target->format) && stage_count(state) == 2 && tests_nothing(state) &&
               has_first_color(state.stages[0]) && second_alpha(state.stages[1]) && first_target(pass) &&
               (blends || replaces);
    }

    // The target that the first stage of all draws reads, of the pass's own size.
    TargetId first_target(const Pass& pass) const {
        const TargetId first = textures_of(pass.draws.front())[0].target;
        const Target *source = find_target(frame_, first), *target = find_target(frame_, pass.color);
        const bool is_one = std::all_of(pass.draws.begin(), pass.draws.end(), [&](const Draw& draw) {
            return textures_of(draw)[0] == TextureBinding{.texture = {}, .target = first};
        });
        const bool fits   = source != nullptr && keeps_bytes(source->format) && source->width == target->width &&
                          source->height == target->height;
        return is_one && fits ? first : TargetId{};
    }

    bool has_fractals(const Pass& pass) const {
        return std::all_of(pass.draws.begin(), pass.draws.end(), [&](const Draw& draw) {
            const Texture* texture = find_texture(frame_, textures_of(draw)[1].texture);
            return texture != nullptr && is_below_half(*texture);
        });
    }

    PixelRect limit_of(const Pass& pass) const { return pipeline::limit_of(frame_, pass); }

    // The pass's triangles with no state yet but what limits and culls them, and no textures.
    static Pass plain_pass(const Pass& pass, std::string_view what, TargetId color) {
        Pass plain;
        plain.label          = pass.label + ": " + std::string(what);
        plain.color          = color;
        plain.state.scissor  = pass.state.scissor;
        plain.state.viewport = pass.state.viewport;
        plain.state.cull     = pass.state.cull;
        plain.draws          = pass.draws;
        for (Draw& draw : plain.draws) *bindings_of(draw) = {};
        return plain;
    }

    Pass rectangle_pass(const Pass& pass, std::string_view what, const BlendState& blend, Argb color) const {
        Pass plain = plain_pass(pass, what, sums_);
        DrawRectangle rectangle;
        const PixelRect limit  = limit_of(pass);
        rectangle.x0           = static_cast<float>(limit.x0);
        rectangle.y0           = static_cast<float>(limit.y0);
        rectangle.x1           = static_cast<float>(limit.x1);
        rectangle.y1           = static_cast<float>(limit.y1);
        rectangle.color        = color;
        plain.draws            = {rectangle};
        plain.state.blend      = blend;
        plain.state.color_mask = kColorAlone;
        return plain;
    }

    Pass copy_pass(const Pass& pass, std::string_view what, TargetId from, TargetId to, CopyChannels channels) const {
        Pass copy             = plain_pass(pass, what, to);
        const PixelRect limit = limit_of(pass);
        copy.state            = {.viewport = pass.state.viewport, .scissor = pass.state.scissor};
        copy.draws = {CopyRectangle{.source = from, .from = limit, .x = limit.x0, .y = limit.y0, .channels = channels}};
        return copy;
    }

    // The second stage's texture as first, with its coordinates.
    Pass second_texture_pass(const Pass& pass, std::string_view what, TargetId color) {
        Pass plain          = plain_pass(pass, what, color);
        TextureStage& stage = plain.state.stages[0];
        stage               = pass.state.stages[1];
        stage.color_op      = TextureOp::SelectArg1;
        stage.color_arg1    = {.source = ArgSource::Texture};
        stage.color_arg2    = {.source = ArgSource::Current};
        for (std::size_t i = 0; i < plain.draws.size(); ++i) {
            (*bindings_of(plain.draws[i]))[0] = textures_of(pass.draws[i])[1];
            auto& triangles                   = std::get<DrawWindowTriangles>(plain.draws[i]);
            triangles.first_index             = with_second_coordinates(triangles);
        }
        return plain;
    }

    std::uint32_t with_second_coordinates(const DrawWindowTriangles& draw) {
        const auto [found, is_new] = second_.insert({{draw.first_index, draw.index_count}, 0});
        if (!is_new) return found->second;
        found->second = append_changed(frame_, draw, [](WindowVertex& vertex) {
            vertex.uv0     = vertex.uv1;
            vertex.diffuse = {0xffffffff};
        });
        return found->second;
    }

    // The first stage's colour.
    static Pass color_pass(const Pass& pass) {
        Pass color                       = plain_pass(pass, "colour", pass.color);
        color.state.texture_factor       = pass.state.texture_factor;
        color.state.stages[0]            = pass.state.stages[0];
        color.state.stages[0].alpha_op   = TextureOp::SelectArg2;
        color.state.stages[0].alpha_arg1 = {.source = ArgSource::Texture};
        color.state.stages[0].alpha_arg2 = {.source = ArgSource::TFactor};
        color.state.texture_factor.value |= 0xff000000;
        color.clear = pass.clear;
        for (std::size_t i = 0; i < color.draws.size(); ++i)
            (*bindings_of(color.draws[i]))[0] = textures_of(pass.draws[i])[0];
        return color;
    }

    static Pass blended_color_pass(const Pass& pass) {
        Pass color             = color_pass(pass);
        color.clear            = {};
        color.state.blend      = kByDestAlpha;
        color.state.color_mask = kColorAlone;
        return color;
    }

    std::vector<Pass> by_product(const Pass& pass) {
        Pass alpha                 = second_texture_pass(pass, "alpha", pass.color);
        alpha.clear                = pass.clear;
        alpha.state.color_mask     = kAlphaAlone;
        alpha.state.texture_factor = {pass.state.texture_factor.value | 0x00ffffff};
        return {std::move(alpha), blended_color_pass(pass)};
    }

    std::vector<Pass> by_sum(const Pass& pass) {
        const TargetId source = first_target(pass);
        make_sums_target(source);
        const auto factor      = static_cast<std::uint8_t>(pass.state.texture_factor.value >> 24);
        const FirstAlpha first = *first_alpha(pass.state.stages[0]);
        std::vector<Pass> passes;
        passes.push_back(copy_pass(pass, "alpha as colour", source, sums_, CopyChannels::AlphaToColor));
        if (first == FirstAlpha::Product && factor != 255)
            passes.push_back(rectangle_pass(pass, "times the factor", kByAlpha, {factor * 0x01000000u | 0xffffff}));
        passes.push_back(rectangle_pass(pass, "the other way round", kInvert, {0xffffffff}));
        if (first == FirstAlpha::Difference && factor != 0)
            passes.push_back(rectangle_pass(pass, "the factor off", kAdd, {0xff000000 | factor * 0x010101u}));
        passes.push_back(fractal_pass(pass));
        passes.push_back(rectangle_pass(pass, "back again", kInvert, {0xffffffff}));
        passes.push_back(rectangle_pass(pass, "twice", kByOneMore, {0xffffffff}));
        if (pass.state.blend == kReplace) {
            passes.push_back(color_pass(pass));
            passes.push_back(where_drawn(pass));
        }
        passes.push_back(copy_pass(pass, "colour as alpha", sums_, pass.color, CopyChannels::GreenToAlpha));
        if (pass.state.blend == kReplace) return passes;
        passes.back().clear = pass.clear;
        passes.push_back(blended_color_pass(pass));
        return passes;
    }

    Pass fractal_pass(const Pass& pass) {
        Pass fractal             = second_texture_pass(pass, "the texture off", sums_);
        TextureStage& stage      = fractal.state.stages[0];
        stage.alpha_op           = TextureOp::SelectArg2;
        stage.alpha_arg1         = {.source = ArgSource::Texture};
        stage.alpha_arg2         = {.source = ArgSource::Diffuse};
        fractal.state.blend      = kAdd;
        fractal.state.color_mask = kColorAlone;
        for (Draw& draw : fractal.draws) {
            TextureId& texture = (*bindings_of(draw))[0].texture;
            texture            = taken_from_half(texture);
        }
        return fractal;
    }

    // The sums, times the alpha that the colour pass left: one where it has drawn, else zero.
    Pass where_drawn(const Pass& pass) const {
        Pass keep          = rectangle_pass(pass, "where it is drawn", kByAlpha, {0xffffffff});
        const Target& from = *find_target(frame_, pass.color);
        auto& rectangle    = std::get<DrawRectangle>(keep.draws.front());
        rectangle.uv[0]    = {
               rectangle.x0 / static_cast<float>(from.width), rectangle.y0 / static_cast<float>(from.height),
               rectangle.x1 / static_cast<float>(from.width), rectangle.y1 / static_cast<float>(from.height)};
        TextureStage& stage = keep.state.stages[0];
        stage.color_op = stage.alpha_op = TextureOp::SelectArg1;
        stage.address_u = stage.address_v = TextureAddress::Clamp;
        rectangle.textures[0].target      = pass.color;
        return keep;
    }

    void make_sums_target(TargetId source) {
        if (sums_) return;
        sums_         = {static_cast<std::int32_t>(frame_.targets.size())};
        Target target = *find_target(frame_, source);
        target.name   = "sums of alpha";
        frame_.targets.push_back(target);
    }

    TextureId taken_from_half(TextureId id) {
        const auto [found, is_new] = from_half_.insert({id.index, {}});
        if (!is_new) return found->second;
        found->second   = {static_cast<std::int32_t>(frame_.textures.size())};
        Texture texture = frame_.textures[static_cast<std::size_t>(id.index)];
        texture.name += ", from one half";
        texture.format = TextureFormat::L8;
        for (std::uint8_t& texel : texture.texels) texel = kHalf - texel;
        frame_.textures.push_back(std::move(texture));
        return found->second;
    }

    Frame& frame_;
    TargetId sums_;
    std::map<std::int32_t, TextureId> from_half_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> second_;
};

}  // namespace

Frame rewrite_second_alpha(Frame frame, const Profile& profile, RewriteNotes& notes) {
    if (profile.states.stages != 1 || profile.arithmetic.combine != CombineRule::GsShift7) return frame;
    Rewriter rewriter(frame);
    std::vector<Pass> passes;
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        std::vector<Pass> parts = rewriter.split(i);
        if (parts.empty()) {
            passes.push_back(frame.passes[i]);
            continue;
        }
        notes.push_back({"second_alpha", place_of(frame, i), "the chip has 1 stage and no sums or products of alpha",
                         std::to_string(parts.size()) + " passes, the alpha by the target's"});
        std::move(parts.begin(), parts.end(), std::back_inserter(passes));
    }
    frame.passes = std::move(passes);
    return frame;
}

}  // namespace pipeline
