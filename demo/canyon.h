// SPDX-License-Identifier: MIT
// The landscape of a desert canyon, as heights: a floor with dry washes and ledges, buttes and mesas of layered rock
// around it, and a stepped rim far out. All walls are cut from the same horizontal layers, as in nature: a hard layer
// stands as a cliff, a soft one lies as a slope or a bench. In the middle lies open floor, with a mesa north of it
// (towards -z).
#pragma once

#include <cstdint>

namespace demo {

struct CanyonShape {
    float size_m       = 3200.0f;  // of the whole, which scales the layout
    float height_m     = 165.0f;   // of the highest rim above the floor
    std::uint32_t seed = 1;        // of all that is irregular; the layout stays
};

// Height above the floor's mean at (x, z) metres from the middle; about -6 .. height_m + 6.
float canyon_height(const CanyonShape& shape, float x, float z);

// 1 in the bed of a dry wash, 0 away from it. Where a wall has buried the wash it still says so.
float canyon_wash(const CanyonShape& shape, float x, float z);

}  // namespace demo
