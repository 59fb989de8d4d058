// SPDX-License-Identifier: MIT
// Random cameras, and triangles before them: small and huge, slivers, patches that share edges, some cut by the near
// plane or behind it, some without area.
#pragma once

#include "pipeline/frame/frame.h"
#include "tests/support/random.h"

namespace test_support {

pipeline::Camera random_camera(Random& random);

// Appends to the frame's vertices and indices; the draw has no textures and the identity as world.
pipeline::DrawTriangles append_triangles(pipeline::Frame& frame, const pipeline::Camera& camera, Random& random);

}  // namespace test_support
