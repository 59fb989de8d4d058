// SPDX-License-Identifier: MIT
#include "cloud/bounds.h"

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <random>

#include "cloud/particle_mesh.h"
#include "tests/cloud/cumulus.h"

using namespace cloud;

TEST_CASE("every visible point of every particle lies within the bounds") {
    std::mt19937 random(7);
    const auto within = [&](float low, float high) {
        return low + (high - low) * static_cast<float>(random() % 100001) / 100000.0f;
    };
    int visible_clouds = 0, tight = 0;
    for (int trial = 0; trial < 150; ++trial) {
        Cloud cloud;
        cloud.base_y = within(-40.0f, 20.0f);
        for (int i = 0; i < 5; ++i)
            cloud.particles.push_back(
                {.center = Vec3(within(-30, 30), within(-20, 20), within(-30, 30)), .radius = within(1, 15)});
        const Vec3 eye    = Vec3(within(-1, 1), within(-1, 1), within(-1, 1)) * (trial % 3 == 0 ? 40.0f : 150.0f);
        const View view   = look(eye, Vec3(within(-60, 60), within(-30, 30), within(-60, 60)), 333, 219);
        const auto bounds = screen_bounds(cloud, view, 0, 8);
        PixelRect seen{1000, 1000, -1000, -1000};
        for (std::size_t i = 0; i < cloud.particles.size(); ++i)
            for (const Vec3& p : shape_particle(cloud, i).positions) {
                const Vec4 clip = view.projection * view.view * Vec4(p, 1.0f);
                if (clip.w < view.near_m) continue;
                const float x = (1.0f + clip.x / clip.w) * 0.5f * 333.0f, y = (1.0f - clip.y / clip.w) * 0.5f * 219.0f;
                if (x < 0.0f || x >= 333.0f || y < 0.0f || y >= 219.0f) continue;
                seen = {std::min(seen.x0, static_cast<int>(x)), std::min(seen.y0, static_cast<int>(y)),
                        std::max(seen.x1, static_cast<int>(x) + 1), std::max(seen.y1, static_cast<int>(y) + 1)};
            }
        if (seen.x1 < 0) continue;
        ++visible_clouds;
        INFO("trial " << trial);
        REQUIRE(bounds.has_value());
        CHECK(bounds->x0 <= seen.x0);
        CHECK(bounds->y0 <= seen.y0);
        CHECK(bounds->x1 >= seen.x1);
        CHECK(bounds->y1 >= seen.y1);
        CHECK((bounds->x0 % 8 == 0 && bounds->y0 % 8 == 0 && bounds->x1 % 8 == 0 && bounds->y1 % 8 == 0));
        CHECK((bounds->x0 >= 0 && bounds->y0 >= 0 && bounds->x1 <= 336 && bounds->y1 <= 224));
        tight += bounds->x1 - bounds->x0 < 300;
    }
    CHECK(visible_clouds > 50);
    CHECK(tight > 20);
}

TEST_CASE("bounds of one sphere are exact, and grow by the margin") {
    Cloud cloud;
    cloud.lumpiness  = 0.0f;
    cloud.particles  = {{.center = Vec3(0.0f), .radius = 3.0f}};
    const View view  = look(Vec3(0.0f, 0.0f, 15.0f), Vec3(0.0f), 2000, 2000);
    // The tangent of the touching rays is 3 / sqrt(15^2 - 3^2).
    const auto half  = static_cast<int>(0.20412415f * focal_px(view));
    const auto exact = screen_bounds(cloud, view, 0, 1);
    REQUIRE(exact);
    CHECK(exact->x0 <= 1000 - half);
    CHECK(exact->x0 >= 1000 - half - 2);
    CHECK(exact->y1 >= 1000 + half);
    CHECK(exact->y1 <= 1000 + half + 2);
    const auto grown = screen_bounds(cloud, view, 10, 1);
    CHECK(grown->x0 == exact->x0 - 10);
    CHECK(grown->y1 == exact->y1 + 10);
}

TEST_CASE("a camera inside a particle sees it everywhere, one that looks away sees nothing") {
    const Cloud cloud = cumulus();
    const auto inside = screen_bounds(cloud, look(Vec3(0.0f, 60.0f, 0.0f), Vec3(1.0f, 60.0f, 5.0f)), 3, 4);
    REQUIRE(inside);
    CHECK(*inside == PixelRect{0, 0, 320, 240});
    CHECK(!screen_bounds(cloud, look(Vec3(0.0f, 60.0f, 170.0f), Vec3(0.0f, 60.0f, 300.0f)), 3, 4));
    CHECK(!screen_bounds(Cloud{}, look(Vec3(0.0f), Vec3(1.0f)), 3, 4));
}
