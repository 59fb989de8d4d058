// SPDX-License-Identifier: MIT
#include "pipeline/check/target_use.h"

#include <algorithm>

namespace pipeline {

namespace {

std::size_t index_of(TargetId id) {
    return static_cast<std::size_t>(id.index);
}

// Does viewport or scissor keep a clear from a part of the target?
bool is_limited(const PixelRect& limit, const Target& target) {
    return limit != PixelRect{} && limit != PixelRect{0, 0, target.width, target.height};
}
bool clears_all(const Frame& frame, const Pass& pass, TargetId id) {
    const Target& target = frame.targets[index_of(id)];
    const bool clears    = (id == pass.color && pass.clear.color) || (id == pass.depth && pass.clear.depth);
    return clears && !is_limited(pass.state.viewport, target) && !is_limited(pass.state.scissor, target);
}

// Calls body(target) for what a pass draws to, reads or copies, maybe more than once.
template <class Body>
void for_each_target(const Frame& frame, const Pass& pass, Body&& body) {
    const auto visit = [&](TargetId id) {
        if (find_target(frame, id) != nullptr) body(id);
    };
    if (pass.clear.color || !pass.draws.empty()) visit(pass.color);
    if (pass.clear.depth || uses_depth(pass)) visit(pass.depth);
    for_each_texture(pass, [&](std::size_t, std::size_t, const TextureBinding& binding) { visit(binding.target); });
    for (const Draw& draw : pass.draws)
        if (const auto* copy = std::get_if<CopyRectangle>(&draw)) visit(copy->source);
}

}  // namespace

bool draws(const Pass& pass) {
    return !std::all_of(pass.draws.begin(), pass.draws.end(), &is_copy);
}

bool draws_triangles(const Pass& pass) {
    return std::any_of(pass.draws.begin(), pass.draws.end(),
                       [](const Draw& draw) { return std::holds_alternative<DrawTriangles>(draw); });
}

bool uses_depth(const Pass& pass) {
    const DepthState& depth = pass.state.depth;
    return pass.depth && draws(pass) && (depth.func != CompareFunc::Always || depth.write);
}

std::vector<TargetUse> target_uses(const Frame& frame) {
    std::vector<TargetUse> uses(frame.targets.size());
    const auto mark = [&](TargetId id, bool TargetUse::*use) {
        if (find_target(frame, id) != nullptr) uses[index_of(id)].*use = true;
    };
    for (const Pass& pass : frame.passes) {
        if (pass.clear.color || draws(pass)) mark(pass.color, &TargetUse::drawn);
        if (pass.clear.depth || uses_depth(pass)) mark(pass.depth, &TargetUse::drawn);
        if (std::any_of(pass.draws.begin(), pass.draws.end(), &is_copy)) mark(pass.color, &TargetUse::copied_to);
        for_each_texture(pass, [&](std::size_t, std::size_t, const TextureBinding& binding) {
            mark(binding.target, &TargetUse::read);
        });
    }
    return uses;
}

std::vector<std::vector<PassRange>> live_ranges(const Frame& frame) {
    std::vector<std::vector<PassRange>> live(frame.targets.size());
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        const Pass& pass = frame.passes[i];
        for_each_target(frame, pass, [&](TargetId id) {
            std::vector<PassRange>& ranges = live[index_of(id)];
            const bool is_new = ranges.empty() || (clears_all(frame, pass, id) && ranges.back().first != i);
            if (is_new) ranges.push_back({i, i});
            ranges.back().last = i;
        });
    }
    if (find_target(frame, frame.output) != nullptr) {
        std::vector<PassRange>& ranges = live[index_of(frame.output)];
        if (ranges.empty()) ranges.push_back({0, 0});
        ranges.back().last = frame.passes.size();
    }
    return live;
}

}  // namespace pipeline
