// SPDX-License-Identifier: MIT
// All of a cloud that does not depend on the camera: lit vertices and the fractal. Bake once, draw from many places.
#pragma once

#include "cloud/cloud.h"
#include "cloud/fractal.h"
#include "cloud/vertex_light.h"

namespace cloud {

struct BakedCloud {
    Cloud cloud;
    Daylight daylight;
    LitParticles lit;
    FractalFaces fractal;
};

// Throws std::invalid_argument where a number of the cloud makes no sense: not finite, a radius of 0, a face that is
// not a power of two, and so on.
BakedCloud bake(const Cloud& cloud, const Daylight& daylight);

}  // namespace cloud
