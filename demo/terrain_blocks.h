// SPDX-License-Identifier: MIT
// A terrain's triangles in blocks that are drawn or left out as a whole, and what decides that: the blocks' bounds, and
// how low the surface reaches along lines across it, which hide what lies lower behind them, and how high between.
// Lengths in metres, y up.
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/frame/math_types.h"

namespace demo {

using pipeline::Mat4;
using pipeline::Vec2;
using pipeline::Vec3;

// Indices of the scene's vertices, by what covers the triangles. The overlays lie on triangles of the other two: rock
// on the ground, and on rock, by their vertices' alpha.
struct TerrainBlock {
    Vec3 low = Vec3(0.0f), high = Vec3(0.0f);
    std::vector<std::uint32_t> ground, walls, overlays;
};

struct TerrainBlocks {
    static constexpr int kBlocks = 32, kStepsPerBlock = 8, kSteps = kBlocks * kStepsPerBlock;  // along each side
    // Ridges are stretches of every second line, two steps long, and overlap by one.
    static constexpr int kRidgeLines = kSteps / 2 + 1, kRidges = kSteps - 1;

    int ground_texture = -1, detail_texture = -1, rock_texture = -1;  // of the scene; detail: the ground's second stage
    std::vector<TerrainBlock> blocks;                                 // row by row; row along z, column along x
    std::vector<float> x_lines, z_lines;                              // kSteps + 1
    std::vector<float> highest;  // of the surface between lines j, j + 1 of z and i, i + 1 of x: [j * kSteps + i]
    // Least height of the surface over ridge i of line k: along_x[k * kRidges + i] from (x_lines[i], z_lines[2 k]) to
    // (x_lines[i + 2], z_lines[2 k]), and along_z with x and z exchanged.
    std::vector<float> along_x, along_z;

    bool empty() const { return blocks.empty(); }
};

// What a camera may see of it, near blocks before those that they may hide. Leaves out only what lies outside the view
// or behind nearer terrain.
std::vector<const TerrainBlock*> visible_blocks(const TerrainBlocks& terrain, const Vec3& eye, const Mat4& view,
                                                const Mat4& projection);

}  // namespace demo
