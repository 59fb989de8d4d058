// SPDX-License-Identifier: MIT
#include "demo/right_triangles.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace demo {
namespace {

constexpr std::uint32_t kUnused = 0xffffffffu;

GridPoint middle_of(GridPoint a, GridPoint b) {
    return {(a.column + b.column) / 2, (a.row + b.row) / 2};
}

// a, b: the ends of the hypotenuse; c: the right angle. Turned the same way as (a, b, c) all through the halving.
struct RightTriangle {
    GridPoint a, b, c;
    bool can_halve() const { return std::abs(a.column - c.column) + std::abs(a.row - c.row) > 1; }
    GridPoint middle() const { return middle_of(a, b); }
    std::array<RightTriangle, 2> halves() const {
        const GridPoint m = middle();
        return {RightTriangle{c, a, m}, RightTriangle{b, c, m}};
    }
};

class Halving {
  public:
    Halving(int cells, bool closed, const MiddleError& error_of)
        : cells_(cells),
          closed_(closed),
          error_of_(error_of),
          error_(static_cast<std::size_t>((cells + 1) * (cells + 1)), 0.0f),
          vertex_of_(error_.size(), kUnused) {}

    TriangleMesh run() {
        const RightTriangle roots[2] = {{{0, 0}, {cells_, cells_}, {cells_, 0}},
                                        {{cells_, cells_}, {0, 0}, {0, cells_}}};
        int levels                   = 0;  // two for each halving of the side
        for (int side = cells_; side > 1; side /= 2) levels += 2;
        // Bottom up, level by level, so that both triangles at an edge have added to its middle's error before the
        // level above reads it.
        for (int level = levels - 1; level >= 0; --level) {
            for (const RightTriangle& root : roots) gather_errors(root, level);
            if (closed_) join_seam();
        }
        for (const RightTriangle& root : roots) emit(root);
        return std::move(mesh_);
    }

  private:
    int index(GridPoint point) const { return point.row * (cells_ + 1) + point.column; }

    void gather_errors(const RightTriangle& triangle, int levels_down) {
        if (!triangle.can_halve()) return;
        if (levels_down > 0) {
            for (const RightTriangle& half : triangle.halves()) gather_errors(half, levels_down - 1);
            return;
        }
        float error = error_of_(triangle.a, triangle.b, triangle.middle());
        for (const RightTriangle& half : triangle.halves())
            if (half.can_halve()) error = std::max(error, error_[index(half.middle())]);
        float& known = error_[index(triangle.middle())];
        known        = std::max(known, error);
    }

    void join_seam() {
        for (int row = 0; row <= cells_; ++row) {
            float &first = error_[index({0, row})], &last = error_[index({cells_, row})];
            first = last = std::max(first, last);
        }
    }

    void emit(const RightTriangle& triangle) {
        if (triangle.can_halve() && error_[index(triangle.middle())] > 1.0f) {
            for (const RightTriangle& half : triangle.halves()) emit(half);
            return;
        }
        mesh_.triangles.push_back({vertex(triangle.a), vertex(triangle.b), vertex(triangle.c)});
    }

    std::uint32_t vertex(GridPoint point) {
        std::uint32_t& vertex = vertex_of_[index(point)];
        if (vertex == kUnused) {
            vertex = static_cast<std::uint32_t>(mesh_.points.size());
            mesh_.points.push_back(static_cast<std::uint32_t>(index(point)));
        }
        return vertex;
    }

    int cells_;
    bool closed_;
    const MiddleError& error_of_;
    std::vector<float> error_;
    std::vector<std::uint32_t> vertex_of_;
    TriangleMesh mesh_;
};

}  // namespace

TriangleMesh halve_right_triangles(int cells, bool closed, const MiddleError& error_of) {
    assert(cells >= 1 && (cells & (cells - 1)) == 0);
    return Halving(cells, closed, error_of).run();
}

}  // namespace demo
