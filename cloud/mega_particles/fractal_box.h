// SPDX-License-Identifier: MIT
// The box around a cloud, textured with its fractal. It is seen through the scene's camera, so that the detail it gives
// to the blurred alpha is three-dimensional, and moves with the cloud when the camera orbits.
#pragma once

#include "cloud/mega_particles/cloud_draw.h"

namespace cloud {

// Multiplies the alpha of `into` by the fractal, or all of it if the cloud is premultiplied.
void append_multiplying_box(const CloudDraw& draw, pipeline::TargetId into, const std::optional<Turn>& turn);

// Of skirt mode: writes the particles' target, eroded, to `into`. With n the fractal, a the blurred alpha and d what
// dissolves, alpha = 2 (a - d) + n - 1, clamped: at d = 0 what is opaque stays so, what is empty stays empty, and the
// rim moves by about 0.7 sigma either way. The target is read at each pixel's own texel by coordinates projected from
// the camera, and the box's sides hide each other: onto the back buffer this blends the cloud in a single layer.
void append_eroding_box(const CloudDraw& draw, pipeline::TargetId into);

// Both texture stages are taken: constant opacity and a second box need the cloud in a target of its own first.
bool erodes_and_composites_at_once(const Cloud& cloud);

// The textures of a cloud, added to its frame.
FractalTextures append_fractal(pipeline::Frame& frame, const BakedCloud& baked);

// (u, v) of a target that covers the screen, from a position in camera space: the stage transform for CAMERAPOSITION.
Mat4 screen_coordinates(const Mat4& projection);

}  // namespace cloud
