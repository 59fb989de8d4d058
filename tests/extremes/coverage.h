// SPDX-License-Identifier: MIT
// How often the triangles of a mesh hit each pixel. Clockwise ones and the others are counted apart: where the mesh of
// snapped corners has no folds each pixel of it is hit once; where it has, a pixel is hit clockwise once more than
// counter-clockwise, for the fill rule is that of a sample point moved by less than anything, the same for all edges.
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/frame/frame.h"
#include "tests/extremes/extremes.h"

namespace extremes {

// Pixels. wrong: hit clockwise less counter-clockwise is not once (or, outside the mesh, not 0). twice: hit more often than
// that all the same, in folds. A pixel is hit 255 times at most.
struct Hits {
    std::uint64_t pixels = 0, wrong = 0, twice = 0;
    Hits& operator+=(const Hits& more) {
        pixels += more.pixels, wrong += more.wrong, twice += more.twice;
        return *this;
    }
};

// What a fan is cut by.
enum class Cut : std::uint8_t { Nothing, GuardBand, NearPlane };

// A frame that adds 1 to red for each clockwise hit of a pixel, and to green for each of the others. The mesh is in its
// vertices and indices, of window vertices if there are any.
pipeline::Frame counting_frame(int width, int height, const pipeline::Arithmetic& grid);
void count_with(pipeline::Frame& frame);

// covered: the pixels that the mesh covers, the whole target if left out.
Hits hits_of(const pipeline::Frame& frame, const pipeline::PixelRect& covered = {});

// A fan of random triangles around a hub at (phase_x, phase_y) sixteenths of a pixel, over all of a target of 32x32.
pipeline::Frame random_fan(Cut cut, const pipeline::Arithmetic& grid, int phase_x, int phase_y, std::uint32_t seed);

// All 16x16 phases.
Hits fan_hits(Cut cut, const pipeline::Arithmetic& grid, std::uint32_t fans_per_phase);

// Nine rectangles, the middle ones a subpixel wide and high, side by side over all of a target, at all 16 phases.
Hits rectangle_hits(const pipeline::Arithmetic& grid);

// A million triangles around one corner, as far as window vertices go.
Hits million_hits();

// 50,000 random slivers around a point, far beyond the guard band and off the grid: all grids.
Hits fine_hits();

// Meshes of 64x64 squares, two triangles each, with sides of 2^exponent pixels around the middle of a target of 64x64.
Hits mesh_hits(int exponent);
inline constexpr int kLeastSide = -12, kGreatestSide = 17;

// Slivers of one subpixel by 32,000 pixels, side by side: greatest error of what lies between the corners, against double.
struct SliverErrors {
    double depth         = 0.0;  // units of 2^-30
    double color         = 0.0;  // of 255
    std::uint64_t pixels = 0;
};
SliverErrors sliver_errors();
// What primitives.h allows: F = 12, S = 12 for depth, F = 23, S = 16 for colour, read as 1/128. A plane is off by less than one
// unit of its F bits for each subpixel of |dx| + |dy| < 2^20, its step by half a unit of 2^S for 15 pixels, its row's start
// by half a unit; then a colour is rounded.
inline constexpr double kDepthBound = (1 << 20) / 4096.0 + 15 * 0.5 + 0.5;
inline constexpr double kColorBound = ((1 << 20) / 65536.0 + 15 * 0.5 + 0.5) / 128.0 + 0.5;

// The grids of the profiles, each once.
std::vector<pipeline::Arithmetic> grids();

}  // namespace extremes
