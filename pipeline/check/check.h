// SPDX-License-Identifier: MIT
// May a chip draw a frame as it is? Everything that it lacks is a finding, not only the first; a frame without one needs
// nothing but its registers written. What has no effect, as a scissor that holds the viewport, is not asked of the chip.
// The frame is valid (pipeline/validate).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/profile/profile.h"

namespace pipeline {

// where: "pass 3 'composite': state.color_mask", as in pipeline/validate. rule: the topic in Profile::evidence that says
// what the chip has, and from what source (find_evidence); of `ideal`, which has no chip to be known, "limits" and
// "memory" are never found. uses: what stands in the frame, as its text spells it. has: what the chip has for it,
// "none" if that is nothing.
struct ChipFinding {
    std::string where;
    std::string_view rule;
    std::string uses, has;
    bool operator==(const ChipFinding&) const = default;
};

// In the order of the frame's text: arithmetic, targets, textures, passes, and then memory (memory_map.h).
std::vector<ChipFinding> check(const Frame& frame, const Profile& profile);

}  // namespace pipeline
