// SPDX-License-Identifier: MIT
#include "pipeline/legalize/dest_alpha_test.h"

#include <algorithm>
#include <iterator>

#include "pipeline/check/target_use.h"
#include "pipeline/legalize/alpha_use.h"
#include "pipeline/legalize/drawn_alpha.h"
#include "pipeline/legalize/window_map.h"

namespace pipeline {

namespace {

constexpr ColorMask kAlphaAlone{.red = false, .green = false, .blue = false, .alpha = true};
constexpr ColorMask kColorAlone{.red = true, .green = true, .blue = true, .alpha = false};

bool is_one_rectangle(const Pass& pass) {
    return pass.draws.size() == 1 && std::holds_alternative<DrawRectangle>(pass.draws[0]);
}

// A layer over what passes the test.
bool is_tested_layer(const Pass& pass) {
    const PipelineState& state = pass.state;
    return state.dest_alpha_test == DestAlphaTest::One && state.blend == kAlphaOver &&
           state.color_mask == kColorAlone && is_one_rectangle(pass) && pass.clear == Clear{} && !state.depth.write;
}

// Writes 0 or 255 to alpha alone, and the same again if it is drawn again.
bool is_alpha_mask(const Frame& frame, const Pass& pass) {
    const PipelineState& state = pass.state;
    const DrawnAlpha drawn(frame, pass);
    return state.color_mask == kAlphaAlone && state.blend == kReplace && (drawn.is(0) || drawn.is(255)) &&
           pass.clear == Clear{} && !state.depth.write && state.dest_alpha_test == DestAlphaTest::Off &&
           state.alpha_test == AlphaTestState{};
}

bool changes_depth(const Pass& pass) {
    return pass.depth && (pass.clear.depth || (draws(pass) && pass.state.depth.write));
}

// The passes that left alpha 0 or 255 in all of the area, by number and in order; none if that is not known.
std::vector<std::size_t> alpha_masks(const Frame& frame, std::size_t layer) {
    const TargetId target = frame.passes[layer].color;
    const PixelRect area  = limit_of(frame, frame.passes[layer]);
    std::vector<TargetId> changed_depths;
    std::vector<std::size_t> masks;
    for (std::size_t i = layer; i-- > 0;) {
        const Pass& pass = frame.passes[i];
        if (pass.color == target) {
            const bool is_stale = std::ranges::count(changed_depths, pass.depth) != 0 && uses_depth(pass);
            if (!is_alpha_mask(frame, pass) || is_stale) return {};
            masks.insert(masks.begin(), i);
            if (covers(frame, pass, area)) return masks;
        }
        if (changes_depth(pass)) changed_depths.push_back(pass.depth);
    }
    return {};
}

Pass with_blend(const Pass& layer, const BlendState& blend, const ColorMask& mask) {
    Pass pass                  = layer;
    pass.state.dest_alpha_test = DestAlphaTest::Off;
    pass.state.blend           = blend;
    pass.state.color_mask      = mask;
    return pass;
}

// The layers over one target whose test its masks can decide, and these.
struct TestedLayers {
    std::vector<std::size_t> layers, masks;
};
TestedLayers tested_layers(const Frame& frame, TargetId target) {
    TestedLayers found;
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        const Pass& pass = frame.passes[i];
        if (pass.color != target || !is_tested_layer(pass) || stage_count(pass.state) >= kTextureStages) continue;
        const std::vector<std::size_t> masks = alpha_masks(frame, i);
        if (!masks.empty()) found.layers.push_back(i);
        found.masks.insert(found.masks.end(), masks.begin(), masks.end());
    }
    std::ranges::sort(found.masks);
    found.masks.erase(std::unique(found.masks.begin(), found.masks.end()), found.masks.end());
    return found;
}

// Does anything but these layers read the target's alpha?
bool is_alpha_read_beside(const Frame& frame, TargetId target, const std::vector<std::size_t>& layers) {
    Frame others;
    others.targets = frame.targets;
    others.passes  = frame.passes;
    for (const std::size_t layer : layers) others.passes[layer].state.dest_alpha_test = DestAlphaTest::Off;
    return is_alpha_read(others, target);
}

// Another stage multiplies the layer's alpha by the mask's, which is the second argument: so TEV keeps it to the bit.
void multiply_by_mask(Pass& layer, TargetId mask, const Target& size) {
    const auto stage            = static_cast<std::size_t>(stage_count(layer.state));
    layer.state.dest_alpha_test = DestAlphaTest::Off;
    layer.state.stages[stage]   = {.color_op   = TextureOp::SelectArg1,
                                   .color_arg1 = {.source = ArgSource::Current},
                                   .alpha_op   = TextureOp::Modulate,
                                   .alpha_arg1 = {.source = ArgSource::Current},
                                   .alpha_arg2 = {.source = ArgSource::Texture},
                                   .address_u  = TextureAddress::Clamp,
                                   .address_v  = TextureAddress::Clamp};
    auto& draw                  = std::get<DrawRectangle>(layer.draws[0]);
    const auto width = static_cast<float>(size.width), height = static_cast<float>(size.height);
    draw.textures[stage] = {.texture = {}, .target = mask};
    draw.uv[stage]       = {draw.x0 / width, draw.y0 / height, draw.x1 / width, draw.y1 / height};
}

}  // namespace

