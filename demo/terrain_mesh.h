// SPDX-License-Identifier: MIT
// A height field as few triangles: fine where shape or light change, coarser with the distance from the middle.
#pragma once

#include <vector>

#include "demo/height_field.h"
#include "demo/right_triangles.h"

namespace demo {

// No triangle spans more grid cells than this, nor crosses a line between two blocks of so many: fog and light are
// linear across a triangle, and blocks are drawn or left out as a whole.
inline constexpr int kLongestEdge = 16;

// Triangles counter-clockwise seen from above. shade: brightness 0..1 at each grid point. height_tolerance_m holds
// within 100 m of the middle and grows with the distance.
TriangleMesh triangulate(const HeightField& field, const std::vector<float>& shade, float height_tolerance_m,
                         float shade_tolerance);

}  // namespace demo
