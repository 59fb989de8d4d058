// SPDX-License-Identifier: MIT
// What a fill did, in fragments (pixels of one primitive).
#pragma once

#include <cstdint>

namespace raster {

struct FillCounts {
    std::uint64_t covered       = 0;  // inside a primitive and the scissor
    std::uint64_t alpha_passed  = 0;  // of those, passed the alpha tests, or go on in spite of it
    std::uint64_t depth_passed  = 0;  // of those, passed the depth test
    std::uint64_t depth_written = 0;  // of those, wrote depth
    std::uint64_t color_written = 0;  // of those, wrote colour: to one channel at least
    std::uint64_t texels        = 0;  // for each covered fragment and texture 1, 4 (linear), twice that (mip linear)
    std::uint64_t texel_bytes   = 0;  // of those, in the formats of Sampler::texel_bytes
    std::uint64_t dest_alpha_tested = 0;  // reached the destination alpha test

    FillCounts& operator+=(const FillCounts& more) {
        covered += more.covered;
        alpha_passed += more.alpha_passed;
        depth_passed += more.depth_passed;
        depth_written += more.depth_written;
        color_written += more.color_written;
        texels += more.texels;
        texel_bytes += more.texel_bytes;
        dest_alpha_tested += more.dest_alpha_tested;
        return *this;
    }
    bool operator==(const FillCounts&) const = default;
};

// By the kernel that did it: one compiled for the state, or the one for all states.
struct KernelCounts {
    FillCounts special, general;

    FillCounts total() const {
        FillCounts sum = special;
        return sum += general;
    }
    KernelCounts& operator+=(const KernelCounts& more) {
        special += more.special;
        general += more.general;
        return *this;
    }
};

}  // namespace raster
