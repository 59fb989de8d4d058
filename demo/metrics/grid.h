// SPDX-License-Identifier: MIT
// Pictures that are measured: one value a pixel, rows from the top, x right and y down. Pixel (x, y) stands for its
// centre, so that (2, 3) is a place as well as an index.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "pipeline/frame/math_types.h"

namespace demo {

template <class T>
struct Grid {
    int width = 0, height = 0;
    std::vector<T> values;

    Grid() = default;
    Grid(int w, int h, T fill = T{})
        : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), fill) {}
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    T& at(int x, int y) { return values[index(x, y)]; }
    const T& at(int x, int y) const { return values[index(x, y)]; }
    bool has(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
};

using Plane      = Grid<float>;
using DeepPlane  = Grid<double>;
using Mask       = Grid<std::uint8_t>;  // 0 or 1
using ColorPlane = Grid<pipeline::Vec3>;

}  // namespace demo
