// SPDX-License-Identifier: MIT
#include "demo/sky.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "demo/noise.h"
#include "demo/texture_pyramid.h"
#include "demo/trigonometry.h"

namespace demo {

Vec3 sky_color(const Sky& sky, const Vec3& to_sun, const Vec3& direction) {
    // The air's thickness falls off steeply above the horizon: (1 - sin e)^3, and a thin bright band of (1 - sin e)^16.
    const float up    = std::clamp(direction.y, 0.0f, 1.0f);
    const float thin  = (1.0f - up) * (1.0f - up);
    const float haze  = thin * (1.0f - up);
    const float four  = thin * thin;
    const float band  = four * four * four * four;
    const float share = std::min(0.86f * haze + 0.14f * band, 1.0f);
    Vec3 color        = sky.zenith + (sky.horizon - sky.zenith) * share;

    const float toward = 0.5f + 0.5f * glm::dot(direction, to_sun);  // 1 at the sun
    const float t2     = toward * toward;
    const float t8     = t2 * t2 * t2 * t2;
    const float t64    = t8 * t8 * t8 * t8 * t8 * t8 * t8 * t8;
    color += sky.glow * (0.45f * t8 + 1.2f * t64) * smooth_step(0.0f, 0.12f, direction.y);
    return color;
}

TexturedRange append_sky_dome(SceneGeometry& geometry, const Sky& sky, const Vec3& to_sun) {
    constexpr int kSides     = 72;
    // Sines of elevation: close together where the colour changes fast.
    constexpr float kRings[] = {-1.0f, -0.05f, 0.0f,   0.008f, 0.018f, 0.03f, 0.045f, 0.065f,
                                0.09f, 0.12f,  0.155f, 0.195f, 0.24f,  0.29f, 0.35f,  0.42f,
                                0.5f,  0.58f,  0.67f,  0.76f,  0.85f,  0.93f, 0.98f,  1.0f};
    const auto first_vertex  = static_cast<std::uint32_t>(geometry.vertices.size());
    const auto first_index   = static_cast<std::uint32_t>(geometry.indices.size());
    Vec2 azimuths[kSides + 1];
    for (int side = 0; side <= kSides; ++side) {
        const double angle = 2.0 * kPi * (side % kSides) / kSides;
        azimuths[side]     = {static_cast<float>(cosine(angle)), static_cast<float>(sine(angle))};
    }
    for (const float elevation : kRings) {
        const float level = std::sqrt(1.0f - elevation * elevation);
        for (const Vec2& azimuth : azimuths) {
            const Vec3 direction(level * azimuth.x, elevation, level * azimuth.y);
            pipeline::Vertex vertex;
            vertex.position = direction;
            vertex.normal   = -direction;
            vertex.diffuse  = to_argb(sky_color(sky, to_sun, direction));
            geometry.vertices.push_back(vertex);
        }
    }
    constexpr auto kColumns = static_cast<std::uint32_t>(kSides + 1);
    for (std::uint32_t ring = 0; ring + 1 < std::size(kRings); ++ring) {
        for (std::uint32_t side = 0; side + 1 < kColumns; ++side) {
            const std::uint32_t low = first_vertex + ring * kColumns + side, high = low + kColumns;
            for (const std::uint32_t index : {low, low + 1, high + 1, low, high + 1, high})
                geometry.indices.push_back(index);
        }
    }
    return {first_index, static_cast<std::uint32_t>(geometry.indices.size()) - first_index, -1};
}

}  // namespace demo
