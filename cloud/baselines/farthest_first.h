// SPDX-License-Identifier: MIT
// The order in which clouds are blended over each other, and that of what a cloud is made of.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "cloud/cloud.h"

namespace cloud {

// Distance from the eye to the nearest particle's surface, below 0 within one; infinite for a cloud without any.
float nearest_particle_m(const Cloud& cloud, Vec3 eye);

// Indices by falling distance; equal ones in the order given.
std::vector<std::size_t> farthest_first(std::span<const float> distances);

}  // namespace cloud
