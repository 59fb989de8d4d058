// SPDX-License-Identifier: MIT
// M7: is the rim a mix of the cloud's and the scene's colour, and nothing else? Where other colours were blurred in, it
// is darker or lighter than any mix.
#pragma once

#include "demo/metrics/plane.h"

namespace demo {

// distance: mean RGB distance from the picture to the straight line between the scene's and the cloud's colour.
// luminance_error: mean of the picture's luminance less that of a cloud + (1 - a) scene. Both over the marked pixels,
// colours 0..1.
struct Halo {
    double distance = 0.0, luminance_error = 0.0;
};
Halo halo(const ColorPlane& picture, const ColorPlane& scene, const ColorPlane& cloud, const Plane& coverage,
          const Mask& where);

}  // namespace demo
