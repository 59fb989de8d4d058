// SPDX-License-Identifier: MIT
// M1: how sharply a cloud is cut off where it meets the scene. Edges are looked for in what the scene leaves of the
// cloud, coverage with the scene over coverage without, so that the cloud's own outline does not count, and each
// technique is judged at its own edges.
#pragma once

#include <optional>

#include "demo/metrics/plane.h"

namespace demo {

// coverage / alone; not a number where alone is below 1/2.
Plane share_left(const Plane& coverage, const Plane& alone);

// Pixels that change fastest along their gradient, and there by more than `least` per pixel.
Mask ridges_of(const Plane& plane, float least);

// Pixels between 10 % and 90 % of the drop through (x, y) along the gradient, which is followed as long as it falls, at
// most `reach` pixels either way; none where less than `least_drop` is lost. A step from pixel to pixel is 0.8 wide.
std::optional<double> edge_width(const Plane& plane, int x, int y, double reach, float least_drop);

// Does the plane change by at least 0.05 from a pixel to the next across (x, y), along the gradient, and two pixels
// before and after by less than a third of that? So does a cut through one layer of many, whose whole edge is wide. A
// Gaussian edge with a sigma of 1.4 pixels or more has no such step. None where the profile leaves the cloud.
std::optional<bool> is_hard_step(const Plane& plane, int x, int y);

}  // namespace demo
