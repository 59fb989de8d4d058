// SPDX-License-Identifier: MIT
// Hidden blocks are found as one sees a range of hills: near to far, keeping the horizon of what has been passed. From
// above the surface, nothing is seen through the curtain that hangs from a line on it.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <utility>

#include "demo/terrain_blocks.h"

namespace demo {
namespace {

constexpr int kBlocks = TerrainBlocks::kBlocks, kStepsPerBlock = TerrainBlocks::kStepsPerBlock;
constexpr int kRidges = TerrainBlocks::kRidges;

// A box is outside if all its corners are beyond the same side of the view.
class Frustum {
  public:
    Frustum(const Mat4& view, const Mat4& projection) : to_clip_(glm::dmat4(projection) * glm::dmat4(view)) {}

    bool may_show(const Vec3& low, const Vec3& high) const {
        unsigned beyond_all = 0x1fu;
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec4 p = to_clip_ * glm::dvec4(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y,
                                                       corner & 4 ? high.z : low.z, 1.0);
            beyond_all &= (p.x < -p.w ? 1u : 0u) | (p.x > p.w ? 2u : 0u) | (p.y < -p.w ? 4u : 0u) |
                          (p.y > p.w ? 8u : 0u) | (p.z < 0.0 ? 16u : 0u);
        }
        return beyond_all == 0;
    }

  private:
    glm::dmat4 to_clip_;
};

// A rectangle or a stretch of a line on the map, as seen from a point outside it.
struct Outline {
    float first, last;  // its directions, in sectors; last may exceed kSectors
    float nearest, farthest;
};

constexpr int kSectors = 2048;

// Grows with the angle like it, without its trigonometry: 0..4 around.
float direction(float x, float z) {
    const float share = x / (std::abs(x) + std::abs(z));
    return z < 0.0f ? 3.0f + share : 1.0f - share;
}

// Not for an eye above it.
Outline outline_of(const Vec3& eye, const Vec2& low, const Vec2& high) {
    constexpr float kScale = kSectors / 4.0f;
    const float x[2] = {low.x - eye.x, high.x - eye.x}, z[2] = {low.y - eye.z, high.y - eye.z};
    const float reference = direction(x[0], z[0]);
    float first = 0.0f, last = 0.0f;
    for (int corner = 1; corner < 4; ++corner) {
        // Less than half a turn to either side.
        float turn = direction(x[corner & 1], z[corner >> 1]) - reference;
        turn += turn < -2.0f ? 4.0f : turn > 2.0f ? -4.0f : 0.0f;
        first = std::min(first, turn);
        last  = std::max(last, turn);
    }
    const float wrap   = reference + first < 0.0f ? 4.0f : 0.0f;
    const float near_x = std::max({x[0], -x[1], 0.0f}), near_z = std::max({z[0], -z[1], 0.0f});
    const float far_x = std::max(-x[0], x[1]), far_z = std::max(-z[0], z[1]);
    return {.first    = (reference + first + wrap) * kScale,
            .last     = (reference + last + wrap) * kScale,
            .nearest  = std::sqrt(near_x * near_x + near_z * near_z),
            .farthest = std::sqrt(far_x * far_x + far_z * far_z)};
}

// The slope, height over distance, below which nothing farther can be seen, in each sector of directions.
class Horizon {
  public:
    Horizon() { slopes_.fill(-std::numeric_limits<float>::infinity()); }

    // A curtain from `top` downwards: the slope that it hides at least, wherever a ray meets it.
    void raise(const Outline& outline, float top) {
        const float slope = top > 0.0f ? top / outline.farthest : top / outline.nearest;
        // Only sectors that lie in it as a whole.
        const int end     = static_cast<int>(outline.last - kRounding);
        for (int i = static_cast<int>(outline.first + kRounding) + 1; i < end; ++i)
            slopes_[i % kSectors] = std::max(slopes_[i % kSectors], slope);
    }

    bool hides(const Outline& outline, float top) const {
        const float slope = top > 0.0f ? top / outline.nearest : top / outline.farthest;
        const int end     = static_cast<int>(outline.last + kRounding);
        for (int i = static_cast<int>(std::max(outline.first - kRounding, 0.0f)); i <= end; ++i)
            if (!(slope < slopes_[i % kSectors])) return false;
        return true;
    }

  private:
    static constexpr float kRounding = 0.01f;
    std::array<float, kSectors> slopes_;
};

class Viewing {
  public:
    Viewing(const TerrainBlocks& terrain, const Vec3& eye, const Mat4& view, const Mat4& projection)
        : terrain_(terrain), eye_(eye), frustum_(view, projection) {}

