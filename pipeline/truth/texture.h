// SPDX-License-Identifier: MIT
// What a stage reads of its texture. Weights and fractions are exact; the rest follows raster/sampling_rules.h, and
// pipeline/truth/truth.h says what the samples of a target are to each other.
#pragma once

#include "pipeline/truth/samples.h"

namespace pipeline::truth {

// Where a sample reads a texture: 0..1 spans it. `center_`: where the pixel reads it. `ux` to `vy`: how much (u, v) changes from
// pixel to pixel along x and y.
struct TexturePoint {
    double u = 0.0, v = 0.0;
    double center_u = 0.0, center_v = 0.0;
    double ux = 0.0, vx = 0.0, uy = 0.0, vy = 0.0;
};

// What a draw binds to a stage. With neither, white.
struct BoundTexture {
    const Texture* texture = nullptr;
    const Samples* target  = nullptr;
};

Color read(const BoundTexture& bound, const TextureStage& stage, const TexturePoint& point);

// A target by Linear, in texels: the point that the pixel reads, and how far from it the sample does.
Color read_linear(const Samples& target, TextureAddress address_u, TextureAddress address_v, double u, double v,
                  double from_u, double from_v);

}  // namespace pipeline::truth
