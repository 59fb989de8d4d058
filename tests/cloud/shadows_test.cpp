// SPDX-License-Identifier: MIT
// What is traced in bundles, past what they cannot meet, is bit for bit what each ray adds up by itself.
#include "cloud/shadows.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <random>

#include "cloud/exp_of_minus.h"
#include "cloud/generate.h"
#include "cloud/noise.h"
#include "cloud/vertex_light.h"

using namespace cloud;

namespace {

// Some are not there, and some are long or flat.
Cloud random_cloud(std::mt19937& random, std::size_t particles, float stretch, float far_m) {
    std::uniform_real_distribution<float> share(0.0f, 1.0f), place(-60.0f, 60.0f);
    Cloud cloud;
    cloud.base_y = -20.0f;
    for (std::size_t i = 0; i < particles; ++i) {
        Particle particle{.center = Vec3(place(random) + far_m, place(random), place(random)),
                          .radius = 2.0f + 15.0f * share(random),
                          .alpha  = share(random) < 0.2f ? 0.0f : 1.0f};
        if (share(random) < 0.4f)
            for (int axis = 0; axis < 3; ++axis)
                particle.shape[axis][axis] = std::pow(stretch, 2.0f * share(random) - 1.0f);
        cloud.particles.push_back(particle);
    }
    return cloud;
}

// The chords of one ray, one particle after the other.
float share_of_ray(const Cloud& cloud, Vec3 start, Vec3 direction, float density) {
    float core = 0.0f, metres = 0.0f;
    for (const Particle& particle : cloud.particles)
        if (particle.alpha > 0.0f) core = std::max(core, particle.radius);
    const float to_base = direction.y < 0.0f ? std::max((cloud.base_y - start.y) / direction.y, 0.0f) : 1e30f;
    for (const Particle& particle : cloud.particles) {
        const float radius = particle.alpha > 0.0f ? particle.radius : 0.0f;
        Vec3 to_center = particle.center - start, unit = direction;
        float speed = 1.0f;
        if (particle.shape != Mat3(1.0f)) {
            const Mat3 to_ball = glm::inverse(particle.shape);
            const Vec3 step    = to_ball * direction;
            speed              = glm::length(step);
            unit               = step / speed;
            to_center          = to_ball * to_center;
        }
        const float along   = glm::dot(to_center, unit);
        const float squared = along * along - glm::dot(to_center, to_center) + radius * radius;
        const float half    = std::sqrt(std::max(squared, 0.0f));
        metres += std::max(std::min((along + half) / speed, to_base) - std::max((along - half) / speed, 0.0f), 0.0f);
    }
    return exp_of_minus(metres * (2.14f * cloud.absorption / (2.0f * core)) * density);
}

}  // namespace

TEST_CASE("rays in bundles meet all that each of them meets", "[cloud]") {
    std::mt19937 random(GENERATE(1, 2, 3, 4));
    const float stretch = GENERATE(2.0f, 30.0f), far_m = GENERATE(0.0f, 20000.0f);
    const Cloud cloud = random_cloud(random, 70, stretch, far_m);
    const Shadows shadows(cloud);
    std::uniform_real_distribution<float> place(-1.0f, 1.0f);
    std::size_t whole = 0, partly = 0;
    for (std::size_t own = 0; own < 20; ++own) {
        const Particle& particle = cloud.particles[own];
        Vec3 direction           = glm::normalize(Vec3(place(random), place(random), place(random)));
        if (own % 4 == 0) direction = Vec3(0.0f, -1.0f, 0.0f);
        if (own % 4 == 1) direction *= 1.0004f;  // as much too long as a bake allows
        std::vector<Vec3> starts;
        // Any number, also such as fill no vector.
        for (std::size_t i = 0; i < 8 + own; ++i)
            starts.push_back(particle.center +
                             particle.radius * glm::normalize(Vec3(place(random), place(random), place(random))));
        Rays rays;
        for (const Vec3& start : starts) rays.add(start);
        shadows.trace(rays, direction, 0.5f, particle.center, 1.01f * particle.radius);
        for (std::size_t i = 0; i < starts.size(); ++i) {
            const float expected = share_of_ray(cloud, starts[i], direction, 0.5f);
            REQUIRE(rays.share(i) == expected);
            ++(expected == 1.0f ? whole : partly);
        }
    }
    CHECK(partly > 50);
    CHECK(whole + partly > 300);
}

