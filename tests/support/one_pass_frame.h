// SPDX-License-Identifier: MIT
// The plainest frame: target 0 is the colour target and the output, target 1 the depth target if there is one, and one
// pass draws to both. Its camera takes positions as clip coordinates with w = 1.
#pragma once

#include <optional>

#include "pipeline/frame/frame.h"

namespace test_support {

inline pipeline::Frame one_pass_frame(int width, int height, std::optional<pipeline::TargetFormat> depth = {}) {
    pipeline::Frame frame;
    frame.output = {0};
    frame.targets.push_back({.name = "color", .width = width, .height = height});
    if (depth) frame.targets.push_back({.name = "depth", .format = *depth, .width = width, .height = height});
    frame.cameras.resize(1);
    pipeline::Pass& pass = frame.passes.emplace_back();
    pass.color           = {0};
    if (depth) pass.depth = {1};
    pass.camera = {0};
    return frame;
}

}  // namespace test_support
