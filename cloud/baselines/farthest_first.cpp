// SPDX-License-Identifier: MIT
#include "cloud/baselines/farthest_first.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

#include "cloud/bounds.h"

namespace cloud {

float nearest_particle_m(const Cloud& cloud, Vec3 eye) {
    float nearest = std::numeric_limits<float>::infinity();
    for (const Particle& particle : cloud.particles)
        nearest = std::min(nearest, glm::length(particle.center - eye) - greatest_radius(particle));
    return nearest;
}

std::vector<std::size_t> farthest_first(std::span<const float> distances) {
    std::vector<std::size_t> order(distances.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return distances[a] > distances[b]; });
    return order;
}

}  // namespace cloud
