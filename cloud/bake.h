// SPDX-License-Identifier: MIT
// All of a cloud that does not depend on the camera: lit vertices and the fractal. Bake once, draw from many places.
// What moves is lit again with every frame; its fractal stays.
#pragma once

#include <memory>

#include "cloud/cloud.h"
#include "cloud/for_each.h"
#include "cloud/fractal.h"
#include "cloud/vertex_light.h"

namespace cloud {

struct BakedCloud {
    Cloud cloud;
    Daylight daylight;
    LitParticles lit;
    std::shared_ptr<const FractalFaces> fractal;  // null without particles and without a box of its own
};

// The box around the particles, or the cloud's own. Where a box turns, both are as deep as wide, and so wide that the
// cloud stays inside.
Box fractal_box(const Cloud& cloud, const LitParticles& lit);

// Throws std::invalid_argument where a number of the cloud makes no sense: not finite, a radius of 0, a face that is
// not a power of two, and so on.
BakedCloud bake(const Cloud& cloud, const Daylight& daylight, const ForEach& for_each = one_by_one);

// The same with the fractal of another bake, for which the cloud's fractal, its box's size and its mode must have been the same.
BakedCloud bake(const Cloud& cloud, const Daylight& daylight, const BakedCloud& before,
                const ForEach& for_each = one_by_one);

}  // namespace cloud
