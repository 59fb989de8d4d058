// SPDX-License-Identifier: MIT
// Random triangles in window space: small and huge, slivers, patches that share edges, up to the limits of the coordinates,
// some without area.
#pragma once

#include "pipeline/frame/frame.h"
#include "tests/support/random.h"

namespace test_support {

// Over a target of width x height pixels. Appends to the frame's window vertices and indices; the draw has no textures.
pipeline::DrawWindowTriangles append_window_triangles(pipeline::Frame& frame, int width, int height, Random& random);

}  // namespace test_support
