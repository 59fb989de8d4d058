// SPDX-License-Identifier: MIT
#include "tests/extremes/coverage.h"

#include "tests/support/small_frame.h"

using namespace extremes;

TEST_CASE("extremes: fans hit each pixel once, at all subpixel phases, also where they are cut", "[extremes]") {
    const Cut cut = GENERATE(Cut::Nothing, Cut::GuardBand, Cut::NearPlane);
    CHECK(grids().size() == 4);
    for (const pipeline::Arithmetic& grid : grids()) {
        const Hits hits = fan_hits(cut, grid, 1);
        CHECK(hits.pixels == 256 * 32 * 32);
        CHECK(hits.wrong == 0);
        CHECK(hits.twice == 0);
    }
}

TEST_CASE("extremes: rectangles side by side hit each pixel once, at all subpixel phases", "[extremes]") {
    for (const pipeline::Arithmetic& grid : grids()) {
        const Hits hits = rectangle_hits(grid);
        CHECK(hits.pixels == 16 * 8 * 8);
        CHECK(hits.wrong == 0);
    }
}

TEST_CASE("extremes: cut fans are drawn alike by kernels and reference", "[extremes]") {
    for (const Cut cut : {Cut::Nothing, Cut::GuardBand, Cut::NearPlane})
        for (const pipeline::Arithmetic& grid : grids()) test_support::pixels_on_both(random_fan(cut, grid, 3, 14, 99));
}

TEST_CASE("extremes: slivers that are cut hit each pixel once more clockwise than not", "[extremes]") {
    CHECK(fine_hits().wrong == 0);
}

TEST_CASE("extremes: a million triangles around one point hit each pixel once", "[extremes]") {
    const Hits hits = million_hits();
    CHECK(hits.wrong == 0);
    CHECK(hits.twice == 0);
}

TEST_CASE("extremes: meshes of squares from 1/4096 to 131072 pixels hit each pixel once", "[extremes]") {
    for (int exponent = kLeastSide; exponent <= kGreatestSide; ++exponent) {
        INFO("side 2^" << exponent);
        const Hits hits = mesh_hits(exponent);
        CHECK(hits.wrong == 0);
        CHECK(hits.twice == 0);
    }
}

TEST_CASE("extremes: depth and colour of slivers keep to the planes' bound", "[extremes]") {
    const SliverErrors errors = sliver_errors();
    CHECK(errors.pixels > 1000);
    CHECK(errors.depth < kDepthBound);
    CHECK(errors.color < kColorBound);
}
