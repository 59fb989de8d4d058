// SPDX-License-Identifier: MIT
// One pass of a frame on the truth's targets.
#pragma once

#include "pipeline/truth/samples.h"

namespace pipeline::truth {

// targets: those of the frame, in its order.
void draw_pass(const Frame& frame, const Pass& pass, const SampleGrid& grid, std::vector<Samples>& targets);

// What viewport and scissor leave of the pass's targets, and the viewport alone.
PixelRect drawn_area(const Frame& frame, const Pass& pass);
PixelRect viewport_of(const Frame& frame, const Pass& pass);

inline PixelRect intersected(const PixelRect& a, const PixelRect& b) {
    return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

}  // namespace pipeline::truth
