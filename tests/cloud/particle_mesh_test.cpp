// SPDX-License-Identifier: MIT
#include "cloud/particle_mesh.h"

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <set>

using namespace cloud;

TEST_CASE("icospheres are closed, turn outward, and share their first vertices") {
    const Icosphere& sphere = icosphere();
    REQUIRE(sphere.directions.size() == icosphere_vertices(kFinestLevel));
    for (const Vec3& d : sphere.directions) CHECK(glm::length(d) == Approx(1.0f));
    for (int level = 0; level <= kFinestLevel; ++level) {
        const auto& indices = sphere.indices[static_cast<std::size_t>(level)];
        REQUIRE(indices.size() == 3 * icosphere_triangles(level));
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        std::set<std::uint32_t> used;
        for (std::size_t t = 0; t < indices.size(); t += 3) {
            const Vec3 a = sphere.directions[indices[t]], b = sphere.directions[indices[t + 1]],
                       c = sphere.directions[indices[t + 2]];
            CHECK(glm::dot(glm::cross(b - a, c - a), a + b + c) > 0.0f);
            for (std::size_t k = 0; k < 3; ++k) {
                ++edges[{indices[t + k], indices[t + (k + 1) % 3]}];
                used.insert(indices[t + k]);
            }
        }
        for (const auto& [edge, count] : edges) {
            CHECK(count == 1);
            CHECK(edges.count({edge.second, edge.first}) == 1);
        }
        CHECK(used.size() == icosphere_vertices(level));
        CHECK(*used.rbegin() == icosphere_vertices(level) - 1);
    }
    for (std::uint32_t v = 12; v < sphere.parents.size(); ++v)
        CHECK((sphere.parents[v][0] < v && sphere.parents[v][1] < v));
}

TEST_CASE("the chosen level misses the circle by less than half a pixel or half a sigma") {
    const Icosphere& sphere = icosphere();
    std::array<float, kFinestLevel + 1> sag{};
    for (std::size_t level = 0; level < sag.size(); ++level) {
        const auto& indices = sphere.indices[level];
        for (std::size_t t = 0; t < indices.size(); ++t) {
            const std::size_t other = t % 3 == 2 ? t - 2 : t + 1;
            const Vec3 middle       = (sphere.directions[indices[t]] + sphere.directions[indices[other]]) * 0.5f;
            sag[level]              = std::max(sag[level], 1.0f - glm::length(middle));
        }
    }
    for (float radius : {1.0f, 3.0f, 8.0f, 15.0f, 29.9f, 55.0f, 120.0f, 400.0f})
        for (float sigma : {0.0f, 1.7f, 4.1f, 8.5f, 20.6f}) {
            if (radius > 23.0f * std::max(sigma, 1.33f)) continue;
            const auto level = static_cast<std::size_t>(choose_level(radius, sigma));
            INFO("radius " << radius << " px, sigma " << sigma << " px: level " << level);
            CHECK(radius * sag[level] <= std::max(0.6f, 0.5f * sigma));
        }
    CHECK(choose_level(1e30f, 1.0f) == kFinestLevel);
}

TEST_CASE("a particle's surface is lumpy, its base flat, its normals unit and outward") {
    Cloud cloud;
    cloud.particles         = {{.center = Vec3(0.0f, 60.0f, 0.0f), .radius = 18.0f}};
    cloud.base_y            = 48.0f;
    const ParticleMesh mesh = shape_particle(cloud, 0);
    REQUIRE(mesh.positions.size() == icosphere_vertices(kFinestLevel));
    float lowest = 1e9f, nearest = 1e9f, farthest = 0.0f;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec3 p = mesh.positions[i], from_center = p - cloud.particles[0].center;
        CHECK(glm::length(mesh.normals[i]) == Approx(1.0f));
        CHECK(glm::dot(mesh.normals[i], from_center) > 0.0f);
        lowest = std::min(lowest, p.y);
        if (p.y < 48.0f) {
            CHECK(mesh.normals[i].y < 0.0f);
            if (glm::length(Vec2(p.x, p.z)) < 8.0f) CHECK(mesh.normals[i].y < -0.9f);
        } else {
            nearest  = std::min(nearest, glm::length(from_center));
            farthest = std::max(farthest, glm::length(from_center));
        }
    }
    // 18 m below the centre is 6 m below the base: 15 % of that, give or take the lumps.
    CHECK(lowest == Approx(48.0f - 0.9f).margin(0.2f));
    CHECK(farthest - nearest > 18.0f * 0.03f);
    CHECK(farthest <= 18.0f * 1.06f);
    CHECK(nearest >= 18.0f * 0.94f);
}

TEST_CASE("squashing keeps what is above the base and the order of what is below") {
    CHECK(squash(Vec3(1.0f, 5.0f, 2.0f), 4.0f) == Vec3(1.0f, 5.0f, 2.0f));
    CHECK(squash(Vec3(1.0f, 4.0f, 2.0f), 4.0f) == Vec3(1.0f, 4.0f, 2.0f));
    CHECK(squash(Vec3(1.0f, 2.0f, 2.0f), 4.0f).y == Approx(3.7f));
}
