// SPDX-License-Identifier: MIT
#include "pipeline/execute/clip.h"

#include <algorithm>

namespace pipeline {
namespace {

float between(float a, float b, double t) {
    return static_cast<float>(a + t * (static_cast<double>(b) - a));
}

template <int N>
glm::vec<N, float> between(const glm::vec<N, float>& a, const glm::vec<N, float>& b, double t) {
    glm::vec<N, float> result;
    for (int i = 0; i < N; ++i) result[i] = between(a[i], b[i], t);
    return result;
}

// Where the edge meets the plane that `inside` and `outside` have these distances to; t < 1 as the second is negative.
ClipVertex cut(const ClipVertex& inside, double inside_distance, const ClipVertex& outside, double outside_distance) {
    const double t = inside_distance / (inside_distance - outside_distance);
    ClipVertex result;
    result.position = between(inside.position, outside.position, t);
    result.diffuse  = between(inside.diffuse, outside.diffuse, t);
    result.specular = between(inside.specular, outside.specular, t);
    result.fog      = between(inside.fog, outside.fog, t);
    for (std::size_t stage = 0; stage < result.uv.size(); ++stage)
        result.uv[stage] = between(inside.uv[stage], outside.uv[stage], t);
    return result;
}

void clip_to_plane(const ClipVolume& volume, int plane, const ClippedPolygon& polygon, ClippedPolygon& result) {
    const auto distance_of = [&](const ClipVertex& v) { return plane_distances(volume, v.position)[plane]; };
    result.count           = 0;
    for (int i = 0; i < polygon.count; ++i) {
        const ClipVertex& here = polygon.corners[i];
        const ClipVertex& next = polygon.corners[i + 1 == polygon.count ? 0 : i + 1];
        const double d_here = distance_of(here), d_next = distance_of(next);
        const bool here_inside = d_here >= 0.0, next_inside = d_next >= 0.0;
        if (here_inside) result.corners[result.count++] = here;
        if (here_inside && !next_inside) result.corners[result.count++] = cut(here, d_here, next, d_next);
        if (!here_inside && next_inside) result.corners[result.count++] = cut(next, d_next, here, d_here);
    }
}

}  // namespace

ClippedPolygon clip_triangle(const ClipVolume& volume, const std::array<ClipVertex, 3>& triangle) {
    std::array<ClippedPolygon, 2> polygons;
    int current = 0;
    for (const ClipVertex& corner : triangle) polygons[0].corners[polygons[0].count++] = corner;
    for (int plane = 0; plane < kClipPlanes; ++plane) {
        clip_to_plane(volume, plane, polygons[current], polygons[1 - current]);
        current = 1 - current;
    }
    // Where large numbers cancel, rounding leaves less than the plane asks for, or nothing.
    for (int i = 0; i < polygons[current].count; ++i) {
        float& w = polygons[current].corners[i].position.w;
        w        = std::max(w, kLeastW);
    }
    return polygons[current];
}

}  // namespace pipeline
