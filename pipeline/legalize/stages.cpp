// SPDX-License-Identifier: MIT
#include "pipeline/legalize/stages.h"

#include <map>
#include <tuple>

#include "pipeline/check/chip_findings.h"
#include "pipeline/check/target_use.h"
#include "pipeline/legalize/vertex_changes.h"

namespace pipeline {

namespace {

bool is_plain(const TextureArg& arg, ArgSource source) {
    return arg == TextureArg{.source = source};
}

bool multiplies_current(const TextureStage& stage) {
    const bool multiplies = stage.color_op == TextureOp::Modulate || stage.color_op == TextureOp::Modulate2X;
    const auto are        = [&](const TextureArg& one, const TextureArg& other) {
        return is_plain(one, ArgSource::Texture) && is_plain(other, ArgSource::Current);
    };
    const bool keeps_alpha =
        (stage.alpha_op == TextureOp::SelectArg1 && is_plain(stage.alpha_arg1, ArgSource::Current)) ||
        (stage.alpha_op == TextureOp::SelectArg2 && is_plain(stage.alpha_arg2, ArgSource::Current));
    return multiplies && keeps_alpha &&
           (are(stage.color_arg1, stage.color_arg2) || are(stage.color_arg2, stage.color_arg1));
}

bool is_twice(const PipelineState& state) {
    return state.stages[1].color_op == TextureOp::Modulate2X;
}

// With it, a later pass finds what an earlier one left; nothing if there is none.
std::optional<CompareFunc> func_with_equal(CompareFunc func) {
    switch (func) {
        case CompareFunc::Less:
        case CompareFunc::LessEqual:
            return CompareFunc::LessEqual;
        case CompareFunc::Greater:
        case CompareFunc::GreaterEqual:
            return CompareFunc::GreaterEqual;
        default:
            return {};
    }
}

bool can_split(const Frame& frame, const Pass& pass) {
    const PipelineState& state = pass.state;
    const Target* target       = find_target(frame, pass.color);
    return draws(pass) && target != nullptr && keeps_bytes(target->format) && pass.depth && stage_count(state) == 2 &&
           multiplies_current(state.stages[1]) && state.blend == kReplace && state.gs_blend == GsBlend{} &&
           state.depth.write && func_with_equal(state.depth.func) && state.alpha_test.func == CompareFunc::Always &&
           state.dest_alpha_test == DestAlphaTest::Off && !state.lighting.specular_enable;
}

// The same pixels once more, with nothing but depth compared and no alpha written.
Pass later_pass(const Pass& pass, std::string_view what, const BlendState& blend) {
    Pass later                   = pass;
    later.label                  = pass.label + ": " + std::string(what);
    later.clear                  = {};
    later.state.blend            = blend;
    later.state.depth            = {.func = *func_with_equal(pass.state.depth.func), .write = false};
    later.state.color_mask.alpha = false;
    later.state.fog              = {};
    later.state.stages           = {};
    later.state.lighting         = {};
    for (Draw& draw : later.draws)
        if (TextureBindings* bindings = bindings_of(draw)) *bindings = {};
    return later;
}

bool has_fog(const PipelineState& state) {
    return state.fog.mode != FogMode::None;
}

void fade_to_black(PipelineState& state, FogState fog) {
    state.fog             = fog;
    state.fog.color.value = fog.color.value & 0xff000000;
}

// What twice a product is cut at, it is cut at before it fades.
bool fades_first(const PipelineState& state) {
    return has_fog(state) && !is_twice(state);
}

Pass first_pass(Pass pass) {
    if (fades_first(pass.state))
        fade_to_black(pass.state, pass.state.fog);
    else
        pass.state.fog = {};
    pass.state.stages[1] = {};
    for (Draw& draw : pass.draws)
        if (TextureBindings* bindings = bindings_of(draw)) (*bindings)[1] = {};
    return pass;
}

// The second stage's texture as it is.
Pass texture_pass(const Pass& pass, std::string_view what, const BlendState& blend) {
    Pass later          = later_pass(pass, what, blend);
    TextureStage& stage = later.state.stages[0];
    stage               = pass.state.stages[1];
    stage.color_op      = TextureOp::SelectArg1;
    stage.color_arg1    = {.source = ArgSource::Texture};
    stage.color_arg2    = {};
    stage.alpha_op      = TextureOp::SelectArg1;
    stage.alpha_arg1    = {.source = ArgSource::Texture};
    stage.alpha_arg2    = {};
    for (std::size_t i = 0; i < later.draws.size(); ++i) {
        (*bindings_of(later.draws[i]))[0] = textures_of(pass.draws[i])[1];
        if (auto* rectangle = std::get_if<DrawRectangle>(&later.draws[i])) rectangle->uv[0] = rectangle->uv[1];
    }
    return later;
}

Pass constant_pass(const Pass& pass, std::string_view what, const BlendState& blend, Argb color) {
    Pass later                 = later_pass(pass, what, blend);
    later.state.texture_factor = color;
    later.state.stages[0]      = {.color_op   = TextureOp::SelectArg1,
                                  .color_arg1 = {.source = ArgSource::TFactor},
                                  .alpha_op   = TextureOp::SelectArg1,
                                  .alpha_arg1 = {.source = ArgSource::TFactor}};
    return later;
}

constexpr std::array<std::string_view, 3> kChannelNames{"blue", "green", "red"};  // as in texels

std::uint8_t channel_of(const Texture& texture, std::size_t texel, std::size_t channel) {
    if (texture.format == TextureFormat::A8) return 0;
    return texture.format == TextureFormat::L8 ? texture.texels[texel] : texture.texels[4 * texel + channel];
}

bool is_grey(const Texture& texture) {
    const std::size_t texels = texture.texels.size() / static_cast<std::size_t>(bytes_per_texel(texture.format));
    for (std::size_t i = 0; i < texels; ++i)
        for (std::size_t channel = 1; channel < 3; ++channel)
            if (channel_of(texture, i, channel) != channel_of(texture, i, 0)) return false;
    return true;
}

// The passes of one frame, and textures that hold a channel of another as alpha.
class Splitter {
  public:
    Splitter(Frame& frame, const Profile& profile) : frame_(frame), profile_(profile) {}

