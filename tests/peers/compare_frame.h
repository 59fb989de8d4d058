// SPDX-License-Identifier: MIT
// A frame drawn by both executors in step: after each pass the two pictures of its colour target are compared and the
// peer is given ours, so that each pass starts from equal colours and answers for its own differences alone. Depth is
// left to each.
#pragma once

#include <string>
#include <vector>

#include "pipeline/frame/frame.h"
#include "tests/peers/compare.h"

namespace peers {

struct PassComparison {
    std::string label;
    Comparison comparison;
    int most_allowed = 0;  // units, at any pixel; 0 if no pixel differs
};

// Valid frames that OpenGL can express, in a current GlContext. `peers` is what the peer draws: the same frame, but
// in tests that a mistake is found; passes, targets and bindings are those of `frame`.
std::vector<PassComparison> compare_passes(const pipeline::Frame& frame, const pipeline::Frame& peers);

Comparison total(const std::vector<PassComparison>& passes);

}  // namespace peers
