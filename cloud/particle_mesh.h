// SPDX-License-Identifier: MIT
// The sphere of a mega-particle as triangles. Subdividing an icosahedron appends vertices and keeps the old ones, so
// the vertices of a level are the first of every finer level: one set of positions, normals and baked light serves all
// levels. Triangles are counter-clockwise seen from outside. A particle's surface is displaced by a few percent of its
// radius, so that it does not look like a ball, and what lies below the cloud's base is squashed to a nearly flat one.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cloud/cloud.h"

namespace cloud {

inline constexpr int kFinestLevel = 3;

constexpr std::uint32_t icosphere_vertices(int level) {
    return (10u << (2 * level)) + 2;
}
constexpr std::uint32_t icosphere_triangles(int level) {
    return 20u << (2 * level);
}

// parents: for each vertex past the first 12, the ends of the edge that it was put on.
struct Icosphere {
    std::vector<Vec3> directions;
    std::vector<std::array<std::uint32_t, 2>> parents;
    std::array<std::vector<std::uint32_t>, kFinestLevel + 1> indices;
};
const Icosphere& icosphere();

// The coarsest level whose edges are shorter on the screen than max(4 px, 3 sigma). An edge e of a sphere of radius r
// >= e / 1.05 misses the circle by e^2 / 8r <= 0.13 e: half a pixel, or 0.4 sigma, which the blur hides. Beyond 23
// sigma the finest level has longer edges, but its miss is 0.24 % of the radius.
int choose_level(float radius_px, float sigma_px);

// Points below the base keep 15 % of their depth under it.
inline constexpr float kSquash = 0.15f;
Vec3 squash(Vec3 point, float base_y);

// lumps: the displacement at each vertex, -1..1, before it is scaled; it also varies the light.
struct ParticleMesh {
    std::vector<Vec3> positions, normals;
    std::vector<float> lumps;
};

// Vertices of the finest level. `index` of the particle within its cloud picks its lumps, which stay when it moves.
ParticleMesh shape_particle(const Cloud& cloud, std::size_t index);

}  // namespace cloud