    bool can_multiply(const Pass& pass) const {
        if (!is_gs())
            return is_among(BlendFactor::SourceColor, profile_.states.dest_factors) &&
                   (!is_twice(pass.state) || is_among(BlendFactor::DestColor, profile_.states.source_factors));
        const bool fades_later = has_fog(pass.state) && !fades_first(pass.state);
        return (!fades_later || is_in_window(pass)) &&
               std::none_of(pass.draws.begin(), pass.draws.end(),
                            [](const Draw& draw) { return bool(textures_of(draw)[1].target); });
    }

    std::vector<Pass> split(const Pass& pass) {
        std::vector<Pass> passes{first_pass(pass)};
        if (is_gs() && is_in_window(pass)) passes[0].state.fog = {};
        if (is_gs())
            multiply_by_alpha(pass, passes);
        else
            passes.push_back(second_texture_pass(
                pass, "second texture",
                {is_twice(pass.state) ? BlendFactor::DestColor : BlendFactor::Zero, BlendFactor::SourceColor}));
        if (has_fog(pass.state)) {
            if (is_gs() && is_in_window(pass))
                passes.push_back(fog_pass(pass));
            else
                add_fog(pass, passes);
        }
        return passes;
    }

  private:
    static constexpr BlendState kAdd{.source = BlendFactor::One, .dest = BlendFactor::One};
    static constexpr BlendState kByAlpha{.source = BlendFactor::Zero, .dest = BlendFactor::SourceAlpha};
    static constexpr BlendState kByOneMore{.source = BlendFactor::DestColor, .dest = BlendFactor::One};

    static bool is_in_window(const Pass& pass) {
        const auto draws = [&]<class Kind>(std::type_identity<Kind>) {
            return std::any_of(pass.draws.begin(), pass.draws.end(),
                               [](const Draw& draw) { return std::holds_alternative<Kind>(draw); });
        };
        return draws(std::type_identity<DrawWindowTriangles>{}) && !draws(std::type_identity<DrawTriangles>{});
    }

    bool is_gs() const { return profile_.arithmetic.blend == BlendRule::GsShift7; }

    // Its colour, as much as the vertices' factors leave: no rectangle has any.
    Pass fog_pass(const Pass& pass) {
        Pass later = later_pass(pass, "fog", kAlphaOver);
        std::erase_if(later.draws, [](const Draw& draw) { return std::holds_alternative<DrawRectangle>(draw); });
        const std::uint32_t color = pass.state.fog.color.value & 0x00ffffff;
        change_window_vertices(later, "fog" + text_of(pass.state.fog.color), [color](WindowVertex& vertex) {
            vertex.diffuse  = {color | (~vertex.specular.value & 0xff000000)};
            vertex.specular = {0xff000000};
        });
        return later;
    }

