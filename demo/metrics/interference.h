// SPDX-License-Identifier: MIT
// M9: do several clouds in a picture leave each other alone? The picture is compared with clouds drawn one by one and
// laid over each other in float, farthest first.
#pragma once

#include <vector>

#include "demo/metrics/plane.h"

namespace demo {

// A cloud by itself over black, and its coverage.
struct Layer {
    ColorPlane over_black;
    Plane coverage;
};

// over_black + (1 - coverage) picture, in place.
void lay_over(ColorPlane& picture, const Layer& layer);

// Pixels that at least two of them cover by more than 0.02.
Mask overlaps_of(const std::vector<Layer>& layers);

// Root of the mean square over channels and marked pixels, 0..1.
double color_rms(const ColorPlane& a, const ColorPlane& b, const Mask& where);

}  // namespace demo
