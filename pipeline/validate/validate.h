// SPDX-License-Identifier: MIT
// Is a frame well formed? Ids in range, sizes within limits, no feedback loops, finite numbers, states that mean
// something. `execute` relies on nothing else. Every finding is returned, not only the first.
#pragma once

#include <string>
#include <vector>

#include "pipeline/frame/frame.h"

namespace pipeline {

// where: "pass 3 'composite': state.scissor"; what: "must lie within the target (got ...)".
struct Finding {
    std::string where;
    std::string what;
    bool operator==(const Finding&) const = default;
};

std::vector<Finding> validate(const Frame& frame);

}  // namespace pipeline
