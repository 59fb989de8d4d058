// SPDX-License-Identifier: MIT
// M10: what bounds a good look: a rough outline, light and shade, shadows with colour, no seams between spheres.
#pragma once

#include <optional>

#include "demo/metrics/plane.h"

namespace demo {

// Pixels of at least `level` beside one below it.
Mask contour_of(const Plane& plane, float level);

// Box-counting dimension: the slope of log(boxes that hold a marked pixel) over log(1 / size), for boxes of 2, 4, 8, 16
// and 32 pixels, each count a mean over 16 places of their grid. 1: a smooth line; none with fewer than 64 pixels.
std::optional<double> box_dimension(const Mask& mask);

// Over marked pixels. tone: the 95th percentile of luminance over the 5th. saturation_*: mean (max - min) / max of RGB
// in the darkest and the lightest quarter.
struct Tones {
    double tone = 1.0, saturation_dark = 0.0, saturation_light = 0.0;
};
std::optional<Tones> tones_of(const ColorPlane& picture, const Mask& where);

// Mean slope of the luminance at the marked seams over that at other pixels of `where`.
std::optional<double> crease_index(const Plane& luminance, const Mask& seams, const Mask& where);

}  // namespace demo
