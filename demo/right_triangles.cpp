// SPDX-License-Identifier: MIT
#include "demo/right_triangles.h"

#include <tbb/parallel_for.h>

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
        // Bottom up: the middles of the squares' sides, then those of the squares, then twice as large squares.
        for (int side = 2; side <= cells_; side *= 2) {
            tbb::parallel_for(0, 2 * (cells_ / side) + 1, [&](int line) { gather_sides(side, line); });
            if (closed_) join_seam();
            tbb::parallel_for(0, cells_ / side, [&](int row) { gather_squares(side, row); });
        }
        const RightTriangle roots[2] = {{{0, 0}, {cells_, cells_}, {cells_, 0}},
                                        {{cells_, cells_}, {0, 0}, {0, cells_}}};
        for (const RightTriangle& root : roots) emit(root);
        return std::move(mesh_);
    }

  private:
    int index(GridPoint point) const { return point.row * (cells_ + 1) + point.column; }

    // Sides that lie along the rows in even lines, and along the columns in odd ones. The two triangles at a side have
    // their right angles in the middles of the squares beside it; their halves' longest sides are the diagonals of the
    // small squares there.
    void gather_sides(int side, int line) {
        const int half = side / 2, quarter = side / 4, row = line * half;
        for (int column = line % 2 == 0 ? half : 0; column <= cells_; column += side) {
            const GridPoint a = line % 2 == 0 ? GridPoint{column - half, row} : GridPoint{column, row - half};
            const GridPoint b = line % 2 == 0 ? GridPoint{column + half, row} : GridPoint{column, row + half};
            float error       = error_of_(a, b, {column, row});
            if (quarter > 0)
                for (const int y : {row - quarter, row + quarter})
                    for (const int x : {column - quarter, column + quarter})
                        if (x >= 0 && x <= cells_ && y >= 0 && y <= cells_)
                            error = std::max(error, error_[index({x, y})]);
            error_[index({column, row})] = error;
        }
    }

    // Diagonals run through the middle of the next larger square. The sides are those of the triangles' halves.
    void gather_squares(int side, int line) {
        const int half = side / 2, row = line * side;
        for (int column = 0; column < cells_; column += side) {
            const bool falls = (column / side + line) % 2 == 0;
            const GridPoint a{column, falls ? row : row + side}, b{column + side, falls ? row + side : row};
            const GridPoint m{column + half, row + half};
            float error = error_of_(a, b, m);
            for (const GridPoint side_middle :
                 {GridPoint{m.column, row}, {m.column, row + side}, {column, m.row}, {column + side, m.row}})
                error = std::max(error, error_[index(side_middle)]);
            error_[index(m)] = error;
        }
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
