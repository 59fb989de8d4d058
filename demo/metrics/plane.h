// SPDX-License-Identifier: MIT
// From pictures to what is measured in them, and the few operations that the measures share. Colours and alpha 0..1.
#pragma once

#include "demo/metrics/grid.h"
#include "pipeline/execute/execute.h"

namespace demo {

using pipeline::Vec2;
using pipeline::Vec3;

// How much of each pixel a cloud covers: of a picture over black and the same over white, 1 - mean_rgb(white - black).
Plane coverage_of(const pipeline::ColorImage& white, const pipeline::ColorImage& black);

ColorPlane colors_of(const pipeline::ColorImage& image);
Plane alpha_of(const pipeline::ColorImage& image);

// 0.299 R + 0.587 G + 0.114 B.
float luminance(Vec3 color);
Plane luminance_of(const ColorPlane& colors);

// Bilinear between pixel centres; the border pixels go on outside.
float sample(const Plane& plane, float x, float y);

// Change per pixel, by central differences.
Vec2 gradient(const Plane& plane, int x, int y);

// By a Gaussian of the given standard deviation in pixels, cut off at three of them; the border pixels go on outside.
Plane smoothed(const Plane& plane, double sigma_px);

// Pixels that differ from a right or lower neighbour by more than `step`, and these neighbours.
Mask edges_of(const Plane& plane, float step);

// For each pixel the marked one that is nearest, and how far it is in pixels; index and distance are -1 and infinite
// where none is marked. Exact (Felzenszwalb and Huttenlocher, "Distance Transforms of Sampled Functions", 2004).
struct Nearest {
    Grid<int> index;
    Plane distance;
};
Nearest nearest_marked(const Mask& mask);

// The soft rim: 0.02 < coverage < 0.98.
Mask rim_of(const Plane& coverage);

}  // namespace demo
