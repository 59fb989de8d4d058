// SPDX-License-Identifier: MIT
// A terrain as heights on a warped grid: kCells x kCells cells over a rectangle, finest in its centre and coarser
// outwards, so that detail is spent where the camera is. Grid point i lies at s = 2i/kCells - 1 and
//   x = center + half_size * s * (kCenterDensity + (1 - kCenterDensity) |s|),
// a quadratic, whose inverse needs one square root. Lengths in metres, y up; x by column, z by row.
#pragma once

#include <functional>
#include <vector>

#include "pipeline/frame/math_types.h"

namespace demo {

using pipeline::Vec2;
using pipeline::Vec3;

class HeightField {
  public:
    static constexpr int kCells           = 512;
    static constexpr int kPoints          = kCells + 1;
    static constexpr float kCenterDensity = 0.2f;

    // height_of is asked once for each point of the grid.
    HeightField(Vec2 center, Vec2 half_size, const std::function<float(float x, float z)>& height_of);

    float x_at(int column) const { return x_[column]; }
    float z_at(int row) const { return z_[row]; }
    float height(int column, int row) const { return heights_[row * kPoints + column]; }
    Vec3 point(int column, int row) const { return {x_at(column), height(column, row), z_at(row)}; }
    Vec3 normal(int column, int row) const;
    float max_height() const { return max_height_; }
    float min_height() const { return min_height_; }

    // Bilinear between grid points; outside the rectangle, the height of its border.
    float height_at(float x, float z) const;

  private:
    static float warp(float s);
    static float unwarp(float offset);

    Vec2 center_, half_size_;
    std::vector<float> x_, z_, heights_;
    float min_height_ = 0.0f, max_height_ = 0.0f;
};

}  // namespace demo
