// SPDX-License-Identifier: MIT
#include "cloud/cumulus.h"

#include <algorithm>
#include <cmath>

namespace cloud {
namespace {

// 0..1, another value for each number.
float hash_share(std::uint32_t number, std::uint32_t seed) {
    std::uint32_t h = number * 0x9e3779b9u + seed * 0x85ebca6bu;
    h               = (h ^ (h >> 16)) * 0x7feb352du;
    h               = (h ^ (h >> 15)) * 0x846ca68bu;
    h ^= h >> 16;
    return static_cast<float>(h >> 8) / 16777216.0f;
}

}  // namespace

std::vector<Particle> cumulus_cores(const CumulusShape& shape) {
    // A sunflower of places: turned by the golden angle each, evenly spread over a disc that the size makes an ellipse.
    constexpr float kCosine = -0.73736888f, kSine = 0.67549029f;
    const Vec3 half    = Vec3(shape.size.x, 0.0f, shape.size.z) * 0.5f;
    const float narrow = std::min({half.x, half.z, shape.size.y});
    const float usual  = std::max(0.42f * narrow, 0.18f * std::max(half.x, half.z));  // radius of a core
    const float area   = half.x * half.z / (usual * usual);
    const int count    = std::clamp(static_cast<int>(1.7f * area), 3, 64);
    std::vector<Particle> cores;
    const auto add = [&](float x, float y, float z, float radius) {
        // Nothing above the top that was asked for, nor beyond the sides.
        y = std::max(std::min(y, shape.size.y - radius), 0.35f * radius);
        x = std::clamp(x, -std::max(half.x - radius, 0.0f), std::max(half.x - radius, 0.0f));
        z = std::clamp(z, -std::max(half.z - radius, 0.0f), std::max(half.z - radius, 0.0f));
        cores.push_back({.center = Vec3(x, y, z), .radius = radius});
    };
    float x = 1.0f, z = 0.0f;
    for (int i = 0; i < count; ++i) {
        const auto number    = static_cast<std::uint32_t>(i);
        const float from_mid = std::sqrt((static_cast<float>(i) + 0.5f) / static_cast<float>(count));
        const float turned   = x * kCosine - z * kSine;
        z                    = z * kCosine + x * kSine;
        x                    = turned;
        const float dome     = 1.0f - 0.75f * shape.flatness * from_mid * from_mid;
        const float share    = hash_share(3 * number, shape.seed);
        const float top      = shape.size.y * dome * (0.5f + 0.5f * share * share);  // few are high
        const float radius =
            std::min(usual * (1.15f - 0.5f * from_mid) * (0.8f + 0.4f * hash_share(3 * number + 1, shape.seed)),
                     0.5f * shape.size.y);
        const float place = from_mid * (0.9f + 0.2f * hash_share(3 * number + 2, shape.seed));
        const float px = x * place * (half.x - 0.6f * radius), pz = z * place * (half.z - 0.6f * radius);
        add(px, 0.4f * radius, pz, radius);
        // A tower: what the top still lacks, narrower upwards and leaning.
        float y = 0.4f * radius, r = radius, lean_x = px, lean_z = pz;
        while (y + r < top && r > 0.3f * radius && cores.size() < 256) {
            const auto floor = static_cast<std::uint32_t>(cores.size());
            y += 0.62f * r;
            r *= 0.88f;
            lean_x += 0.55f * r * (2.0f * hash_share(floor, shape.seed + 1) - 1.0f);
            lean_z += 0.55f * r * (2.0f * hash_share(floor, shape.seed + 2) - 1.0f);
            add(lean_x, y, lean_z, r);
        }
    }
    return cores;
}

}  // namespace cloud
