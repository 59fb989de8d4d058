// SPDX-License-Identifier: MIT
// What is computed a row at a time is, bit for bit, what is computed point by point.
#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

#include "demo/bake_light.h"
#include "demo/canyon.h"
#include "demo/noise.h"

namespace demo {
namespace {

std::vector<float> uneven_columns(float first) {
    std::vector<float> x;
    for (int i = 0; i < 137; ++i)
        x.push_back(first + 0.07f * static_cast<float>(i) + 0.0013f * static_cast<float>(i * i));
    return x;
}

}  // namespace

TEST_CASE("rows of noise are the noise of their points", "[demo][terrain]") {
    const std::vector<float> x = uneven_columns(GENERATE(-9.3f, 0.0f, 41.5f));
    const NoiseGrid grid(x, 3);
    for (const Period period : {Period{}, Period{7, 5}})
        for (const float y : {-3.25f, -0.5f, 0.0f, 2.0f, 6.81f}) {
            const auto noises = grid.noise_row(y, 9, period), fractals = grid.fractal_row(y, 9, period),
                       ridges = grid.ridged_row(y, 9, period);
            REQUIRE(noises.size() == x.size());
            for (std::size_t i = 0; i < x.size(); ++i) {
                INFO("x " << x[i] << ", y " << y);
                REQUIRE(noises[i] == noise(x[i], y, 9, period));
                REQUIRE(fractals[i] == fractal_noise(x[i], y, 3, 9, period));
                REQUIRE(ridges[i] == ridged_noise(x[i], y, 3, 9, period));
            }
        }
    CHECK(NoiseGrid({}).noise_row(1.0f, 2).empty());
}

TEST_CASE("a height field's rows are its points, and a canyon's too", "[demo][terrain]") {
    const CanyonShape shape{.seed = 3};
    const auto height_of = [&](float x, float z) { return canyon_height(shape, x, z); };
    const std::vector<float> x{-1500.0f, -260.0f, -12.5f, 0.0f, 3.0f, 240.0f, 1580.0f};
    const CanyonHeights rows(shape, x);
    for (const float z : {-1200.0f, -230.0f, -30.0f, 0.0f, 55.0f, 1599.0f}) {
        std::vector<float> heights(x.size());
        rows.row(z, heights);
        for (std::size_t i = 0; i < x.size(); ++i) REQUIRE(heights[i] == height_of(x[i], z));
    }
}

TEST_CASE("the light on a terrain's grid is that of its points", "[demo][terrain]") {
    const HeightField field({30.0f, -10.0f}, {700.0f, 500.0f}, [](float x, float z) {
        return 25.0f * noise(x / 40.0f, z / 40.0f, 4) + 9.0f * noise(x / 11.0f, z / 11.0f, 5);
    });
    const Surroundings around{.terrain = &field, .columns = {}, .clouds = {}};
    const Vec3 to_sun =
        glm::normalize(GENERATE(Vec3(0.5f, 0.3f, 0.4f), Vec3(-0.9f, 0.05f, 0.1f), Vec3(0.0f, -0.1f, 1.0f)));
    const GridLight grid(field, to_sun);
    int shaded = 0, open = 0;
    for (int row = 0; row < HeightField::kPoints; row += 32) {
        const GridLight::Row grid_row(grid, row);
        for (int column = 0; column < HeightField::kPoints; column += 16) {
            const Vec3 point  = field.point(column, row) + Vec3(0.0f, 0.15f, 0.0f);
            const float share = grid_row.sun_past_terrain(column, point.y);
            REQUIRE(share == sun_past_solids(around, point, to_sun));
            REQUIRE(grid_row.open_sky(column, point.y) == open_sky(field, point));
            shaded += share < 0.5f;
            open += share > 0.5f;
        }
    }
    CHECK(shaded > 20);
    if (to_sun.y > 0.0f) CHECK(open > 20);
}

TEST_CASE("the clouds' shadow on a row is that on its points", "[demo][terrain]") {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(-1.0f, 1.0f);
    std::vector<cloud::Cloud> clouds(2);
    for (cloud::Cloud& cloud : clouds)
        for (int i = 0; i < 25; ++i)
            cloud.particles.push_back(
                {.center = Vec3(90.0f * place(random), 60.0f + 20.0f * place(random), 90.0f * place(random)),
                 .radius = 6.0f + 5.0f * place(random),
                 .alpha  = 0.5f + 0.5f * place(random)});
    clouds[1].absorption = 0.7f, clouds[1].opacity = 0.9f;
    const Surroundings around{
        .terrain = nullptr, .columns = {}, .clouds = {ShadowCloud(clouds[0]), ShadowCloud(clouds[1])}};
    int shaded = 0, open = 0;
    for (const Vec3& to_sun : {Vec3(0.5f, 0.3f, 0.4f), Vec3(-0.9f, 0.1f, 0.1f), Vec3(0.0f, 1.0f, 0.0f)})
        for (float z = -150.0f; z <= 150.0f; z += 9.0f) {
            std::vector<Vec3> points;
            std::vector<float> shares;
            for (int i = 0; i < 203; ++i) {
                // Also above and among the clouds, and from far away.
                const float height = i % 50 < 8 ? 70.0f : 3.0f * place(random), x = 3.0f * static_cast<float>(i - 100);
                points.push_back({i < 195 ? x : 40.0f * x, height, z});
                shares.push_back(i % 5 == 0 || i / 20 == 3 ? 0.0f : 0.5f + 0.5f * place(random));
            }
            const std::vector<float> before = shares;
            const Vec3 direction            = glm::normalize(to_sun);
            shade_by_clouds(around, points, direction, shares);
            for (std::size_t i = 0; i < points.size(); ++i) {
                const float past = sun_past_clouds(around, points[i], direction);
                REQUIRE(shares[i] == (before[i] > 0.0f ? before[i] * past : before[i]));
                ++(past < 1.0f ? shaded : open);
            }
        }
    CHECK(shaded > 500);
    CHECK(open > 1000);
}

}  // namespace demo
