// SPDX-License-Identifier: MIT
// The rules for one pass that go beyond single values (check_values.h): targets, state, draws. Ids out of range, and
// sizes of targets and textures, are reported elsewhere; rules that depend on them are then left out.
#pragma once

#include "pipeline/validate/findings.h"

namespace pipeline {

// The target, or null if the id refers to nothing or is out of range.
const Target* find_target(const Frame& frame, TargetId id);
const Texture* find_texture(const Frame& frame, TextureId id);

bool is_power_of_two(std::int32_t size);

void check_pass_state(const Frame& frame, const Pass& pass, const Place& place, Findings& findings);
void check_draws(const Frame& frame, const Pass& pass, const Place& place, Findings& findings);

// Does stage number `index` of the chain read TEXTURE, in an argument that its ops use?
bool reads_texture(const PipelineState& state, int index);

}  // namespace pipeline