bool is_tested_alpha_known(const Frame& frame, std::size_t pass) {
    return !alpha_masks(frame, pass).empty();
}

Frame test_by_texture(Frame frame, const Profile& profile, RewriteNotes& notes) {
    const bool has_bits = profile.states.dest_alpha_test || keeps_bytes(profile.formats.with_alpha);
    if (has_bits || profile.states.stages < kTextureStages) return frame;
    const std::size_t targets = frame.targets.size();
    for (std::size_t i = 0; i < targets; ++i) {
        const TargetId target{static_cast<std::int32_t>(i)};
        const TestedLayers found = tested_layers(frame, target);
        if (found.layers.empty() || is_alpha_read_beside(frame, target, found.layers)) continue;
        const TargetId mask{static_cast<std::int32_t>(frame.targets.size())};
        Target made = frame.targets[i];
        made.name += ", mask";
        frame.targets.push_back(made);
        for (const std::size_t pass : found.masks) {
            frame.passes[pass].color            = mask;
            frame.passes[pass].state.color_mask = {};
        }
        for (const std::size_t layer : found.layers) {
            multiply_by_mask(frame.passes[layer], mask, made);
            notes.push_back({"dest_alpha_test", place_of(frame, layer), "the chip has no test of destination alpha",
                             "what is tested is drawn to '" + made.name + "', a factor of the layer's alpha"});
        }
    }
    return frame;
}

Frame test_by_blending(Frame frame, const Profile& profile, RewriteNotes& notes) {
    if (profile.states.dest_alpha_test || frame.arithmetic.blend != BlendRule::Nearest255) return frame;
    std::vector<Pass> passes;
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        const Pass& pass = frame.passes[i];
        std::vector<std::size_t> masks;
        if (is_tested_layer(pass) &&
            frame.targets[static_cast<std::size_t>(pass.color.index)].format == TargetFormat::A8R8G8B8)
            masks = alpha_masks(frame, i);
        if (masks.empty()) {
            passes.push_back(pass);
            continue;
        }
        passes.push_back(with_blend(pass, {BlendFactor::Zero, BlendFactor::SourceAlpha}, kAlphaAlone));
        passes.push_back(with_blend(pass, {BlendFactor::DestAlpha, BlendFactor::InvDestAlpha}, {}));
        notes.push_back({"dest_alpha_test", place_of(frame, i), "the chip has no test of destination alpha",
                         "alpha there is multiplied by the layer's, blends the layer, and is written again by " +
                             std::to_string(masks.size()) + (masks.size() == 1 ? " pass" : " passes")});
        for (const std::size_t mask : masks) passes.push_back(frame.passes[mask]);
    }
    frame.passes = std::move(passes);
    return frame;
}

}  // namespace pipeline
