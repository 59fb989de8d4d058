// SPDX-License-Identifier: MIT
// What drawing a frame takes, found without drawing it or taking memory for it: so that a short text that asks for a day
// and all of the memory can be refused first. About a millisecond for 50,000 triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/validate/validate.h"

namespace pipeline {

// bytes      an estimate: targets at four bytes a pixel and the picture once more, textures as sampled, and what is kept of
//            draws and triangles at once, kDrawBytes and kTriangleBytes each
// triangles  of all draws
// pixels     of clears, of what copies read, and of the rectangles around triangles and rectangles, within target,
//            viewport and scissor: what is covered is less, about half. After as many triangles as kMostWork has, each
//            of a draw counts as all of that.
struct Work {
    std::uint64_t bytes = 0, triangles = 0, pixels = 0;
    bool operator==(const Work&) const = default;
};
inline constexpr std::uint64_t kDrawBytes = 2048, kTriangleBytes = 1024;

// The frame must be valid.
Work work_of(const Frame& frame);

// What may be asked for: targets and textures of the largest size 16 times; 67 million triangles, some ten seconds of
// one core; the largest target filled 256 times, which is some ten minutes of one core. Scenes at 8192x8192 with a cloud of 64
// slices need a quarter of these.
inline constexpr Work kMostWork{
    .bytes = std::uint64_t{1} << 32, .triangles = std::uint64_t{1} << 26, .pixels = std::uint64_t{1} << 34};

// A finding for each limit that is exceeded, and by how much: "frame must take at most 4294967296 bytes (got 60129542144)".
// times: all limits are multiplied by it.
std::vector<Finding> check_work(const Work& work, int times = 1);

// The least `times` that check_work takes.
std::uint64_t needed_limit(const Work& work);

}  // namespace pipeline
