// SPDX-License-Identifier: MIT
// What a cloud is, before any technique draws it: lengths in metres, y up, colours linear factors 0..1.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/frame/frame.h"

namespace cloud {

using pipeline::Mat4;
using pipeline::Vec2;
using pipeline::Vec3;
using pipeline::Vec4;

// A mega-particle: one large lit sphere. generation: 0 core, 1 crown, 2 rim.
struct Particle {
    Vec3 center    = Vec3(0.0f);
    float radius   = 1.0f;
    Vec3 color     = Vec3(1.0f);
    float alpha    = 1.0f;
    int generation = 0;
};

// The light a cloud stands in. to_sun: unit vector towards the sun.
struct Daylight {
    Vec3 to_sun = Vec3(0.5025f, 0.7035f, 0.5025f);
    Vec3 sun    = Vec3(0.70f, 0.679f, 0.63f);
    Vec3 sky    = Vec3(0.248f, 0.30f, 0.40f);
    Vec3 bounce = Vec3(0.11f, 0.085f, 0.06f);
};

// Skirt: inflated spheres spread the cloud's colour past its rim, and the fractal box erodes the blurred alpha while it
// composites. Article: ShaderX5 5.3 to the letter: scene copy, alpha multiplied by the fractal box, full composite.
enum class Mode : std::uint8_t { Skirt, Article };

// fBm for cumulus, billow (its folds) for cauliflower tops.
enum class Noise : std::uint8_t { Fbm, Billow };

// A seamless fractal over the six faces of the box around a cloud.
struct Fractal {
    int face_size      = 256;  // texels; a power of two
    int octaves        = 5;
    float gain         = 0.5f;  // amplitude of an octave over that of the one before
    float cycles       = 5.0f;  // of the first octave, along the box's longest edge
    std::uint32_t seed = 1;
    Noise noise        = Noise::Fbm;
};

struct Cloud {
    std::string name = "cloud";
    std::vector<Particle> particles;
    Mode mode        = Mode::Skirt;
    float base_y     = -1e9f;  // below it particles are squashed to a flat base
    float blur_m     = 1.6f;   // standard deviation of the blur
    float opacity    = 1.0f;   // constant translucency of the composite
    float absorption = 1.0f;   // of sunlight on its way through; 1 leaves a quarter behind a core's diameter
    Fractal fractal;
    float lumpiness = 0.06f;  // greatest displacement of a particle's surface, over its radius
};

// The camera of the picture. eye: where it stands in the world. view, projection: those of the frame's camera, the
// projection a perspective one, with w growing in metres ahead of the eye. width, height: of the back buffer, in
// pixels. near_m: distance of the near plane.
struct View {
    Vec3 eye        = Vec3(0.0f);
    Mat4 view       = Mat4(1.0f);
    Mat4 projection = Mat4(1.0f);
    int width = 0, height = 0;
    float near_m = 0.5f;
};

}  // namespace cloud
