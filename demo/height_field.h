// SPDX-License-Identifier: MIT
// A terrain as heights on a warped grid: kCells x kCells cells over a rectangle, finest in its centre and coarser
// outwards, so that detail is spent where the camera is. Grid point i lies at s = 2i/kCells - 1 and
//   x = center + half_size * s * (kCenterDensity + (1 - kCenterDensity) |s|),
// a quadratic, whose inverse needs one square root. Lengths in metres, y up; x by column, z by row.
#pragma once

#include <functional>
#include <span>
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

    // Makes what sets the heights of a row, once for all columns; that is asked once for each row, for several at once.
    using RowOf = std::function<void(float z, std::span<float> heights)>;
    HeightField(Vec2 center, Vec2 half_size, const std::function<RowOf(std::span<const float> x)>& rows_of);

    // height_of is asked once for each point of the grid, for several at once.
    HeightField(Vec2 center, Vec2 half_size, const std::function<float(float x, float z)>& height_of);

    float x_at(int column) const { return x_[column]; }
    float z_at(int row) const { return z_[row]; }
    float height(int column, int row) const { return heights_[row * kPoints + column]; }
    Vec3 point(int column, int row) const { return {x_at(column), height(column, row), z_at(row)}; }
    Vec3 normal(int column, int row) const;
    float max_height() const { return max_height_; }
    float min_height() const { return min_height_; }

    // Bilinear between grid points; outside the rectangle, the height of its border.
    float height_at(float x, float z) const { return height_at(along_x(x), along_z(z)); }

    // A coordinate in the grid: the cell's first column or row, and the share of the next. Whoever asks for the heights of
    // many points in a row finds the row's once.
    struct GridCoordinate {
        int cell;
        float share;
    };
    GridCoordinate along_x(float x) const { return grid_coordinate((x - center_.x) / half_size_.x); }
    GridCoordinate along_z(float z) const { return grid_coordinate((z - center_.y) / half_size_.y); }
    float height_at(const GridCoordinate& x, const GridCoordinate& z) const {
        const float* near_row = &heights_[z.cell * kPoints + x.cell];
        const float* far_row  = near_row + kPoints;
        const float near_z    = near_row[0] + (near_row[1] - near_row[0]) * x.share;
        const float far_z     = far_row[0] + (far_row[1] - far_row[0]) * x.share;
        return near_z + (far_z - near_z) * z.share;
    }

  private:
    static float warp(float s);
    static float unwarp(float offset);
    static GridCoordinate grid_coordinate(float offset);

    Vec2 center_, half_size_;
    std::vector<float> x_, z_, heights_;
    float min_height_ = 0.0f, max_height_ = 0.0f;
};

}  // namespace demo
