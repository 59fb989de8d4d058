// SPDX-License-Identifier: MIT
// One pass of a frame as a frame of its own, which starts from given contents of the colour targets and draws what
// the pass draws in the whole frame. Contents are put back by blits, byte for byte; depth, which cannot be put back,
// is drawn again by the passes before it on the same depth target.
#pragma once

#include <memory>
#include <vector>

#include "pipeline/execute/execute.h"
#include "pipeline/frame/frame.h"

namespace peers {

// Moves all geometry, in pixels on the screen; the reference of the alpha test, in units of a byte; and what
// rectangles read of textures, in texels.
struct Nudge {
    float x = 0.0f, y = 0.0f;
    int alpha_reference = 0;
    float u = 0.0f, v = 0.0f;
};

// The contents of each target at one time; null for depth targets.
using TargetPictures = std::vector<std::shared_ptr<const pipeline::ColorImage>>;

// Of all targets before each pass, and after the last, as pipeline::execute draws them.
std::vector<TargetPictures> pictures_of(const pipeline::Frame& frame);

// before[i]: before pass i. The pass has a colour target, which is the output.
pipeline::Frame isolate_pass(const pipeline::Frame& frame, std::size_t index, const std::vector<TargetPictures>& before,
                             const Nudge& nudge = {});

// The same pass, but its picture counts how many fragments reach each pixel's blend: every channel holds the count,
// 255 for that or more. The alpha test is left out, so fragments that it rejects are counted too.
pipeline::Frame count_layers(const pipeline::Frame& frame, std::size_t index,
                             const std::vector<TargetPictures>& before);

// All passes, each after blits that put back what it draws to and reads; depth is left as the passes made it. places[i]: where
// pass i stands now.
struct SteppedFrame {
    pipeline::Frame frame;
    std::vector<std::size_t> places;
};
SteppedFrame step_by_step(const pipeline::Frame& frame, const std::vector<TargetPictures>& before);

}  // namespace peers