// What a ray just misses it may meet by rounding; far off, by some of that.
TEST_CASE("rays that graze a far particle are not left out", "[cloud]") {
    std::mt19937 random(8);
    std::uniform_real_distribution<float> share(0.0f, 1.0f);
    int met = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vec3 direction = glm::normalize(Vec3(share(random), share(random), share(random)) - 0.5f);
        const Vec3 aside     = glm::normalize(glm::cross(direction, Vec3(0.3f, -0.5f, 0.8f)));
        const float far_m    = 3000.0f * share(random);
        Cloud cloud;
        cloud.particles = {
            {.center = -5.0f * direction, .radius = 1.0f},
            {.center = far_m * direction + (2.0f + 1e-3f * far_m * share(random)) * aside, .radius = 2.0f}};
        const Shadows shadows(cloud);
        const Vec3 start = 1e-3f * aside;
        Rays rays;
        rays.add(start);
        shadows.trace(rays, direction, 50.0f, start, 0.0f);
        const float expected = share_of_ray(cloud, start, direction, 50.0f);
        REQUIRE(rays.share(0) == expected);
        met += expected < 1.0f;
    }
    CHECK(met > 20);
}

TEST_CASE("depths in touching particles are those in all particles", "[cloud]") {
    std::mt19937 random(5);
    const Cloud cloud = random_cloud(random, 70, 3.0f, 0.0f);
    const Shadows shadows(cloud);
    std::uniform_real_distribution<float> place(-1.0f, 1.0f);
    int inside = 0;
    for (const Particle& particle : cloud.particles) {
        std::vector<Vec3> points;
        for (int i = 0; i < 21; ++i)
            points.push_back(particle.center +
                             0.57f * particle.radius * Vec3(place(random), place(random), place(random)));
        std::vector<float> deepest(points.size());
        shadows.depths(points, shadows.touching(particle.center, particle.radius), deepest);
        for (std::size_t i = 0; i < points.size(); ++i) {
            float expected = 0.0f;
            for (const Particle& other : cloud.particles) {
                if (other.alpha <= 0.0f) continue;
                const Vec3 offset = points[i] - other.center;
                const Vec3 ball   = other.shape == Mat3(1.0f) ? offset : glm::inverse(other.shape) * offset;
                expected          = std::max(expected, other.radius - glm::length(ball));
            }
            REQUIRE(deepest[i] == expected);
            inside += expected > 0.0f;
        }
    }
    CHECK(inside > 500);
}

TEST_CASE("the noise of many points is that of each", "[cloud]") {
    std::mt19937 random(6);
    std::uniform_real_distribution<float> place(-300.0f, 300.0f);
    for (const std::size_t count : {0u, 1u, 63u, 64u, 65u, 642u}) {
        std::vector<Vec3> points;
        for (std::size_t i = 0; i < count; ++i) points.push_back(Vec3(place(random), place(random), place(random)));
        std::vector<float> sums(count);
        fbm(points, 3, 0.6f, 11, sums);
        for (std::size_t i = 0; i < count; ++i) REQUIRE(sums[i] == fbm(points[i], 3, 0.6f, 11));
    }
}

TEST_CASE("the buried share is that of all particles", "[cloud]") {
    std::mt19937 random(7);
    const Cloud cloud = random_cloud(random, 150, 1.0f, 0.0f);
    for (const Particle& particle : cloud.particles) {
        int buried = 0;
        for (std::uint32_t i = 0; i < icosphere_vertices(1); ++i) {
            const Vec3 point = particle.center + icosphere().directions[i] * particle.radius;
            buried += std::any_of(cloud.particles.begin(), cloud.particles.end(), [&](const Particle& other) {
                const Vec3 d = point - other.center;
                return &other != &particle && glm::dot(d, d) < other.radius * other.radius;
            });
        }
        std::vector<Particle> others;
        for (const Particle& other : cloud.particles)
            if (&other != &particle) others.push_back(other);
        REQUIRE(buried_share(particle, others) ==
                static_cast<float>(buried) / static_cast<float>(icosphere_vertices(1)));
    }
}

TEST_CASE("copies of lit vertices share them until one is changed", "[cloud]") {
    LitVertices first(std::vector<LitVertex>(3)), second = first;
    CHECK(&first[0] == &second[0]);
    second.edit()[1].sun = 0.25f;
    CHECK(&first[0] != &second[0]);
    CHECK(first[1].sun == 1.0f);
    CHECK(second[1].sun == 0.25f);
    const LitVertex* const place = &second[0];
    second.edit()[0].sun         = 0.5f;
    CHECK(&second[0] == place);
    // Put together, they are shared still.
    first.append(second);
    first.append(first);
    REQUIRE(first.size() == 12);
    CHECK(&first[3] == place);
    CHECK(first[10].sun == 0.25f);
    first.edit()[4].sun = 0.75f;
    CHECK(first.size() == 12);
    CHECK(first[10].sun == 0.25f);
    CHECK(second[1].sun == 0.25f);
    CHECK(LitVertices().empty());
    CHECK(LitVertices().edit().empty());
}
