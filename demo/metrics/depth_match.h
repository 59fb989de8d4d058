// SPDX-License-Identifier: MIT
// M2: does the scene hide the cloud where it is nearer, and only there? Away from the edges of the spheres' own
// silhouette, as the depth buffer cuts it, coverage must be what the spheres' alpha is.
#pragma once

#include "demo/metrics/plane.h"

namespace demo {

// Pixels farther than `clear_px` from every edge of the silhouette: within it, and around it up to four times as far.
Mask away_from_edges(const Plane& shape, double clear_px);

// Mean |coverage - shape| over the marked pixels; 0 without any.
double mean_difference(const Plane& coverage, const Plane& shape, const Mask& where);

}  // namespace demo
