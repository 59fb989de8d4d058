// SPDX-License-Identifier: MIT
#include "demo/height_field.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace demo {

HeightField::HeightField(Vec2 center, Vec2 half_size, const std::function<RowOf(std::span<const float>)>& rows_of)
    : center_(center), half_size_(half_size), x_(kPoints), z_(kPoints), heights_(kPoints * kPoints) {
    for (int i = 0; i < kPoints; ++i) {
        const float offset = warp(static_cast<float>(2 * i - kCells) / static_cast<float>(kCells));
        x_[i]              = center.x + half_size.x * offset;
        z_[i]              = center.y + half_size.y * offset;
    }
    const RowOf set_row = rows_of(x_);
    tbb::parallel_for(0, kPoints, [&](int row) {
        set_row(z_[row], std::span(heights_).subspan(static_cast<std::size_t>(row * kPoints), kPoints));
    });
    const auto [low, high] = std::minmax_element(heights_.begin(), heights_.end());
    min_height_            = *low;
    max_height_            = *high;
}

HeightField::HeightField(Vec2 center, Vec2 half_size, const std::function<float(float, float)>& height_of)
    : HeightField(center, half_size, [&height_of](std::span<const float> x) {
          return [&height_of, x](float z, std::span<float> heights) {
              for (std::size_t column = 0; column < x.size(); ++column) heights[column] = height_of(x[column], z);
          };
      }) {}

float HeightField::warp(float s) {
    return s * (kCenterDensity + (1.0f - kCenterDensity) * std::abs(s));
}

// s from s (a + b s) = offset, b = 1 - a: s = (sqrt(a a + 4 b offset) - a) / 2b, mirrored for negative offsets.
float HeightField::unwarp(float offset) {
    constexpr float a = kCenterDensity, b = 1.0f - kCenterDensity;
    const float s = (std::sqrt(a * a + 4.0f * b * std::abs(offset)) - a) * (0.5f / b);
    return offset < 0.0f ? -s : s;
}

HeightField::GridCoordinate HeightField::grid_coordinate(float offset) {
    const float u  = (unwarp(std::clamp(offset, -1.0f, 1.0f)) + 1.0f) * (0.5f * static_cast<float>(kCells));
    const int cell = std::clamp(static_cast<int>(u), 0, kCells - 1);
    return {cell, u - static_cast<float>(cell)};
}

Vec3 HeightField::normal(int column, int row) const {
    const int west = std::max(column - 1, 0), east = std::min(column + 1, kCells);
    const int north = std::max(row - 1, 0), south = std::min(row + 1, kCells);
    const float slope_x = (height(east, row) - height(west, row)) / (x_[east] - x_[west]);
    const float slope_z = (height(column, south) - height(column, north)) / (z_[south] - z_[north]);
    return glm::normalize(Vec3(-slope_x, 1.0f, -slope_z));
}

}  // namespace demo
