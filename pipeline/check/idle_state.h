// SPDX-License-Identifier: MIT
// Which of a frame's states matter to its picture. One matters in a pass unless no value of it could change what the pass
// draws: stages after the chain's end, filters of a stage that reads no texture, lighting of rectangles do not. Where only
// numbers or what else is drawn would tell, it counts as one that matters.
#pragma once

#include <string_view>
#include <vector>

#include "pipeline/frame/frame.h"

namespace pipeline {

// The state of a pass of the frame, what does not matter in it taken from `other`.
PipelineState with_idle_state_of(const Frame& frame, const Pass& pass, const PipelineState& other);
// The frame's arithmetic, likewise.
Arithmetic with_idle_rules_of(const Frame& frame, const Arithmetic& other);

// May what the pass draws change its colour target?
bool writes_color(const Frame& frame, const Pass& pass);

// The fields of Vertex that the pass's triangles in object space are made of, in their order.
std::vector<std::string_view> vertex_attributes(const Frame& frame, const Pass& pass);

}  // namespace pipeline
