// SPDX-License-Identifier: MIT
// A square grid of points as few triangles: right triangles, halved wherever the middle of their longest side would lie
// too far off. An edge is split from both sides or from neither, so the mesh has no cracks and no T-junctions.
// Source: Evans, Kirkpatrick & Townsend, "Right-Triangulated Irregular Networks", Algorithmica 30, 2001.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace demo {

struct GridPoint {
    int column, row;
};

// points: indices row * (cells + 1) + column of the grid points used. triangles: indices into points, counter-clockwise
// for columns that run to the right and rows that run downwards.
struct TriangleMesh {
    std::vector<std::uint32_t> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

// How far off a triangle is that ends in the hypotenuse a-b and leaves out its middle, in units of the tolerance: above
// 1, the middle is needed. 0 or more, the same from b to a; asked for several at once.
using MiddleError = std::function<float(GridPoint a, GridPoint b, GridPoint middle)>;

// cells: a power of two. closed: the last column is the first once more, and must be split like it.
TriangleMesh halve_right_triangles(int cells, bool closed, const MiddleError& error_of);

}  // namespace demo
