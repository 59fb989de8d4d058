// SPDX-License-Identifier: MIT
// How far two right answers may be apart: the frame's ideal arithmetic rounds to a byte after every step, OpenGL
// computes in fractions and rounds when it blends or stores. Half a unit (of 255) is lost by each rounding; what a step
// does to the errors of its arguments, which are 0..1, follows from its formula:
//   select e_a    modulate, add, subtract, add-signed e_a + e_b    2X, 4X: times 2, 4
//   interpolate max(e_a, e_b) + e of the weight    fog: e_a + e of the factor
// Interpolated colours have a slack besides, from raster/primitives.h, whose steps keep 7 fraction bits: 15 pixels *
// 2^-8 + 2^-7. That texture coordinates are cut to 1/256 texel is none of this: nudges show it (compare_frame.cpp).
#pragma once

#include "pipeline/frame/frame.h"

namespace peers {

// How far a fragment of this pass may be from the same in exact arithmetic, in units, before it is blended: colour
// and alpha.
struct FragmentError {
    double color = 0.0, alpha = 0.0;
};
// `interpolation`: what else the colours and the fog of triangles may be off by, before the stages.
FragmentError fragment_error(const pipeline::Pass& pass, double interpolation = 0.0);

// The greatest difference of a channel that the pass may make at a pixel which this many fragments reach.
//   One layer: Fs * source + Fd * dest is rounded here. llvmpipe blends bytes: it rounds the source, and each product
//   whose factor is not 0 or 1. dest is the same at first.
//   More: what a layer leaves is the next one's dest, which Fd <= 1 does not make worse.
// Where the factors are x and 1 - x, source and dest share the weight, so of their errors only the larger counts.
int allowed_difference(const pipeline::Pass& pass, const FragmentError& error, int layers);

}  // namespace peers
