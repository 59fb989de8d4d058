// SPDX-License-Identifier: MIT
#include "demo/metrics/plane.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "demo/metrics/statistics.h"
#include "tests/demo/metrics_planes.h"

using namespace demo;

TEST_CASE("coverage is what black and white show the same", "[metrics]") {
    const pipeline::ColorImage white{.width = 2, .height = 1, .pixels = {0xffffffff, 0xffa0b0c0}};
    const pipeline::ColorImage black{.width = 2, .height = 1, .pixels = {0xff000000, 0xffa0b08d}};
    const Plane coverage = coverage_of(white, black);
    CHECK(coverage.at(0, 0) == Approx(0.0f).margin(1e-6));
    CHECK(coverage.at(1, 0) == Approx(1.0f - 51.0f / 3.0f / 255.0f));
    CHECK(rim_of(coverage).values == std::vector<std::uint8_t>{0, 1});
    CHECK(alpha_of(black).at(1, 0) == 1.0f);
    CHECK(luminance(colors_of(white).at(0, 0)) == Approx(1.0f));
}

TEST_CASE("the nearest marked pixel is the one that a search finds", "[metrics]") {
    const double share = GENERATE(0.002, 0.05, 0.5);
    Mask mask(37, 29);
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x) mask.at(x, y) = tests::noise_at(x, y) < share;
    mask.at(36, 0)        = 1;
    const Nearest nearest = nearest_marked(mask);
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x) {
            double least = 1e9;
            for (int v = 0; v < mask.height; ++v)
                for (int u = 0; u < mask.width; ++u)
                    if (mask.at(u, v) != 0) least = std::min(least, std::hypot(u - x, v - y));
            REQUIRE(static_cast<double>(nearest.distance.at(x, y)) == Approx(least));
            const int found = nearest.index.at(x, y);
            REQUIRE(mask.values[static_cast<std::size_t>(found)] == 1);
            REQUIRE(std::hypot(found % mask.width - x, found / mask.width - y) == Approx(least));
        }
    const Nearest none = nearest_marked(Mask(3, 2));
    CHECK(none.index.at(1, 1) == -1);
    CHECK(std::isinf(none.distance.at(1, 1)));
}

TEST_CASE("smoothing widens an edge by its sigma and leaves constants alone", "[metrics]") {
    const Plane flat = smoothed(Plane(20, 10, 0.25f), 2.0);
    CHECK(flat.at(0, 0) == Approx(0.25f));
    CHECK(flat.at(11, 9) == Approx(0.25f));
    const Plane soft     = smoothed(tests::gaussian_edge(80, 3, 40.0, 3.0), 4.0);
    const Plane expected = tests::gaussian_edge(80, 3, 40.0, 5.0);
    for (int x = 0; x < 80; ++x) CHECK(soft.at(x, 1) == Approx(expected.at(x, 1)).margin(0.005));
    CHECK(sample(expected, 39.5f, 1.0f) == Approx(0.5f * (expected.at(39, 1) + expected.at(40, 1))));
    CHECK(gradient(expected, 40, 1).x == Approx(-1.0f / (5.0f * 2.5066f)).epsilon(0.02));
}

TEST_CASE("statistics of few values", "[metrics]") {
    CHECK(mean({1.0, 2.0, 6.0}) == 3.0);
    CHECK(rms({3.0, -4.0}) == Approx(std::sqrt(12.5)));
    CHECK(variation({1.0, 3.0}) == Approx(0.5));
    CHECK(quantile({5.0, 1.0, 3.0}, 0.5) == 3.0);
    CHECK(correlation({1.0, 2.0, 3.0}, {2.0, 4.0, 6.0}) == Approx(1.0));
    CHECK(correlation({1.0, 2.0, 3.0}, {3.0, 2.0, 1.0}) == Approx(-1.0));
    CHECK(correlation({1.0, 2.0}, {7.0, 7.0}) == 0.0);
    CHECK(mean({}) == 0.0);
}
