// SPDX-License-Identifier: MIT
#include "pipeline/execute/schedule.h"

#include <algorithm>

namespace pipeline {
namespace {

bool reads(const Pass& pass, TargetId target) {
    return std::any_of(pass.draws.begin(), pass.draws.end(), [&](const Draw& draw) {
        const TextureBindings textures = textures_of(draw);
        return std::any_of(textures.begin(), textures.end(),
                           [&](const TextureBinding& binding) { return binding.target && binding.target == target; });
    });
}

bool fit(const Frame& frame, TargetId a, TargetId b) {
    if (!a || !b) return true;
    const Target &first  = frame.targets[static_cast<std::size_t>(a.index)],
                 &second = frame.targets[static_cast<std::size_t>(b.index)];
    return first.width == second.width && first.height == second.height;
}

bool joins(const Frame& frame, const Pass& pass, const PassGroup& group) {
    const auto is_same = [](TargetId a, TargetId b) { return !a || !b || a == b; };
    return !group.copies && !copies(pass) && is_same(pass.color, group.color) && is_same(pass.depth, group.depth) &&
           fit(frame, pass.color, group.depth) && fit(frame, pass.depth, group.color) &&
           !(group.color && reads(pass, group.color));
}

}  // namespace

bool copies(const Pass& pass) {
    return std::any_of(pass.draws.begin(), pass.draws.end(),
                       [](const Draw& draw) { return std::holds_alternative<CopyRectangle>(draw); });
}

std::vector<PassGroup> schedule_passes(const Frame& frame, bool one_by_one) {
    std::vector<PassGroup> groups;
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        const Pass& pass = frame.passes[i];
        if (one_by_one || groups.empty() || !joins(frame, pass, groups.back()))
            groups.push_back({.first = i, .end = i, .color = {}, .depth = {}, .copies = copies(pass)});
        PassGroup& group = groups.back();
        group.end        = i + 1;
        if (pass.color) group.color = pass.color;
        if (pass.depth) group.depth = pass.depth;
    }
    return groups;
}

std::string to_text(const std::vector<PassGroup>& groups) {
    std::string text;
    for (const PassGroup& group : groups) {
        text += std::to_string(group.first);
        if (group.end - group.first > 1) text.append("-").append(std::to_string(group.end - 1));
        text += group.copies ? ": copies to" : ":";
        if (group.color) text.append(" color ").append(std::to_string(group.color.index));
        if (group.depth) text.append(" depth ").append(std::to_string(group.depth.index));
        text += "\n";
    }
    return text;
}

}  // namespace pipeline
