// SPDX-License-Identifier: MIT
// M3: the soft edge climbs what reaches into the cloud, and must not lie over what stands before it.
#pragma once

#include <optional>
#include <vector>

#include "demo/metrics/plane.h"

namespace demo {

// A pixel of a sphere beside one where the scene has cut it; out: unit direction, away from the sphere.
struct CutPoint {
    int x = 0, y = 0;
    Vec2 out = Vec2(0.0f);
};

// Where the scene cuts spheres, not merely hides them: there both are equally far, to gap_m. For `straight_px` to both
// sides there is sphere and no sphere, so that the cut is like a straight one. Planes: demo::Anatomy.
std::vector<CutPoint> cut_points(const Plane& shape, const Plane& shape_alone, const Plane& scene_m,
                                 const Plane& shape_m, float gap_m, double straight_px);

// From coverage 0.9 to 0.1 across a cut, looked for up to `reach` pixels to either side; none where it does not get
// there. monotone: never rises between, but for a byte's step.
struct Climb {
    double width_px = 0.0;
    bool monotone   = true;
};
std::optional<Climb> climb_at(const Plane& coverage, const CutPoint& point, double reach);

// Sum of the coverage of marked pixels, over the length of their border with others that are covered (above 0.02), in
// pixels; none where no covered pixel borders on them.
std::optional<double> leak(const Plane& coverage, const Mask& nearer);

}  // namespace demo
