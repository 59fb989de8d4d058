// SPDX-License-Identifier: MIT
// The box around a cloud, textured with its fractal. It is seen through the scene's camera, so that the detail it gives
// to the blurred alpha is three-dimensional, and moves with the cloud when the camera orbits.
#pragma once

#include "cloud/mega_particles/cloud_draw.h"

namespace cloud {

// Of the other modes: multiplies the alpha of `into` by the fractal, or all of it if the cloud is premultiplied.
void append_multiplying_box(const CloudDraw& draw, pipeline::TargetId into, const std::optional<Turn>& turn);

// Of skirt mode: `into` gets `from`, eroded. With n the fractal, a the blurred alpha and d what dissolves, alpha = 2 (a -
// d) + n - 1, clamped: at d = 0 what is opaque stays so, what is empty stays empty, and the rim moves by about 0.7 sigma
// either way. `from`, of the back buffer's size, is read at each pixel's own texel by coordinates projected from the
// camera (the particles' target at a smaller scale is enlarged bilinearly), and the box's sides hide each other: onto the back buffer this blends the cloud in a single layer.
struct Erosion {
    pipeline::TargetId from, into;
    std::optional<Turn> turn;
    bool is_first = true;  // of a cloud's: it tints and dissolves
};
void append_eroding_box(const CloudDraw& draw, const Erosion& erosion);

// The textures of a cloud, added to its frame.
FractalTextures append_fractal(pipeline::Frame& frame, const BakedCloud& baked);

// (u, v) of a target that covers the screen, from a position in camera space: the stage transform for CAMERAPOSITION.
Mat4 screen_coordinates(const Mat4& projection);

}  // namespace cloud
