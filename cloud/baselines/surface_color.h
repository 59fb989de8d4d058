// SPDX-License-Identifier: MIT
// The colour of a cloud where a particle has the given light.
#pragma once

#include <glm/geometric.hpp>

#include "cloud/cloud.h"

namespace cloud {

// Light times colour, plus glow; of a cloud with a tint, its brightness in that colour.
inline Vec3 surface_color(const Cloud& cloud, const Particle& particle, Vec3 light) {
    const Vec3 color = light * particle.color + particle.glow;
    return cloud.tint ? *cloud.tint * glm::dot(color, Vec3(0.299f, 0.587f, 0.114f)) : color;
}

}  // namespace cloud
