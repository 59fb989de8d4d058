// SPDX-License-Identifier: MIT
#include "cloud/merge.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string_view>
#include <tuple>
#include <utility>

#include "cloud/bounds.h"

namespace cloud {
namespace {

// All that decides how the passes are written, but for the particles.
bool drawn_alike(const Cloud& a, const Cloud& b) {
    return a.mode == b.mode && a.detail == b.detail && a.order == b.order && a.base_y == b.base_y &&
           a.blur_m == b.blur_m && a.opacity == b.opacity && a.dissolve == b.dissolve && a.lumpiness == b.lumpiness &&
           a.displacement == b.displacement && a.silver_lining == b.silver_lining && a.tint == b.tint &&
           a.box_turn == b.box_turn && a.second_box_turn == b.second_box_turn;
}

// Most particles first; equal ones by name and place.
bool comes_first(const BakedCloud& a, const BakedCloud& b) {
    const auto key = [](const BakedCloud& baked) {
        const Vec3 low = baked.lit.low;
        return std::tuple(-static_cast<std::ptrdiff_t>(baked.cloud.particles.size()),
                          std::string_view(baked.cloud.name), low.x, low.y, low.z);
    };
    return key(a) < key(b);
}

Box hull(const Box& a, const Box& b) {
    return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

void append(BakedCloud& to, const BakedCloud& from) {
    const auto share = static_cast<float>(from.lit.vertices.size()) /
                       static_cast<float>(to.lit.vertices.size() + from.lit.vertices.size());
    to.lit.mean_color = glm::mix(to.lit.mean_color, from.lit.mean_color, share);
    if (to.cloud.box || from.cloud.box)
        to.cloud.box = hull(fractal_box(to.cloud, to.lit), fractal_box(from.cloud, from.lit));
    to.lit.low  = glm::min(to.lit.low, from.lit.low);
    to.lit.high = glm::max(to.lit.high, from.lit.high);
    to.lit.vertices.append(from.lit.vertices);
    to.cloud.particles.insert(to.cloud.particles.end(), from.cloud.particles.begin(), from.cloud.particles.end());
    to.cloud.lights.insert(to.cloud.lights.end(), from.cloud.lights.begin(), from.cloud.lights.end());
}

}  // namespace

bool touch(const BakedCloud& a, const BakedCloud& b) {
    if (glm::any(glm::greaterThan(a.lit.low, b.lit.high)) || glm::any(glm::greaterThan(b.lit.low, a.lit.high)))
        return false;
    for (const Particle& p : a.cloud.particles)
        for (const Particle& q : b.cloud.particles)
            if (glm::length(p.center - q.center) < greatest_radius(p) + greatest_radius(q)) return true;
    return false;
}

std::vector<BakedCloud> merge_touching(std::vector<BakedCloud> clouds) {
    std::stable_sort(clouds.begin(), clouds.end(), comes_first);
    for (std::size_t i = 0; i < clouds.size(); ++i) {
        const auto joins = [&](const BakedCloud& other) {
            return drawn_alike(clouds[i].cloud, other.cloud) && touch(clouds[i], other);
        };
        // What has joined may touch those that stood apart.
        for (std::size_t j = i + 1; j < clouds.size();) {
            if (!joins(clouds[j])) {
                ++j;
                continue;
            }
            append(clouds[i], clouds[j]);
            clouds.erase(clouds.begin() + static_cast<std::ptrdiff_t>(j));
            j = i + 1;
        }
    }
    return clouds;
}

}  // namespace cloud
