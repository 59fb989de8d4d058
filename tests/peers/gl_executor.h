// SPDX-License-Identifier: MIT
// The second executor of frames: OpenGL 1.x fixed function, which shares nothing with pipeline/execute but the frame.
// It computes in fractions where the frame's ideal arithmetic rounds to bytes, has 8 subpixel bits where that has 4,
// and interpolates colours in perspective where that is linear on the screen; otherwise the two pictures are the
// same. What the API has no state for is named, not imitated.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/execute/execute.h"
#include "pipeline/frame/frame.h"
#include "tests/peers/gl_memory.h"

namespace peers {

// Draws a frame pass by pass, in a current GlContext. The frame is valid, can be expressed, and outlives this.
class GlExecutor {
  public:
    explicit GlExecutor(const pipeline::Frame& frame);

    void draw_pass(std::size_t index);
    pipeline::ColorImage read(pipeline::TargetId color) { return memory_.read(color); }
    void write(pipeline::TargetId color, const pipeline::ColorImage& picture) { memory_.write(color, picture); }

  private:
    const pipeline::Frame& frame_;
    GlMemory memory_;
};

struct Drawn {
    pipeline::ColorImage output;               // Frame::output
    std::vector<pipeline::ColorImage> passes;  // each pass's colour target after it, where there is one; if asked for
};
Drawn draw_with_gl(const pipeline::Frame& frame, bool keeps_passes = false);

}  // namespace peers
