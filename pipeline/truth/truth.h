// SPDX-License-Identifier: MIT
// The picture that a frame means, without a chip's arithmetic: a second, slow drawing of it in double precision, for
// measuring how far that of `execute` is from it. It shares no code with `execute` or the kernels.
//   exact      Vertices are not snapped, colours, depths and texel weights not rounded, targets keep doubles whatever
//              their format, nothing is dithered. What is no rounding stays: 0x80 is one where GS_SHIFT7 multiplies; a
//              channel that a format lacks reads as its constant; pixels are sampled where Arithmetic::pixel_center
//              says; what compares bytes (alpha test, destination alpha test, PABE, FBA) compares the nearest byte.
//   values     As in `execute`, colours, fog and depth are linear in window space over what clipping leaves of a triangle
//              (its guard band is the executor's, too), texture coordinates are in perspective.
//   samples    n x n in each pixel, around the point where it is sampled. Targets hold them all; what reads a target reads for
//              sample i of a pixel those samples i of the source's pixels that the pixel itself would read, weighed as
//              it would weigh them: a blit means the same with any n, and has no narrower a filter. The picture is
//              their mean. The level of detail is that of pixels, by the true logarithm.
//   gaussian   Each chain of blits that blurs (pipeline/truth/blur_chain.h) is one Gaussian of its variance.
#pragma once

#include <array>
#include <vector>

#include "pipeline/frame/frame.h"

namespace pipeline {

struct TruthOptions {
    int samples_per_axis = 4;     // 1..16
    bool true_gaussian   = true;  // false: chains are drawn blit by blit
};

// Red, green, blue, alpha in 0..1, rows from the top.
struct TruthPicture {
    int width = 0, height = 0;
    std::vector<std::array<double, 4>> pixels;
};

// The frame is valid. Of its output target; the same on any number of threads. Takes 32 bytes for each sample of each target.
// Throws std::invalid_argument for options out of range.
TruthPicture draw_truth(const Frame& frame, const TruthOptions& options = {});

}  // namespace pipeline
