// SPDX-License-Identifier: MIT
#include "pipeline/check/target_use.h"

#include <algorithm>

namespace pipeline {

namespace {

std::size_t index_of(TargetId id) {
    return static_cast<std::size_t>(id.index);
}

}  // namespace

bool draws(const Pass& pass) {
    return !std::all_of(pass.draws.begin(), pass.draws.end(), &is_copy);
}

bool draws_triangles(const Pass& pass) {
    return std::any_of(pass.draws.begin(), pass.draws.end(), [](const Draw& draw) {
        return std::holds_alternative<DrawTriangles>(draw) || std::holds_alternative<DrawWindowTriangles>(draw);
    });
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

}  // namespace pipeline
