// SPDX-License-Identifier: MIT
// The landscape of a desert canyon, as heights: a floor with dry washes and ledges, buttes and mesas of layered rock
// around it, and a stepped rim far out. All walls are cut from the same horizontal layers, as in nature: a hard layer
// stands as a cliff, a soft one lies as a slope or a bench. In the middle lies open floor, with a mesa north of it
// (towards -z).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "demo/noise.h"

namespace demo {

struct CanyonShape {
    float size_m       = 3200.0f;  // of the whole, which scales the layout
    float height_m     = 165.0f;   // of the highest rim above the floor
    std::uint32_t seed = 1;        // of all that is irregular; the layout stays
};

// Heights above the floor's mean at the points of a grid, row by row; about -6 .. height_m + 6. x, z: metres from the
// middle.
class CanyonHeights {
  public:
    CanyonHeights(const CanyonShape& shape, std::span<const float> x);
    // Sets one height for each of the columns.
    void row(float z, std::span<float> heights) const;

  private:
    // The landscape's columns over the length of a feature, for its noise.
    NoiseGrid noise_of(float length_m, int octaves = 1, float shift = 0.0f) const;

    float scale_, height_scale_;
    std::uint32_t seed_;
    std::vector<float> x_;  // of the layout
    NoiseGrid wander_, buttresses_, clefts_, bays_, scree_, swell_, stones_, sand_, wash_, wash_edge_;
};

// The same at one point.
float canyon_height(const CanyonShape& shape, float x, float z);

// 1 in the bed of a dry wash, 0 away from it. Where a wall has buried the wash it still says so.
float canyon_wash(const CanyonShape& shape, float x, float z);

}  // namespace demo
