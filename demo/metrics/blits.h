// SPDX-License-Identifier: MIT
// Bilinear blits in double precision: what the rectangles of a blur would give without rounding to bytes.
#pragma once

#include <span>
#include <vector>

#include "demo/metrics/grid.h"
#include "pipeline/frame/frame.h"

namespace demo {

// Does the pass do nothing but show one target, filtered, by one rectangle?
bool is_blit(const pipeline::Pass& pass);

// Such a pass by itself: sets what its scissor allows of `into`. Centres of pixels are at halves; addresses are
// clamped.
void blit(const pipeline::Pass& pass, const DeepPlane& source, DeepPlane& into);

// The destination's pixels per texel of the source: 1/2 where the blit halves.
double scale_of(const pipeline::Pass& pass, const pipeline::Frame& frame);

// Its columns alone, with targets of another width: from a row of them to one of `width`, that begins with the
// source's first texel. Without scissor; scale: scale_of().
std::vector<double> blit_columns(const pipeline::Pass& pass, const std::vector<double>& source, double scale,
                                 int width);

// Several of them, one after the other. images: of the frame's targets, by index; those never mentioned may be empty.
void blit_all(const pipeline::Frame& frame, std::span<const pipeline::Pass> passes, std::vector<DeepPlane>& images);

// Zeros in the size of each target.
std::vector<DeepPlane> empty_images(const pipeline::Frame& frame);

}  // namespace demo
