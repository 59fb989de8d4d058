// SPDX-License-Identifier: MIT
// What the passes of a frame do with its targets.
#pragma once

#include <vector>

#include "pipeline/frame/frame.h"
#include "pipeline/validate/check_pass.h"

namespace pipeline {

inline bool is_copy(const Draw& draw) {
    return std::holds_alternative<CopyRectangle>(draw);
}

// Does a pass draw triangles or rectangles, so that its state matters?
bool draws(const Pass& pass);
bool draws_triangles(const Pass& pass);

// Does what a pass draws meet its depth target?
bool uses_depth(const Pass& pass);

// Calls body(draw, stage, binding) for each texture or target that a draw binds to a stage that reads it.
template <class Body>
void for_each_texture(const Pass& pass, Body&& body) {
    for (std::size_t draw = 0; draw < pass.draws.size(); ++draw) {
        const TextureBindings textures = textures_of(pass.draws[draw]);
        for (std::size_t stage = 0; stage < textures.size(); ++stage) {
            const TextureBinding& binding = textures[stage];
            if ((binding.texture || binding.target) && reads_texture(pass.state, static_cast<int>(stage)))
                body(draw, stage, binding);
        }
    }
}

// drawn: also cleared; of depth targets, cleared or met by draws. read: as a texture.
struct TargetUse {
    bool drawn = false, copied_to = false, read = false;
};
std::vector<TargetUse> target_uses(const Frame& frame);

}  // namespace pipeline
