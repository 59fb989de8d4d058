// SPDX-License-Identifier: MIT
#include "cloud/generate.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "tests/cloud/cumulus.h"

using namespace cloud;

namespace {

long count_of(const std::vector<Particle>& particles, int generation) {
    return std::count_if(particles.begin(), particles.end(),
                         [&](const Particle& p) { return p.generation == generation; });
}

}  // namespace

TEST_CASE("three generations grow, each on the one before and smaller") {
    const std::vector<Particle> particles = grow(cumulus_cores(), {});
    CHECK(count_of(particles, 0) == 5);
    CHECK(count_of(particles, 1) == 14);
    CHECK(count_of(particles, 2) >= 20);
    CHECK(count_of(particles, 2) <= 24);
    CHECK(std::is_sorted(particles.begin(), particles.end(),
                         [](const Particle& a, const Particle& b) { return a.generation < b.generation; }));
    for (std::size_t i = 5; i < particles.size(); ++i) {
        const Particle& child = particles[i];
        const bool seated     = std::any_of(particles.begin(), particles.end(), [&](const Particle& parent) {
            const float seat = child.generation == 1 ? 0.85f : 0.9f;
            return parent.generation < child.generation &&
                   (child.generation == 2 || child.center.y > parent.center.y) &&
                   glm::length(child.center - parent.center) == Approx(seat * parent.radius).margin(1e-3) &&
                   child.radius < 0.61f * parent.radius;
        });
        INFO("particle " << i);
        CHECK(seated);
        CHECK(buried_share(child, std::span(particles).first(i)) <= 0.7f);
    }
}

TEST_CASE("siblings are spread around their parent") {
    const std::vector<Particle> core{{.center = Vec3(0.0f), .radius = 10.0f}};
    const Generation crown{
        .count = 6, .seat = 1.0f, .first_radius = 0.2f, .last_radius = 0.2f, .lowest = 0.2f, .rise = 0.0f};
    const std::vector<Particle> particles = grow(core, {.crown = crown, .rim = {}});
    REQUIRE(particles.size() == 7);
    int quadrants = 0;
    for (std::size_t i = 1; i < particles.size(); ++i)
        quadrants |= 1 << ((particles[i].center.x > 0.0f) + 2 * (particles[i].center.z > 0.0f));
    CHECK(quadrants == 15);
}

TEST_CASE("the seed moves jittered children and nothing else; without jitter it does nothing") {
    const Growth calm{.seed = 1}, calm_too{.seed = 2};
    const auto a = grow(cumulus_cores(), calm), b = grow(cumulus_cores(), calm_too);
    REQUIRE(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i) CHECK(a[i].center == b[i].center);
    const auto c = grow(cumulus_cores(), {.jitter = 0.1f, .seed = 1}),
               d = grow(cumulus_cores(), {.jitter = 0.1f, .seed = 2});
    CHECK(c[4].center == d[4].center);
    CHECK(c[5].center != d[5].center);
    CHECK(glm::length(c[5].center - c[0].center) == Approx(0.85f * 18.0f));
}

TEST_CASE("a buried child goes to another parent, or is left out") {
    // All places on the inner core are inside the outer one.
    const std::vector<Particle> cores{{.center = Vec3(0.0f), .radius = 45.0f}, {.center = Vec3(0.0f), .radius = 90.0f}};
    const Generation crown{.count = 6};
    const auto particles = grow(cores, {.crown = crown, .rim = {}});
    CHECK(particles.size() == 8);
    for (std::size_t i = 2; i < particles.size(); ++i) CHECK(glm::length(particles[i].center) > 60.0f);

    // A child always reaches into its parent, so none may be seated where nothing may be buried.
    const Generation strict{.count = 12, .greatest_burial = 0.0f};
    CHECK(grow(cores, {.crown = strict, .rim = {}}).size() == 2);
    CHECK(buried_share(cores[0], std::span(cores).last(1)) == 1.0f);
    CHECK(buried_share(cores[1], std::span(cores).first(1)) == 0.0f);
    CHECK(grow({}, {}).empty());
}
