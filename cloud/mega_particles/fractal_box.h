// SPDX-License-Identifier: MIT
// The box around a cloud, textured with its fractal. It is seen through the scene's camera, so that the detail it gives
// to the blurred alpha is three-dimensional, and moves with the cloud when the camera orbits.
#pragma once

#include "cloud/mega_particles/cloud_draw.h"

namespace cloud {

// Article: multiplies the alpha of the particles' target by the fractal, and changes nothing else.
void append_multiplying_box(const CloudDraw& draw);

// Skirt: writes the particles' target, eroded, over `into`. With n the fractal and a the blurred alpha, alpha = 2a + n
// - 1, clamped: what is opaque stays so, what is empty stays empty, and the rim moves by about 0.7 sigma either way.
// The target is read at each pixel's own texel by coordinates projected from the camera, and the box's sides hide each
// other, so this blends the cloud over the back buffer in a single layer.
void append_eroding_box(const CloudDraw& draw, pipeline::TargetId into, pipeline::BlendState blend);

// (u, v) of a target that covers the screen, from a position in camera space: the stage transform for CAMERAPOSITION.
Mat4 screen_coordinates(const Mat4& projection);

}  // namespace cloud
