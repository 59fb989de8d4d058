// SPDX-License-Identifier: MIT
// The cores of a cumulus for who does not want to place them: large particles on a flat base, higher towards the middle
// and with a tower or two, for cloud::grow (generate.h) to grow smaller ones on.
#pragma once

#include <cstdint>
#include <vector>

#include "cloud/cloud.h"

namespace cloud {

// size: of the whole in metres: width along x, height above the base, depth along z. flatness: 0 a heap as high as size
// says all over, 1 a dome that falls to a quarter of the height at its rim. The base is meant to lie at y = 0 (Cloud::base_y), its middle at x = z
// = 0. seed: of all places and sizes.
struct CumulusShape {
    Vec3 size          = Vec3(80.0f, 40.0f, 50.0f);
    float flatness     = 0.6f;
    std::uint32_t seed = 1;
};

std::vector<Particle> cumulus_cores(const CumulusShape& shape);

}  // namespace cloud
