// SPDX-License-Identifier: MIT
#include "tests/extremes/positions.h"
#include "tests/support/small_frame.h"

using namespace extremes;

TEST_CASE("extremes: of wild positions valid window vertices are made", "[extremes]") {
    const WildVertices wild = wild_vertices(kWildFrames);
    CHECK(wild.triangles > 10000);
    CHECK(wild.invalid == 0);
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

// It was dropped whole: 1/w had become infinite.
TEST_CASE("extremes: a triangle is drawn whose edge passes the eye", "[extremes]") {
    using namespace pipeline;
    Frame frame      = test_support::small_frame(64, 64);
    // (x, y, z) becomes (x, y, 0, -z).
    Mat4& projection = frame.cameras[0].projection;
    projection[2][2] = 0.0f;
    projection[2][3] = -1.0f;
    projection[3][3] = 0.0f;
    frame.vertices.resize(3);
    const float size                = GENERATE(1.0f, 0x1p30f);
    frame.vertices[0].position      = {0.0f, 0.0f, -size};
    frame.vertices[1].position      = {0.0f, 0.0f, 3.0f * size};
    frame.vertices[2].position      = {0.75f * size, 0.0f, -size};
    frame.vertices[2].position.y    = 0.5f * size;
    frame.indices                   = {0, 1, 2};
    frame.passes[0].draws           = {DrawTriangles{.index_count = 3, .textures = {}}};
    const test_support::Drawn drawn = test_support::draw_on_both(frame);
    CHECK(drawn.execution.counts[0].triangles_drawn > 0);
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
