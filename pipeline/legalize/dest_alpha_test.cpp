// SPDX-License-Identifier: MIT
#include "pipeline/legalize/dest_alpha_test.h"

#include <algorithm>
#include <iterator>

#include "pipeline/check/target_use.h"
#include "pipeline/legalize/drawn_alpha.h"
#include "pipeline/legalize/window_map.h"

namespace pipeline {

namespace {

constexpr ColorMask kAlphaAlone{.red = false, .green = false, .blue = false, .alpha = true};
constexpr ColorMask kColorAlone{.red = true, .green = true, .blue = true, .alpha = false};

bool contains(const PixelRect& outer, const PixelRect& inner) {
    return outer.x0 <= inner.x0 && outer.y0 <= inner.y0 && outer.x1 >= inner.x1 && outer.y1 >= inner.y1;
}

// What viewport and scissor leave, maybe nothing.
PixelRect limit_of(const Frame& frame, const Pass& pass) {
    const PixelRect viewport = viewport_of(frame, pass), &scissor = pass.state.scissor;
    if (scissor == PixelRect{}) return viewport;
    return {std::max(viewport.x0, scissor.x0), std::max(viewport.y0, scissor.y0), std::min(viewport.x1, scissor.x1),
            std::min(viewport.y1, scissor.y1)};
}

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

bool covers(const Frame& frame, const Pass& pass, const PixelRect& area) {
    if (!is_one_rectangle(pass) || uses_depth(pass) || !contains(limit_of(frame, pass), area)) return false;
    const auto& draw = std::get<DrawRectangle>(pass.draws[0]);
    return draw.x0 <= static_cast<float>(area.x0) && draw.y0 <= static_cast<float>(area.y0) &&
           draw.x1 >= static_cast<float>(area.x1) && draw.y1 >= static_cast<float>(area.y1);
}

bool changes_depth(const Pass& pass) {
    return pass.depth && (pass.clear.depth || (draws(pass) && pass.state.depth.write));
}

// The passes that left alpha 0 or 255 in all of the area, in order; none if that is not known.
std::vector<Pass> alpha_masks(const Frame& frame, std::size_t layer) {
    const TargetId target = frame.passes[layer].color;
    const PixelRect area  = limit_of(frame, frame.passes[layer]);
    std::vector<TargetId> changed_depths;
    std::vector<Pass> masks;
    for (std::size_t i = layer; i-- > 0;) {
        const Pass& pass = frame.passes[i];
        if (pass.color == target) {
            const bool is_stale = std::ranges::count(changed_depths, pass.depth) != 0 && uses_depth(pass);
            if (!is_alpha_mask(frame, pass) || is_stale) return {};
            masks.insert(masks.begin(), pass);
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

}  // namespace

Frame test_by_blending(Frame frame, const Profile& profile, RewriteNotes& notes) {
    if (profile.states.dest_alpha_test || frame.arithmetic.blend != BlendRule::Nearest255) return frame;
    std::vector<Pass> passes;
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        const Pass& pass = frame.passes[i];
        std::vector<Pass> masks;
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
        std::ranges::move(masks, std::back_inserter(passes));
    }
    frame.passes = std::move(passes);
    return frame;
}

}  // namespace pipeline
