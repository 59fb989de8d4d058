// SPDX-License-Identifier: MIT
#include "demo/terrain_mesh.h"

#include <algorithm>
#include <cmath>

namespace demo {

TriangleMesh triangulate(const HeightField& field, const std::vector<float>& shade, float height_tolerance_m,
                         float shade_tolerance) {
    constexpr int kCells    = HeightField::kCells;
    const auto shade_at     = [&](GridPoint p) { return shade[p.row * HeightField::kPoints + p.column]; };
    const auto height_at    = [&](GridPoint p) { return field.height(p.column, p.row); };
    const auto middle_error = [&](GridPoint a, GridPoint b, GridPoint m) {
        if (std::max(std::abs(a.column - b.column), std::abs(a.row - b.row)) > kLongestEdge) return 2.0f;
        const float bend    = std::abs(height_at(m) - 0.5f * (height_at(a) + height_at(b)));
        const float shading = std::abs(shade_at(m) - 0.5f * (shade_at(a) + shade_at(b)));
        // Whatever the distance is; true of most.
        if (bend <= height_tolerance_m && shading <= shade_tolerance) return 0.0f;
        const float x     = field.x_at(m.column) - field.x_at(kCells / 2);
        const float z     = field.z_at(m.row) - field.z_at(kCells / 2);
        const float far   = std::max(std::sqrt(x * x + z * z) / 100.0f, 1.0f);
        // A change of light is the less visible the smaller its patch looks.
        const float edge  = std::max(std::abs(field.x_at(a.column) - field.x_at(b.column)),
                                     std::abs(field.z_at(a.row) - field.z_at(b.row)));
        const float patch = std::min(edge / (4.0f * far), 1.0f);
        return std::max(bend / (height_tolerance_m * far), shading * patch / shade_tolerance);
    };
    return halve_right_triangles(kCells, false, middle_error);
}

}  // namespace demo
