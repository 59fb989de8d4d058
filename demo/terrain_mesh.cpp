// SPDX-License-Identifier: MIT
#include "demo/terrain_mesh.h"

#include <algorithm>
#include <cmath>

namespace demo {
namespace {

constexpr int kPoints = HeightField::kPoints, kCells = HeightField::kCells;
constexpr std::uint32_t kUnused = 0xffffffffu;
// Triangles with a hypotenuse longer than this many cells are always halved: fog and light are linear across a
// triangle.
constexpr int kLongestEdge      = 32;

struct GridPoint {
    int column, row;
    int index() const { return row * kPoints + column; }
};
GridPoint midpoint(GridPoint a, GridPoint b) {
    return {(a.column + b.column) / 2, (a.row + b.row) / 2};
}

// a, b: the ends of the hypotenuse; c: the right angle. Turned the same way as (a, b, c) all through the halving.
struct RightTriangle {
    GridPoint a, b, c;
    bool can_halve() const { return std::abs(a.column - c.column) + std::abs(a.row - c.row) > 1; }
    std::array<RightTriangle, 2> halves() const {
        const GridPoint m = midpoint(a, b);
        return {RightTriangle{c, a, m}, RightTriangle{b, c, m}};
    }
};
constexpr RightTriangle kRoots[2] = {{{0, 0}, {kCells, kCells}, {kCells, 0}}, {{kCells, kCells}, {0, 0}, {0, kCells}}};

class Triangulation {
  public:
    Triangulation(const HeightField& field, const std::vector<float>& shade, float height_tolerance,
                  float shade_tolerance)
        : field_(field), shade_(shade), height_tolerance_(height_tolerance), shade_tolerance_(shade_tolerance) {}

    TerrainMesh run() {
        // Bottom up, level by level, so that both triangles at an edge have added to its midpoint's error before the
        // level above reads it.
        for (int level = kLevels - 1; level >= 0; --level)
            for (const RightTriangle& root : kRoots) gather_errors(root, level);
        for (const RightTriangle& root : kRoots) emit(root);
        return std::move(mesh_);
    }

  private:
    static constexpr int kLevels = 18;  // two for each halving of 512 cells

    void gather_errors(const RightTriangle& triangle, int levels_down) {
        if (!triangle.can_halve()) return;
        if (levels_down > 0) {
            for (const RightTriangle& half : triangle.halves()) gather_errors(half, levels_down - 1);
            return;
        }
        const GridPoint m = midpoint(triangle.a, triangle.b);
        float error       = own_error(triangle, m);
        for (const RightTriangle& half : triangle.halves()) {
            if (!half.can_halve()) continue;
            const GridPoint below = midpoint(half.a, half.b);
            error                 = std::max(error, error_[below.index()]);
        }
        error_[m.index()] = std::max(error_[m.index()], error);
    }

    // In units of the tolerance: above 1, the midpoint is needed.
    float own_error(const RightTriangle& triangle, GridPoint m) const {
        const GridPoint a = triangle.a, b = triangle.b;
        if (std::max(std::abs(a.column - b.column), std::abs(a.row - b.row)) > kLongestEdge) return 2.0f;
        const float x        = field_.x_at(m.column) - field_.x_at(kCells / 2);
        const float z        = field_.z_at(m.row) - field_.z_at(kCells / 2);
        const float distance = std::sqrt(x * x + z * z);
        const float far      = std::max(distance / 100.0f, 1.0f);
        const float bend =
            field_.height(m.column, m.row) - 0.5f * (field_.height(a.column, a.row) + field_.height(b.column, b.row));
        const float shading = shade_[m.index()] - 0.5f * (shade_[a.index()] + shade_[b.index()]);
        // A change of light is the less visible the smaller its patch looks.
        const float edge    = std::max(std::abs(field_.x_at(a.column) - field_.x_at(b.column)),
                                       std::abs(field_.z_at(a.row) - field_.z_at(b.row)));
        const float patch   = std::min(edge / (4.0f * far), 1.0f);
        return std::max(std::abs(bend) / (height_tolerance_ * far), std::abs(shading) * patch / shade_tolerance_);
    }

    void emit(const RightTriangle& triangle) {
        if (triangle.can_halve() && error_[midpoint(triangle.a, triangle.b).index()] > 1.0f) {
            for (const RightTriangle& half : triangle.halves()) emit(half);
            return;
        }
        mesh_.triangles.push_back({vertex(triangle.a), vertex(triangle.b), vertex(triangle.c)});
    }

    std::uint32_t vertex(GridPoint point) {
        std::uint32_t& index = vertex_of_[point.index()];
        if (index == kUnused) {
            index = static_cast<std::uint32_t>(mesh_.points.size());
            mesh_.points.push_back(static_cast<std::uint32_t>(point.index()));
        }
        return index;
    }

    const HeightField& field_;
    const std::vector<float>& shade_;
    float height_tolerance_, shade_tolerance_;
    std::vector<float> error_             = std::vector<float>(kPoints * kPoints, 0.0f);
    std::vector<std::uint32_t> vertex_of_ = std::vector<std::uint32_t>(kPoints * kPoints, kUnused);
    TerrainMesh mesh_;
};

}  // namespace

TerrainMesh triangulate(const HeightField& field, const std::vector<float>& shade, float height_tolerance_m,
                        float shade_tolerance) {
    return Triangulation(field, shade, height_tolerance_m, shade_tolerance).run();
}

}  // namespace demo
