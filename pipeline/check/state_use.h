// SPDX-License-Identifier: MIT
// Which values the states of a frame have, and how often, where they matter (idle_state.h).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/frame/frame.h"

namespace pipeline {

// A field that has one of a few values: an enumerator's names, or "false" and "true". path: as in the frame's text, without
// places in lists: "state.stages.color_op", "arithmetic.filter", "targets.format", "draws.copy.halve".
struct StateField {
    std::string path;
    std::vector<std::string_view> values;
    std::size_t default_value = 0;
};
// All there are of a frame.
const std::vector<StateField>& state_fields();

// [field of state_fields()][value]: in how many places the frame has it where it matters; of targets, textures and draws, in
// how many of those that are used.
using StateUses = std::vector<std::vector<std::size_t>>;
void add_state_uses(const Frame& frame, StateUses& uses);

// Which targets its passes draw to, clear, copy or read; a depth target only if it is cleared, tested or written.
std::vector<bool> targets_in_use(const Frame& frame);
// Which textures they read.
std::vector<bool> textures_in_use(const Frame& frame);

}  // namespace pipeline