    // Draws of a pass get vertices of their own, changed; passes of one geometry and the same `what` share them.
    template <class Change>
    void change_window_vertices(Pass& pass, const std::string& what, Change change) {
        for (Draw& draw : pass.draws) {
            auto* triangles = std::get_if<DrawWindowTriangles>(&draw);
            if (triangles == nullptr) continue;
            const auto [found, is_new] = changed_.insert({{triangles->first_index, triangles->index_count, what}, 0});
            if (is_new) found->second = append_changed(frame_, *triangles, change);
            triangles->first_index = found->second;
        }
    }

    static void add_fog(const Pass& pass, std::vector<Pass>& passes) {
        if (!fades_first(pass.state))
            fade_to_black(passes.emplace_back(constant_pass(pass, "fade", kMultiply, {0xffffffff})).state,
                          pass.state.fog);
        passes.emplace_back(constant_pass(pass, "fog", kAdd, {0xff000000})).state.fog = pass.state.fog;
    }

    void multiply_by_alpha(const Pass& pass, std::vector<Pass>& passes) {
        const bool is_one = std::all_of(pass.draws.begin(), pass.draws.end(), [&](const Draw& draw) {
            const Texture* texture = find_texture(frame_, textures_of(draw)[1].texture);
            return texture == nullptr || is_grey(*texture);
        });
        if (is_one) passes.push_back(channel_pass(pass, "second texture", 0));
        for (std::size_t channel = 3; !is_one && channel-- > 0;) {
            Pass later = channel_pass(pass, "second texture, " + std::string(kChannelNames[channel]), channel);
            const ColorMask& mask  = pass.state.color_mask;
            later.state.color_mask = {.red   = mask.red && channel == 2,
                                      .green = mask.green && channel == 1,
                                      .blue  = mask.blue && channel == 0,
                                      .alpha = false};
            passes.push_back(std::move(later));
        }
        if (is_twice(pass.state)) passes.push_back(constant_pass(pass, "twice", kByOneMore, {0xffffffff}));
    }

    Pass second_texture_pass(const Pass& pass, std::string_view what, const BlendState& blend) {
        Pass later = texture_pass(pass, what, blend);
        change_window_vertices(later, "second", [](WindowVertex& vertex) { vertex.uv0 = vertex.uv1; });
        return later;
    }

    Pass channel_pass(const Pass& pass, std::string_view what, std::size_t channel) {
        Pass later = second_texture_pass(pass, what, kByAlpha);
        for (Draw& draw : later.draws) {
            TextureId& texture = (*bindings_of(draw))[0].texture;
            if (texture) texture = as_alpha(texture, channel);
        }
        return later;
    }

    TextureId as_alpha(TextureId id, std::size_t channel) {
        const auto [found, is_new] = channels_.insert({{id.index, channel}, {}});
        if (!is_new) return found->second;
        found->second         = {static_cast<std::int32_t>(frame_.textures.size())};
        const Texture& source = frame_.textures[static_cast<std::size_t>(id.index)];
        Texture alpha{.name   = source.name + ", " + std::string(kChannelNames[channel]),
                      .format = TextureFormat::A8,
                      .width  = source.width,
                      .height = source.height,
                      .levels = source.levels};
        alpha.texels.resize(source.texels.size() / static_cast<std::size_t>(bytes_per_texel(source.format)));
        for (std::size_t i = 0; i < alpha.texels.size(); ++i) alpha.texels[i] = channel_of(source, i, channel);
        frame_.textures.push_back(std::move(alpha));
        return found->second;
    }

    Frame& frame_;
    const Profile& profile_;
    std::map<std::pair<std::int32_t, std::size_t>, TextureId> channels_;
    std::map<std::tuple<std::uint32_t, std::uint32_t, std::string>, std::uint32_t> changed_;
};

}  // namespace

Frame rewrite_stages(Frame frame, const Profile& profile, RewriteNotes& notes) {
    if (profile.states.stages != 1) return frame;
    Splitter splitter(frame, profile);
    std::vector<Pass> passes;
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        const Pass& pass = frame.passes[i];
        if (!can_split(frame, pass) || !splitter.can_multiply(pass)) {
            passes.push_back(pass);
            continue;
        }
        std::vector<Pass> parts = splitter.split(pass);
        notes.push_back({"stages", Place("pass", i, pass.label).text(), "the chip has 1 stage, the pass 2",
                         std::to_string(parts.size()) + " passes"});
        std::move(parts.begin(), parts.end(), std::back_inserter(passes));
    }
    frame.passes = std::move(passes);
    return frame;
}

}  // namespace pipeline
