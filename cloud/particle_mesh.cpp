// SPDX-License-Identifier: MIT
#include "cloud/particle_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "cloud/noise.h"

namespace cloud {
namespace {

void add_outward(const std::vector<Vec3>& v, std::vector<std::uint32_t>& indices, std::uint32_t a, std::uint32_t b,
                 std::uint32_t c) {
    const bool outward = glm::dot(glm::cross(v[b] - v[a], v[c] - v[a]), v[a]) > 0.0f;
    indices.insert(indices.end(), {a, outward ? b : c, outward ? c : b});
}

Icosphere make_icosphere() {
    Icosphere sphere;
    // (0, +-1, +-phi) and its cyclic permutations; vertices that share an edge are 2 apart.
    const float phi = (1.0f + std::sqrt(5.0f)) / 2.0f;
    for (int axis = 0; axis < 3; ++axis)
        for (float one : {-1.0f, 1.0f})
            for (float golden : {-phi, phi}) {
                Vec3 corner(0.0f);
                corner[(axis + 1) % 3] = one;
                corner[(axis + 2) % 3] = golden;
                sphere.directions.push_back(corner);
            }
    const auto neighbors = [&](std::uint32_t a, std::uint32_t b) {
        const Vec3 d = sphere.directions[a] - sphere.directions[b];
        return glm::dot(d, d) < 4.5f;
    };
    for (std::uint32_t a = 0; a < 12; ++a)
        for (std::uint32_t b = a + 1; b < 12; ++b)
            for (std::uint32_t c = b + 1; c < 12; ++c)
                if (neighbors(a, b) && neighbors(b, c) && neighbors(c, a))
                    add_outward(sphere.directions, sphere.indices[0], a, b, c);
    for (Vec3& corner : sphere.directions) corner = glm::normalize(corner);
    sphere.parents.resize(12);

    for (int level = 0; level < kFinestLevel; ++level) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> midpoints;
        const auto midpoint = [&](std::uint32_t a, std::uint32_t b) {
            const auto next            = static_cast<std::uint32_t>(sphere.directions.size());
            const auto [entry, is_new] = midpoints.try_emplace(std::minmax(a, b), next);
            if (is_new) {
                sphere.parents.push_back({entry->first.first, entry->first.second});
                sphere.directions.push_back(glm::normalize(sphere.directions[a] + sphere.directions[b]));
            }
            return entry->second;
        };
        const std::vector<std::uint32_t>& coarse = sphere.indices[static_cast<std::size_t>(level)];
        std::vector<std::uint32_t>& fine         = sphere.indices[static_cast<std::size_t>(level) + 1];
        for (std::size_t t = 0; t < coarse.size(); t += 3) {
            const std::uint32_t a = coarse[t], b = coarse[t + 1], c = coarse[t + 2];
            const std::uint32_t ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
            fine.insert(fine.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
        }
    }
    return sphere;
}

}  // namespace

const Icosphere& icosphere() {
    static const Icosphere sphere = make_icosphere();
    return sphere;
}

int choose_level(float radius_px, float sigma_px) {
    const float longest = sigma_px * 3.0f > 4.0f ? sigma_px * 3.0f : 4.0f;
    float edge          = 1.05f * radius_px;  // of the icosahedron; each level halves it
    int level           = 0;
    for (; level < kFinestLevel && !(edge < longest); ++level) edge *= 0.5f;
    return level;
}

Vec3 squash(Vec3 point, float base_y) {
    if (point.y < base_y) point.y = base_y + (point.y - base_y) * kSquash;
    return point;
}

ParticleMesh shape_particle(const Cloud& cloud, std::size_t index) {
    constexpr float kLumpsPerRadius = 1.9f;
    const Particle& particle        = cloud.particles[index];
    const Icosphere& sphere         = icosphere();
    ParticleMesh mesh;
    mesh.positions.reserve(sphere.directions.size());
    const Vec3 offset = Vec3(17.31f, 5.17f, 9.73f) * static_cast<float>(index % 4096);
    for (const Vec3& d : sphere.directions) mesh.positions.push_back(d * kLumpsPerRadius + offset);
    mesh.lumps.resize(mesh.positions.size());
    fbm(mesh.positions, 2, 0.5f, cloud.fractal.seed, mesh.lumps);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const float length = particle.radius * (1.0f + cloud.lumpiness * mesh.lumps[i]);
        mesh.positions[i]  = squash(particle.center + particle.shape * (sphere.directions[i] * length), cloud.base_y);
    }
    // The sum of the triangles' normals, each as long as its triangle is large, follows lumps and base alike.
    mesh.normals.assign(mesh.positions.size(), Vec3(0.0f));
    const std::vector<std::uint32_t>& indices = sphere.indices[kFinestLevel];
    const std::vector<Vec3>& p                = mesh.positions;
    for (std::size_t t = 0; t < indices.size(); t += 3) {
        const std::uint32_t a = indices[t], b = indices[t + 1], c = indices[t + 2];
        const Vec3 normal = glm::cross(p[b] - p[a], p[c] - p[a]);
        for (std::uint32_t vertex : {a, b, c}) mesh.normals[vertex] += normal;
    }
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        const float length = glm::length(mesh.normals[i]);
        mesh.normals[i]    = length > 0.0f ? mesh.normals[i] / length : sphere.directions[i];
    }
    return mesh;
}

}  // namespace cloud
