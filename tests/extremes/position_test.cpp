// SPDX-License-Identifier: MIT
#include "tests/extremes/positions.h"
#include "tests/support/small_frame.h"

using namespace extremes;

TEST_CASE("extremes: of wild positions valid window vertices are made", "[extremes]") {
    const WildVertices wild = wild_vertices(kWildFrames);
    CHECK(wild.triangles > 10000);
    CHECK(wild.invalid == 0);
}

TEST_CASE("extremes: a corner next to the eye is cut off", "[extremes]") {
    const WildVertices found = corners_next_to_eye();
    CHECK(found.triangles >= 3);
    CHECK(found.invalid == 0);
    CHECK(found.greatest_rhw == 0x1p32);
}

TEST_CASE("extremes: a triangle with a corner beyond floats is dropped", "[extremes]") {
    CHECK(corners_at_infinity().triangles == 0);
}

TEST_CASE("extremes: wild positions are drawn alike by kernels and reference", "[extremes]") {
    for (std::uint32_t seed = 0; seed < 6; ++seed) test_support::pixels_on_both(wild_frame(seed, 300));
}

// Rounding leaves a w of 0 where numbers above 2^21 cancel: x / w was then no number.
TEST_CASE("extremes: a clipped corner can be divided by its w", "[extremes]") {
    const EyeCorners eye = eye_corners(kEyeTriangles);
    CHECK(eye.corners > kEyeTriangles);
    CHECK(eye.bad == 0);
}

TEST_CASE("extremes: no float of a frame may be without a value", "[extremes]") {
    const NotFinite found = not_finite();
    CHECK(found.values > 300);
    CHECK(found.passed == 0);
}

TEST_CASE("extremes: depth from near to 10^7 times as far", "[extremes]") {
    const FarDepth far = far_depth();
    CHECK(far.vertices > 10000);
    CHECK(far.error < kFarDepthBound);
    // A quotient of rounded numbers is not monotonic: rarely.
    CHECK(far.out_of_order < far.vertices / 1000);
}
