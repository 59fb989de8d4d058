// SPDX-License-Identifier: MIT
// M6: does the fractal's detail stay on the cloud when the camera moves, or on the screen, like dirt on a shower door?
// The detail is the difference that the fractal makes to coverage. Of two pictures, it is compared at the points of the
// cloud, and at the same pixels.
#pragma once

#include "demo/metrics/plane.h"
#include "pipeline/frame/frame.h"

namespace demo {

// For each pixel how far the point that is seen there moves on the screen, right and down, from one camera to the
// next; depth_m: its distance ahead of the first eye, finite.
Grid<Vec2> camera_flow(const Plane& depth_m, const pipeline::Camera& before, const pipeline::Camera& after);

// Correlation of the detail, over the marked pixels of the first picture, with that at the place the flow leads to, and
// with that at the same pixel. What leaves the picture is left out.
struct Swim {
    double on_object = 0.0, on_screen = 0.0;
};
Swim swim(const Plane& detail_before, const Plane& detail_after, const Grid<Vec2>& flow, const Mask& where);

// Each infinite value replaced by the finite one that is nearest on the screen.
Plane without_holes(const Plane& depth_m);

}  // namespace demo
