// SPDX-License-Identifier: MIT
// What a pass did, counted. Pixels are fragments: one for each primitive that covers the pixel.
#pragma once

#include <cstdint>

namespace pipeline {

struct PassCounts {
    std::uint64_t vertices        = 0;  // distinct ones that the draws refer to, draw by draw
    std::uint64_t triangles_in    = 0;  // before culling and clipping
    std::uint64_t triangles_drawn = 0;  // after both
    std::uint64_t rectangles      = 0;
    std::uint64_t copies          = 0;
    std::uint64_t covered         = 0;
    std::uint64_t depth_tested    = 0;  // passed the alpha tests, where the depth test is not ALWAYS
    std::uint64_t depth_passed    = 0;
    std::uint64_t depth_written   = 0;
    std::uint64_t color_written   = 0;
    std::uint64_t blended         = 0;  // written with a factor that reads the destination
    std::uint64_t cleared         = 0;  // pixels, colour and depth each
    std::uint64_t texels =
        0;  // read: 1 a fragment and texture, 4 if linear, twice that with linear mips; 1 a pixel copied
    std::uint64_t bytes                      = 0;  // target memory read and written, and texels read
    bool operator==(const PassCounts&) const = default;
};

}  // namespace pipeline
