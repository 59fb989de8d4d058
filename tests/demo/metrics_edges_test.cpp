// SPDX-License-Identifier: MIT
// M1, M2, M3 on edges whose width is known.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "demo/metrics/climb.h"
#include "demo/metrics/cutouts.h"
#include "demo/metrics/depth_match.h"
#include "tests/demo/metrics_planes.h"

using namespace demo;

TEST_CASE("a Gaussian edge is 2.56 sigma wide, a step less than 2 pixels", "[metrics]") {
    const double sigma = GENERATE(2.0, 4.0, 8.0);
    const Plane edge   = tests::gaussian_edge(120, 9, 60.0, sigma);
    const Mask ridges  = ridges_of(edge, 0.01f);
    CHECK(ridges.at(60, 4) == 1);
    CHECK(ridges.at(60 + static_cast<int>(sigma) + 1, 4) == 0);
    const auto width = edge_width(edge, 60, 4, 6.0 * sigma, 0.2f);
    REQUIRE(width);
    CHECK(*width == Approx(2.563 * sigma).epsilon(0.04));

    const Plane step = tests::plane_of(120, 9, [](int x, int) { return x < 60 ? 0.9 : 0.3; });
    CHECK(ridges_of(step, 0.01f).at(60, 4) == 1);
    const auto sharp = edge_width(step, 60, 4, 8.0, 0.2f);
    REQUIRE(sharp);
    CHECK(*sharp == Approx(0.8).margin(0.05));
    CHECK_FALSE(edge_width(step, 60, 4, 8.0, 0.7f));
    CHECK_FALSE(edge_width(step, 20, 4, 8.0, 0.2f));
}

TEST_CASE("an edge on a slant is as wide as an upright one", "[metrics]") {
    const Plane edge = tests::plane_of(90, 90, [](int x, int y) {
        return 0.5 * std::erfc((0.8 * (x - 45) + 0.6 * (y - 45)) / (4.0 * std::sqrt(2.0)));
    });
    REQUIRE(edge_width(edge, 45, 45, 20.0, 0.2f));
    CHECK(*edge_width(edge, 45, 45, 20.0, 0.2f) == Approx(2.563 * 4.0).epsilon(0.04));
}

TEST_CASE("a layer that ends within a soft edge is a hard step", "[metrics]") {
    const Plane soft = tests::gaussian_edge(60, 9, 30.5, 3.0);
    CHECK(is_hard_step(soft, 30, 4) == false);
    const Plane cut = tests::plane_of(60, 9, [&](int x, int y) { return 0.7 * soft.at(x, y) + (x <= 30 ? 0.3 : 0.0); });
    CHECK(is_hard_step(cut, 30, 4) == true);
    CHECK(is_hard_step(cut, 24, 4) == false);
    CHECK_FALSE(is_hard_step(Plane(60, 9, 0.5f), 30, 4));
}

TEST_CASE("what the scene leaves of a cloud is judged only where there is a cloud", "[metrics]") {
    const Plane share =
        share_left(Plane(2, 1, 0.4f), tests::plane_of(2, 1, [](int x, int) { return x == 0 ? 0.8 : 0.3; }));
    CHECK(share.at(0, 0) == Approx(0.5f));
    CHECK(std::isnan(share.at(1, 0)));
}

TEST_CASE("depth is compared away from edges alone", "[metrics]") {
    const Plane shape = tests::plane_of(100, 4, [](int x, int) { return x < 50 ? 1.0 : 0.0; });
    const Plane soft  = tests::gaussian_edge(100, 4, 49.5, 2.0);
    const Mask away   = away_from_edges(shape, 6.0);
    CHECK(away.at(52, 1) == 0);
    CHECK(away.at(58, 1) == 1);
    CHECK(away.at(40, 1) == 1);
    CHECK(away.at(90, 1) == 0);  // so far off that it says nothing
    CHECK(255.0 * mean_difference(soft, shape, away) < 0.05);
    CHECK(255.0 * mean_difference(soft, shape, tests::all_of(shape)) > 1.0);
    CHECK(mean_difference(Plane(100, 4, 1.0f), shape, away) > 0.2);
}

TEST_CASE("cuts are found where scene and sphere are equally far", "[metrics]") {
    // The scene cuts off the sphere at column 50: a wall that comes out of it, or one that stands before it.
    const Plane shape = tests::plane_of(100, 40, [](int x, int) { return x < 50 ? 1.0 : 0.0; });
    const Plane alone(100, 40, 1.0f), sphere_m(100, 40, 80.0f);
    const Plane comes_out            = tests::plane_of(100, 40, [](int x, int) { return 80.0 - 0.1 * (x - 50); });
    const Plane before               = tests::plane_of(100, 40, [](int x, int) { return x < 50 ? 90.0 : 60.0; });
    const std::vector<CutPoint> cuts = cut_points(shape, alone, comes_out, sphere_m, 2.0f, 8.0);
    REQUIRE(cuts.size() == 40);
    CHECK(cuts[20].x == 49);
    CHECK(cuts[20].out.x == Approx(1.0f));
    CHECK(cut_points(shape, alone, before, sphere_m, 2.0f, 8.0).empty());
    CHECK(cut_points(shape, shape, comes_out, sphere_m, 2.0f, 8.0).empty());  // the sphere's own outline
}

TEST_CASE("a climb is as wide as its edge, and need not be monotone", "[metrics]") {
    const CutPoint point{.x = 50, .y = 4, .out = Vec2(1.0f, 0.0f)};
    Plane edge       = tests::gaussian_edge(100, 9, 50.5, 4.0);
    const auto climb = climb_at(edge, point, 20.0);
    REQUIRE(climb);
    CHECK(climb->width_px == Approx(2.563 * 4.0).epsilon(0.03));
    CHECK(climb->monotone);
    for (int y = 0; y < 9; ++y) edge.at(51, y) += 0.2f;
    REQUIRE(climb_at(edge, point, 20.0));
    CHECK_FALSE(climb_at(edge, point, 20.0)->monotone);
    CHECK_FALSE(climb_at(edge, point, 3.0));
}

TEST_CASE("a leak is counted per pixel of border", "[metrics]") {
    // The cloud ends at column 10, where a nearer thing begins; two columns of a half lie over that.
    const Plane coverage = tests::plane_of(20, 6, [](int x, int) { return x < 10 ? 1.0 : x < 12 ? 0.5 : 0.0; });
    Mask nearer(20, 6);
    for (int y = 0; y < 6; ++y)
        for (int x = 10; x < 20; ++x) nearer.at(x, y) = 1;
    REQUIRE(leak(coverage, nearer));
    CHECK(*leak(coverage, nearer) == Approx(1.0));
    CHECK_FALSE(leak(Plane(20, 6, 0.0f), nearer));
}
