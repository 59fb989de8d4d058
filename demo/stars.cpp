// SPDX-License-Identifier: MIT
#include "demo/stars.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "demo/noise.h"
#include "demo/sky.h"
#include "demo/texture_pyramid.h"

namespace demo {

TexturedRange append_stars(SceneGeometry& geometry, const Sky& sky, const Vec3& to_sun) {
    constexpr std::uint32_t kSeed = 29;
    const auto first_index        = static_cast<std::uint32_t>(geometry.indices.size());
    int placed                    = 0;
    for (int i = 0; placed < sky.stars; ++i) {
        const auto random   = [&](int which) { return hash_unit(i, which, kSeed); };
        // A point of the cube's inside that lies in the ball: its direction is as likely as any other.
        const Vec3 point    = 2.0f * Vec3(random(0), random(1), random(2)) - 1.0f;
        const float length2 = glm::dot(point, point);
        if (length2 > 1.0f || length2 < 0.01f) continue;
        ++placed;
        const Vec3 direction = point / std::sqrt(length2);
        const Vec3 right     = glm::normalize(glm::cross(direction, Vec3(0.31f, 0.9f, 0.3f)));
        const Vec3 up        = glm::cross(right, direction);
        // Few are bright.
        const float share = random(3), brightness = 0.12f + 0.88f * share * share * share * share;
        const float warmth    = random(4);
        const float radius    = 0.0009f + 0.0012f * brightness;
        const Vec3 around     = sky_color(sky, to_sun, direction);
        const Vec3 color      = around + brightness * Vec3(0.75f + 0.25f * warmth, 0.85f, 1.0f - 0.3f * warmth);
        const auto first      = static_cast<std::uint32_t>(geometry.vertices.size());
        const auto add_vertex = [&](Vec3 position, Vec3 vertex_color) {
            geometry.vertices.push_back({.position = position, .diffuse = to_argb(vertex_color)});
        };
        const Vec3 middle = 0.995f * direction;
        add_vertex(middle, color);
        for (const Vec3& corner : {right, up, -right, -up}) add_vertex(middle + radius * corner, around);
        for (std::uint32_t corner = 0; corner < 4; ++corner)
            for (std::uint32_t index : {0u, 1 + corner, 1 + (corner + 1) % 4})
                geometry.indices.push_back(first + index);
    }
    return {first_index, static_cast<std::uint32_t>(geometry.indices.size()) - first_index, -1};
}

}  // namespace demo
