// SPDX-License-Identifier: MIT
#include "pipeline/legalize/copies.h"

#include <algorithm>
#include <iterator>

#include "pipeline/check/target_use.h"
#include "pipeline/legalize/window_map.h"

namespace pipeline {

namespace {

const Target& target_of(const Frame& frame, TargetId id) {
    return frame.targets[static_cast<std::size_t>(id.index)];
}

// What the chip lacks for it; empty if it can.
std::string what_is_lacking(const Frame& frame, const Pass& pass, const CopyRectangle& copy,
                            const ChipFormats& formats) {
    const TargetFormat from = target_of(frame, copy.source).format, to = target_of(frame, pass.color).format;
    if (copy.halve && !formats.copies_halve) return "the chip's copies halve nothing";
    if (!copy.halve && !formats.copies) return "the chip has no copies";
    if (from != to && !formats.copies_convert) return "the chip's copies stay within one format";
    return {};
}

TextureStage show_texel(TextureFilter filter) {
    return {.color_op  = TextureOp::SelectArg1,
            .alpha_op  = TextureOp::SelectArg1,
            .filter    = filter,
            .address_u = TextureAddress::Clamp,
            .address_v = TextureAddress::Clamp};
}

// The sample point of pixel x must meet texel coordinate from.x0 + step / 2, the middle of what becomes one pixel.
DrawRectangle whole_source(const Frame& frame, const CopyRectangle& copy) {
    const Target& source = target_of(frame, copy.source);
    const int step       = copy.halve ? 2 : 1;
    const float center   = static_cast<float>(frame.arithmetic.pixel_center - 8) / 16.0f;
    DrawRectangle draw;
    draw.x0                 = static_cast<float>(copy.x - copy.from.x0 / step) + center;
    draw.y0                 = static_cast<float>(copy.y - copy.from.y0 / step) + center;
    draw.x1                 = draw.x0 + static_cast<float>(source.width) / static_cast<float>(step);
    draw.y1                 = draw.y0 + static_cast<float>(source.height) / static_cast<float>(step);
    draw.textures[0].target = copy.source;
    return draw;
}

Pass drawn(const Frame& frame, const Pass& pass, const CopyRectangle& copy) {
    const int step = copy.halve ? 2 : 1;
    Pass result;
    result.label           = pass.label;
    result.color           = pass.color;
    result.state.stages[0] = show_texel(copy.halve ? TextureFilter::Linear : TextureFilter::Point);
    result.state.viewport  = {copy.x, copy.y, copy.x + (copy.from.x1 - copy.from.x0) / step,
                              copy.y + (copy.from.y1 - copy.from.y0) / step};
    result.draws           = {whole_source(frame, copy)};
    return result;
}

// The copies of one pass, in order: those that stay together as far as they go, each other one in a pass of its own; before
// them the clear, if there is one.
std::vector<Pass> split(const Frame& frame, const Pass& pass, const ChipFormats& formats) {
    Pass rest = pass;
    rest.draws.clear();
    std::vector<Pass> passes;
    if (pass.clear != Clear{}) passes.push_back(rest);
    rest.clear       = {};
    bool last_copies = !passes.empty();  // can the last of them take a copy that stays?
    for (const Draw& draw : pass.draws) {
        const auto& copy = std::get<CopyRectangle>(draw);
        const bool stays = what_is_lacking(frame, pass, copy, formats).empty();
        if (!stays) passes.push_back(drawn(frame, pass, copy));
        if (stays && !last_copies) passes.push_back(rest);
        if (stays) passes.back().draws.push_back(draw);
        last_copies = stays;
    }
    return passes;
}

// Of the pass; empty if the chip can copy all.
std::string first_lack(const Frame& frame, const Pass& pass, const ChipFormats& formats) {
    for (const Draw& draw : pass.draws) {
        const auto* copy = std::get_if<CopyRectangle>(&draw);
        if (copy == nullptr) continue;
        if (std::string why = what_is_lacking(frame, pass, *copy, formats); !why.empty()) return why;
    }
    return {};
}

}  // namespace

Frame draw_copies(Frame frame, const Profile& profile, RewriteNotes& notes) {
    std::vector<Pass> passes;
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        Pass& pass            = frame.passes[i];
        const std::string why = first_lack(frame, pass, profile.formats);
        if (why.empty()) {
            passes.push_back(std::move(pass));
            continue;
        }
        notes.push_back(
            {"copies", place_of(frame, i), why, "rectangles that show the source, limited by the viewport"});
        std::ranges::move(split(frame, pass, profile.formats), std::back_inserter(passes));
    }
    frame.passes = std::move(passes);
    return frame;
}

}  // namespace pipeline