    std::vector<const TerrainBlock*> run() {
        eye_column_      = block_of(terrain_.x_lines, eye_.x);
        eye_row_         = block_of(terrain_.z_lines, eye_.z);
        // From beside the terrain, or from below, one could look under its surface.
        const bool hides = is_over(map_point(0, 0), map_point(TerrainBlocks::kSteps, TerrainBlocks::kSteps)) &&
                           eye_.y > terrain_.blocks[eye_row_ * kBlocks + eye_column_].high.y;
        // A ray from the eye never turns back towards the eye's column or row: a block with a larger sum of steps away
        // lies behind those with a smaller one.
        for (int steps = 0; steps < 2 * kBlocks - 1; ++steps) {
            const std::size_t first = visible_.size();
            std::vector<std::pair<int, int>> shown;
            for (int row = 0; row < kBlocks; ++row) {
                const int rest = steps - std::abs(row - eye_row_);
                if (rest >= 0) show(eye_column_ - rest, row, shown);
                if (rest > 0) show(eye_column_ + rest, row, shown);
            }
            if (hides && visible_.size() > first)
                for (const auto& [column, row] : shown) raise_horizon(column, row);
        }
        return std::move(visible_);
    }

  private:
    static int block_of(const std::vector<float>& lines, float at) {
        const auto above = std::upper_bound(lines.begin(), lines.end(), at);
        return std::clamp(static_cast<int>(above - lines.begin()) - 1, 0, TerrainBlocks::kSteps - 1) / kStepsPerBlock;
    }

    Vec2 map_point(int x_line, int z_line) const { return {terrain_.x_lines[x_line], terrain_.z_lines[z_line]}; }

    bool is_over(const Vec2& low, const Vec2& high) const {
        return eye_.x >= low.x && eye_.x <= high.x && eye_.z >= low.y && eye_.z <= high.y;
    }

    void show(int column, int row, std::vector<std::pair<int, int>>& shown) {
        if (column < 0 || column >= kBlocks) return;
        const TerrainBlock& block = terrain_.blocks[row * kBlocks + column];
        if (!frustum_.may_show(block.low, block.high)) return;
        const Vec2 low(block.low.x, block.low.z), high(block.high.x, block.high.z);
        if (!is_over(low, high) && (hides(low, high, block.high.y) || hides_all_parts(column, row))) return;
        visible_.push_back(&block);
        shown.emplace_back(column, row);
    }

    bool hides(const Vec2& low, const Vec2& high, float top) const {
        return horizon_.hides(outline_of(eye_, low, high), top - eye_.y);
    }

    // The same for each cell between lines: closer bounds, for more work.
    bool hides_all_parts(int column, int row) const {
        for (int j = row * kStepsPerBlock; j < (row + 1) * kStepsPerBlock; ++j)
            for (int i = column * kStepsPerBlock; i < (column + 1) * kStepsPerBlock; ++i)
                if (!hides(map_point(i, j), map_point(i + 1, j + 1), terrain_.highest[j * TerrainBlocks::kSteps + i]))
                    return false;
        return true;
    }

    // By the ridges on the block's own lines, the first of each direction and not the last, that begin or end in it on
    // the side turned away from the eye. They overlap, so that no sector between two of them is left open.
    void raise_horizon(int column, int row) {
        const auto first_ridge = [](int block, int eye_block) {
            return std::max(block * kStepsPerBlock - (block > eye_block ? 1 : 0), 0);
        };
        const auto end_ridge = [](int block, int eye_block) {
            return std::min((block + 1) * kStepsPerBlock - (block >= eye_block ? 1 : 0), kRidges);
        };
        const auto raise = [&](const Vec2& low, const Vec2& high, float top) {
            if (!is_over(low, high)) horizon_.raise(outline_of(eye_, low, high), top - eye_.y);
        };
        constexpr int kLines = kStepsPerBlock / 2;
        for (int k = row * kLines; k < (row + 1) * kLines; ++k)
            for (int i = first_ridge(column, eye_column_); i < end_ridge(column, eye_column_); ++i)
                raise(map_point(i, 2 * k), map_point(i + 2, 2 * k), terrain_.along_x[k * kRidges + i]);
        for (int k = column * kLines; k < (column + 1) * kLines; ++k)
            for (int i = first_ridge(row, eye_row_); i < end_ridge(row, eye_row_); ++i)
                raise(map_point(2 * k, i), map_point(2 * k, i + 2), terrain_.along_z[k * kRidges + i]);
    }

    const TerrainBlocks& terrain_;
    Vec3 eye_;
    Frustum frustum_;
    Horizon horizon_;
    int eye_column_ = 0, eye_row_ = 0;  // of its block
    std::vector<const TerrainBlock*> visible_;
};

}  // namespace

std::vector<const TerrainBlock*> visible_blocks(const TerrainBlocks& terrain, const Vec3& eye, const Mat4& view,
                                                const Mat4& projection) {
    return Viewing(terrain, eye, view, projection).run();
}

}  // namespace demo
