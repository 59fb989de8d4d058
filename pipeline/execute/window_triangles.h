// SPDX-License-Identifier: MIT
// What the vertex stage makes of a draw, as window vertices: what a program computes for a chip that has no such stage.
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/frame/frame.h"

namespace pipeline {

// indices: three for each triangle that is drawn, into `vertices`. Drawn as window triangles they give the pixels of the
// draw, if the guard band is the executor's (pipeline/execute/window.h).
struct WindowMesh {
    std::vector<WindowVertex> vertices;
    std::vector<std::uint32_t> indices;
};

// The frame is valid. viewport: not empty. guard_band: pixels around it, up to which triangles are not cut; greater than 0.
WindowMesh to_window_triangles(const Frame& frame, const Pass& pass, const DrawTriangles& draw,
                               const PixelRect& viewport, float guard_band);

}  // namespace pipeline
