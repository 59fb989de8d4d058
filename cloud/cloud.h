// SPDX-License-Identifier: MIT
// What a cloud is, before any technique draws it: lengths in metres, y up, colours linear factors 0..1.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/frame/frame.h"

namespace cloud {

using pipeline::Mat4;
using pipeline::Vec2;
using pipeline::Vec3;
using pipeline::Vec4;
using Mat3 = glm::mat3;

// A mega-particle: one large lit sphere, or the ellipsoid that `shape` makes of it; its determinant is above 0. alpha: of
// its surface; the nearest particle's alone counts, for it replaces what is behind it. At 0 it is not there. glow: light
// of its own, added to what falls on it. generation: 0 core, 1 crown, 2 rim.
struct Particle {
    Vec3 center    = Vec3(0.0f);
    float radius   = 1.0f;
    Vec3 color     = Vec3(1.0f);
    float alpha    = 1.0f;
    int generation = 0;
    Mat3 shape     = Mat3(1.0f);
    Vec3 glow      = Vec3(0.0f);
};

// A light within the cloud or close to it: fire below, lightning inside. It reaches `range` metres, through the cloud:
// color (1 - (d / range)^2)^2 (0.7 + 0.3 N.L).
struct InnerLight {
    Vec3 center = Vec3(0.0f);
    Vec3 color  = Vec3(0.0f);
    float range = 1.0f;
};

// The light a cloud stands in. to_sun: unit vector towards the sun.
struct Daylight {
    Vec3 to_sun = Vec3(0.5025f, 0.7035f, 0.5025f);
    Vec3 sun    = Vec3(0.70f, 0.679f, 0.63f);
    Vec3 sky    = Vec3(0.248f, 0.30f, 0.40f);
    Vec3 bounce = Vec3(0.11f, 0.085f, 0.06f);
};

// Where the colour beside a particle comes from, which the blur mixes into the cloud's rim, and so how the fractal can
// act on it. With K the cloud's colour, S the scene's, a the blurred alpha, the rim becomes
//   Skirt          a K + (1 - a) S: inflated spheres spread the cloud's own colour, and the fractal box erodes the alpha
//   Article        a^2 K + a (1 - a) S' + (1 - a) S: a copy of the scene, which is blurred with the cloud (S'); the box
//                  multiplies alpha. ShaderX5 5.3 to the letter.
//   Premultiplied  a K + (1 - a) S: black, and the composite takes the colour as it is; the box multiplies colour too
//   Black          a^2 K + (1 - a) S: black under the article's composite; the dark halo that a scene copy avoids
enum class Mode : std::uint8_t { Skirt, Article, Premultiplied, Black };

// What gives the rim its detail. Fractal: the box's alpha, as the mode says. Displacement: every pixel of the finished
// cloud is looked up a little aside, by the article's second variant; a grid that is warped vertex by vertex stands for
// environment bump mapping. None leaves the blur as it is.
enum class Detail : std::uint8_t { Fractal, Displacement, None };

// The composite is right for what has been drawn before the cloud. InOrder: what stands in front comes after it.
// OrderFree: all the scene may be there already; a bit of the back buffer's alpha keeps the rim off what is nearer.
enum class Order : std::uint8_t { InOrder, OrderFree };

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

// An upright box in the world, to be turned about its vertical axis by (cosine, sine) of an angle.
struct Box {
    Vec3 low = Vec3(0.0f), high = Vec3(0.0f);
    bool operator==(const Box&) const = default;
};
using Turn = Vec2;

struct Cloud {
    std::string name = "cloud";
    std::vector<Particle> particles;
    Mode mode     = Mode::Skirt;
    Detail detail = Detail::Fractal;
    Order order   = Order::InOrder;
    float base_y  = -1e9f;  // below it particles are squashed to a flat base
    float blur_m  = 1.6f;   // standard deviation of the blur
    float opacity = 1.0f;   // constant translucency of the composite
    float dissolve =
        0.0f;  // 0..1: Skirt with a fractal: taken from the blurred alpha before it acts; else all fades evenly
    float absorption    = 1.0f;  // of sunlight on its way through; 1 leaves a quarter behind a core's diameter
    float silver_lining = 0.0f;  // of the thin parts before the sun, over the sun's own light (silver_lining.h)
    Fractal fractal;
    float lumpiness    = 0.06f;  // greatest displacement of a particle's surface, over its radius
    float displacement = 1.2f;   // of Detail::Displacement: the greatest, in standard deviations of the blur
    // One channel is enough for a grey cloud: particles are drawn in grey, and the composite gives them this colour (in
    // Article mode, whose blur holds the scene too, the particles have it from the start).
    std::optional<Vec3> tint;
    std::vector<InnerLight> lights;
    // The box that the fractal is wrapped around. Absent: the particles' own; a cloud whose particles move needs one
    // that stays. A box that turns makes the detail move; a second one, if there is one, acts after the first.
    std::optional<Box> box;
    std::optional<Turn> box_turn, second_box_turn;
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
