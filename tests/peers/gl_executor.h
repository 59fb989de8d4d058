// SPDX-License-Identifier: MIT
// The second executor of frames: OpenGL 1.x fixed function, which shares nothing with pipeline/execute but the frame.
// It computes in fractions where the frame's ideal arithmetic rounds to bytes, has 8 subpixel bits where that has 4,
// and interpolates colours in perspective where that is linear on the screen; otherwise the two pictures are the
// same. What the API has no state for is named, not imitated.
#pragma once

#include <optional>

#include "pipeline/execute/execute.h"
#include "pipeline/frame/frame.h"
#include "tests/peers/gl_memory.h"
#include "tests/peers/gl_window.h"

namespace peers {

// Draws a frame pass by pass, in a current GlContext. The frame is valid, can be expressed, and outlives this.
class GlExecutor {
  public:
    // What OpenGL is given of triangles: all of them, or those that are left of the vertex stage (gl_window.h).
    explicit GlExecutor(const pipeline::Frame& frame, std::optional<WindowTriangles> given = std::nullopt);

    void draw_pass(std::size_t index);
    pipeline::ColorImage read(pipeline::TargetId color) { return memory_.read(color); }
    void write(pipeline::TargetId color, const pipeline::ColorImage& picture) { memory_.write(color, picture); }

  private:
    const pipeline::Frame& frame_;
    std::optional<WindowTriangles> given_;
    GlMemory memory_;
};

}  // namespace peers
