// SPDX-License-Identifier: MIT
// A frame drawn by both executors in step: after each pass the two pictures of its colour target are compared and the
// peer is given ours, so that each pass starts from equal colours and answers for its own differences alone. Depth is
// left to each.
// A frame is compared as a whole, or, which asks for far less lenience, in two halves that meet at the triangles which
// the vertex stage makes.
#pragma once

#include <string>
#include <vector>

#include "pipeline/frame/frame.h"
#include "tests/peers/compare.h"

namespace peers {

enum class Part {
    Whole,
    // From the vertex stage's triangles to the picture: OpenGL is given those on our grid (gl_window.h), and no edge
    // or surface may differ.
    Raster,
    // From the frame to the triangles: both pictures are OpenGL's, of the vertex stage's triangles and of the frame's.
    // Our grid and how we interpolate are no part of it.
    Vertices,
};

struct PassComparison {
    std::string label;
    Comparison comparison;
    int most_allowed = 0;  // units, at any pixel; 0 if no pixel differs
};

// Valid frames that OpenGL can express, in a current GlContext. `peers` is what the peer draws: the same frame, but
// in tests that a mistake is found; passes, targets and bindings are those of `frame`.
std::vector<PassComparison> compare_passes(const pipeline::Frame& frame, const pipeline::Frame& peers,
                                           Part part = Part::Whole);

Comparison total(const std::vector<PassComparison>& passes);

}  // namespace peers
