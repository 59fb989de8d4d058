// SPDX-License-Identifier: MIT
#include "cloud/vertex_light.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <glm/geometric.hpp>

#include "cloud/exp_of_minus.h"
#include "cloud/particle_mesh.h"
#include "tests/cloud/cumulus.h"

using namespace cloud;

namespace {

float luminance(Vec3 c) {
    return (c.x + c.y + c.z) / 3.0f;
}
float blueness(Vec3 c) {
    return c.z / luminance(c);
}

// The vertex of a particle whose direction from the centre comes nearest to `direction`.
const LitVertex& vertex_towards(const LitParticles& lit, std::size_t particle, Vec3 direction) {
    const Icosphere& sphere = icosphere();
    std::size_t best        = 0;
    for (std::size_t i = 0; i < sphere.directions.size(); ++i)
        if (glm::dot(sphere.directions[i], direction) > glm::dot(sphere.directions[best], direction)) best = i;
    return lit.vertices[particle * sphere.directions.size() + best];
}

}  // namespace

TEST_CASE("exp_of_minus follows the exponential") {
    for (float x = 0.0f; x < 39.0f; x += 0.0625f) CHECK(exp_of_minus(x) == Approx(std::exp(-x)).epsilon(1e-6));
    CHECK(exp_of_minus(0.0f) == 1.0f);
    CHECK(exp_of_minus(1e30f) == 0.0f);
}

TEST_CASE("the side to the sun is brighter than the base, and shadow is bluer than light") {
    const Cloud cloud = cumulus();
    const Daylight day;
    const LitParticles lit = light_particles(cloud, day);
    REQUIRE(lit.vertices.size() == cloud.particles.size() * icosphere_vertices(kFinestLevel));
    for (std::size_t core = 0; core < 5; ++core) {
        const Vec3 top  = vertex_towards(lit, core, Vec3(0.3f, 0.95f, 0.1f)).light;
        const Vec3 base = vertex_towards(lit, core, Vec3(0.0f, -1.0f, 0.0f)).light;
        CHECK(luminance(top) > 1.5f * luminance(base));
    }
    Vec3 sunlit(0.0f), shaded(0.0f);
    for (const LitVertex& v : lit.vertices.all()) {
        for (int channel = 0; channel < 3; ++channel) {
            CHECK(v.light[channel] >= 0.0f);
            CHECK(v.light[channel] <= 0.951f);
        }
        CHECK(v.occlusion > 0.0f);
        CHECK(v.occlusion <= 1.0f);
        if (v.normal.y < 0.0f) continue;  // there the bounce is warm
        (glm::dot(v.normal, day.to_sun) > 0.5f ? sunlit : shaded) += v.light;
    }
    CHECK(blueness(shaded) > blueness(sunlit) + 0.02f);
    CHECK(glm::all(glm::lessThan(lit.low, lit.high)));
    CHECK(luminance(lit.mean_color) > 0.2f);
}

TEST_CASE("a particle in the way of the sun casts a shadow, and more absorption a deeper one") {
    Cloud cloud;
    cloud.lumpiness = 0.0f;
    cloud.particles = {{.center = Vec3(0.0f), .radius = 10.0f}};
    const Daylight day;
    const auto facing_sun = [&] { return vertex_towards(light_particles(cloud, day), 0, day.to_sun).light; };
    const Vec3 open       = facing_sun();
    cloud.particles.push_back({.center = day.to_sun * 40.0f, .radius = 10.0f});
    const Vec3 shadowed = facing_sun();
    CHECK(luminance(shadowed) < 0.6f * luminance(open));
    CHECK(blueness(shadowed) > blueness(open));
    cloud.absorption  = 3.0f;
    const Vec3 deeper = facing_sun();
    CHECK(luminance(deeper) < luminance(shadowed));
    cloud.absorption = 0.0f;
    CHECK(luminance(facing_sun()) == Approx(luminance(open)).epsilon(0.02));
    // Behind a core's diameter a quarter of the sun is left: sun alone, seen face on.
    cloud.absorption     = 1.0f;
    const Daylight stark = {.sky = Vec3(0.0f), .bounce = Vec3(0.0f)};
    const float direct   = vertex_towards(light_particles(cloud, stark), 0, stark.to_sun).light.x;
    cloud.particles.pop_back();
    const float unshadowed = vertex_towards(light_particles(cloud, stark), 0, stark.to_sun).light.x;
    CHECK(direct / unshadowed == Approx(0.25f).margin(0.01f));
}

TEST_CASE("light does not depend on the order of the other particles, and a cloud of none is empty") {
    Cloud cloud;
    cloud.particles   = {{.center = Vec3(0.0f), .radius = 10.0f},
                         {.center = Vec3(0.0f, 12.0f, 0.0f), .radius = 5.0f},
                         {.center = Vec3(9.0f, 9.0f, 0.0f), .radius = 6.0f}};
    const Vec3 before = vertex_towards(light_particles(cloud, {}), 0, Vec3(0.0f, 0.0f, 1.0f)).light;
    std::swap(cloud.particles[1], cloud.particles[2]);
    const Vec3 after = vertex_towards(light_particles(cloud, {}), 0, Vec3(0.0f, 0.0f, 1.0f)).light;
    CHECK(glm::length(before - after) < 1e-5f);
    CHECK(light_particles({}, {}).vertices.empty());
}
