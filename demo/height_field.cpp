// SPDX-License-Identifier: MIT
#include "demo/height_field.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace demo {

HeightField::HeightField(Vec2 center, Vec2 half_size, const std::function<float(float, float)>& height_of)
    : center_(center), half_size_(half_size), x_(kPoints), z_(kPoints), heights_(kPoints * kPoints) {
    for (int i = 0; i < kPoints; ++i) {
        const float offset = warp(static_cast<float>(2 * i - kCells) / static_cast<float>(kCells));
        x_[i]              = center.x + half_size.x * offset;
        z_[i]              = center.y + half_size.y * offset;
    }
    for (int row = 0; row < kPoints; ++row)
        for (int column = 0; column < kPoints; ++column)
            heights_[row * kPoints + column] = height_of(x_[column], z_[row]);
    const auto [low, high] = std::minmax_element(heights_.begin(), heights_.end());
    min_height_            = *low;
    max_height_            = *high;
}

float HeightField::warp(float s) {
    return s * (kCenterDensity + (1.0f - kCenterDensity) * std::abs(s));
}

// s from s (a + b s) = offset, b = 1 - a: s = (sqrt(a a + 4 b offset) - a) / 2b, mirrored for negative offsets.
float HeightField::unwarp(float offset) {
    constexpr float a = kCenterDensity, b = 1.0f - kCenterDensity;
    const float s = (std::sqrt(a * a + 4.0f * b * std::abs(offset)) - a) * (0.5f / b);
    return offset < 0.0f ? -s : s;
}

float HeightField::height_at(float x, float z) const {
    const auto grid_coordinate = [](float offset) {
        return (unwarp(std::clamp(offset, -1.0f, 1.0f)) + 1.0f) * (0.5f * static_cast<float>(kCells));
    };
    const float u    = grid_coordinate((x - center_.x) / half_size_.x);
    const float v    = grid_coordinate((z - center_.y) / half_size_.y);
    const int column = std::clamp(static_cast<int>(u), 0, kCells - 1);
    const int row    = std::clamp(static_cast<int>(v), 0, kCells - 1);
    const float du = u - static_cast<float>(column), dv = v - static_cast<float>(row);
    const float* near_row = &heights_[row * kPoints + column];
    const float* far_row  = near_row + kPoints;
    const float near_z    = near_row[0] + (near_row[1] - near_row[0]) * du;
    const float far_z     = far_row[0] + (far_row[1] - far_row[0]) * du;
    return near_z + (far_z - near_z) * dv;
}

Vec3 HeightField::normal(int column, int row) const {
    const int west = std::max(column - 1, 0), east = std::min(column + 1, kCells);
    const int north = std::max(row - 1, 0), south = std::min(row + 1, kCells);
    const float slope_x = (height(east, row) - height(west, row)) / (x_[east] - x_[west]);
    const float slope_z = (height(column, south) - height(column, north)) / (z_[south] - z_[north]);
    return glm::normalize(Vec3(-slope_x, 1.0f, -slope_z));
}

}  // namespace demo
