// SPDX-License-Identifier: MIT
// Runs of passes that blur, found in the frame's data: each pass draws nothing but rectangles, unblended and in full
// colour, by the linear filter and clamped, of the target that the pass before wrote, all to one scale; after the last the
// scale is again that of the first's source. The longest such run counts.
//
// What a run does is a convolution of variance
//   sum over its passes of S^2 * mean of f(1-f)
// in pixels of the source, per axis: S the source pixels to one of the pass's own source; f, at each pixel, the fraction
// that the linear filter weighs the second of its two texels with. A box 2:1 has f = 1/2: S^2/4; a step up 1:2 has f =
// 1/4 and 3/4: S^2 3/16; each half of a tent has f = 1/2.
#pragma once

#include <array>
#include <vector>

#include "pipeline/truth/samples.h"

namespace pipeline::truth {

// Pixels: `written` is what the last pass draws of one of its rectangles, `read` what the first pass reads for it.
struct BlurArea {
    PixelRect read, written;
};

struct BlurChain {
    std::size_t first = 0, last = 0;  // passes
    TargetId source, target;
    std::array<double, 2> variance{};  // along x and y, in square pixels
    std::array<double, 2> shift{};     // a pixel's middle at p reads around p + shift
    std::vector<BlurArea> areas;
};

// In order, without a pass in common.
std::vector<BlurChain> find_blur_chains(const Frame& frame);

// Draws the chain as a Gaussian, cut off beyond 6 sigma; what lies outside of what the first pass reads counts as its
// edge. source: as it was before the first pass. pipeline/truth/gaussian.cpp.
void draw_gaussian(const BlurChain& chain, const Samples& source, bool has_alpha, Samples& target);

}  // namespace pipeline::truth
