// SPDX-License-Identifier: MIT
// Whether the alpha that a target holds shows anywhere in a frame.
#pragma once

#include "pipeline/frame/frame.h"

namespace pipeline {

bool keeps_alpha(TargetFormat format);

// Does stage number `index` of the chain read its texture's alpha?
bool reads_texture_alpha(const PipelineState& state, std::size_t index);

// Is it read as a texture, by a blend or a test in the target, or copied to another? The picture's own alpha is not shown.
bool is_alpha_read(const Frame& frame, TargetId target);

// Is the alpha that a pass leaves in its colour target read later, before it is written anew where it is read?
bool is_alpha_needed(const Frame& frame, std::size_t pass);

}  // namespace pipeline
