// SPDX-License-Identifier: MIT
// A height field as few triangles: right triangles, halved wherever the halves would differ in shape or light by more
// than the tolerance. An edge is split from both sides or from neither, so the mesh has no cracks and no T-junctions.
// Source: Evans, Kirkpatrick & Townsend, "Right-Triangulated Irregular Networks", Algorithmica 30, 2001.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "demo/height_field.h"

namespace demo {

// points: indices row * HeightField::kPoints + column of the grid points used. triangles: indices into points,
// counter-clockwise seen from above.
struct TerrainMesh {
    std::vector<std::uint32_t> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

// shade: brightness 0..1 at each grid point. height_tolerance_m holds within 100 m of the middle and grows with the
// distance.
TerrainMesh triangulate(const HeightField& field, const std::vector<float>& shade, float height_tolerance_m,
                        float shade_tolerance);

}  // namespace demo
