// SPDX-License-Identifier: MIT
#include "pipeline/legalize/pixel_center.h"

#include "tests/support/random.h"
#include "tests/support/random_frame.h"
#include "tests/support/rewritten.h"

using namespace pipeline;
using namespace test_support;

namespace {

// Triangles over a 64x32 target, corners from `place`, in pixels; colours and texture coordinates at random.
template <class Place>
Frame triangles_at(Random& random, Place place) {
    Frame frame = small_frame(64, 32, TargetFormat::D24);
    Pass& pass  = frame.passes[0];
    std::vector<std::uint8_t> texels(16 * 16);
    for (std::uint8_t& texel : texels) texel = static_cast<std::uint8_t>(random.from(0, 255));
    DrawTriangles draw;
    draw.textures[0]     = bound(add_texture(frame, TextureFormat::L8, 16, 16, texels));
    pass.state.depth     = {.func = CompareFunc::GreaterEqual, .write = true};
    pass.state.stages[0] = {
        .color_op = TextureOp::Modulate, .alpha_op = TextureOp::SelectArg2, .filter = TextureFilter::Linear};
    for (std::uint32_t i = 0; i < 3 * 40; ++i) {
        const Vec2 px = {place(64), place(32)};
        frame.indices.push_back(i);
        frame.vertices.push_back({.position = {px.x / 32.0f - 1.0f, 1.0f - px.y / 16.0f, random.real(0.0f, 1.0f)},
                                  .diffuse  = {random.bits()},
                                  .uv0      = {random.real(0.0f, 2.0f), random.real(0.0f, 2.0f)}});
    }
    draw.index_count = 3 * 40;
    pass.draws       = {draw};
    return frame;
}

}  // namespace

TEST_CASE("rectangles and projections move to pixel centres at integers, and half a step more where the chip cuts") {
    check_rewrite(&move_to_pixel_centers, "dx7", R"(
targets [ "picture" { width 16 height 8 } ]
cameras [ "eye" {} "unused" {} ]
passes [
    "draw" {
        color "picture"
        camera "eye"
        draws [ rectangle { x0 1 y0 2.5 x1 3 y1 4.03 } triangles {} ]
    }
]
)",
                  R"(
arithmetic { snap TRUNCATE pixel_center 0 }
targets [ "picture" { width 16 height 8 } ]
cameras [ "eye" { projection ((1 0 0 -0.05859375) (0 1 0 0.1171875) (0 0 1 0) (0 0 0 1)) } "unused" {} ]
passes [
    "draw" {
        color "picture"
        camera "eye"
        draws [ rectangle { x0 0.5 y0 2 x1 2.5 y1 3.5 } triangles {} ]
    }
]
)");
}

TEST_CASE("a camera that draws to viewports of different sizes becomes one for each") {
    check_rewrite(&move_to_pixel_centers, "gamecube", R"(
targets [ "large" { width 16 height 8 } "small" { width 4 height 2 } ]
cameras [ "eye" { projection ((1 0 0 0) (0 1 0 0) (0 0 1 0) (0 0 -1 0)) } ]
passes [
    "one" { color "large" camera "eye" draws [ triangles {} ] }
    "two" { color "small" camera "eye" draws [ triangles {} ] }
    "three" { color "small" camera "eye" state { viewport { x1 2 y1 1 } } draws [ triangles {} ] }
    "four" { color "large" camera "eye" draws [ triangles {} ] }
    "none" { color "small" camera "eye" draws [ rectangle {} ] }
]
)",
                  R"(
arithmetic { pixel_center 9 }
targets [ "large" { width 16 height 8 } "small" { width 4 height 2 } ]
cameras [
    "eye" { projection ((1 0 -0.0078125 0) (0 1 0.015625 0) (0 0 1 0) (0 0 -1 0)) }
    "eye 2" { projection ((1 0 -0.03125 0) (0 1 0.0625 0) (0 0 1 0) (0 0 -1 0)) }
    "eye 3" { projection ((1 0 -0.0625 0) (0 1 0.125 0) (0 0 1 0) (0 0 -1 0)) }
]
passes [
    "one" { color "large" camera "eye" draws [ triangles {} ] }
    "two" { color "small" camera "eye 2" draws [ triangles {} ] }
    "three" { color "small" camera "eye 3" state { viewport { x1 2 y1 1 } } draws [ triangles {} ] }
    "four" { color "large" camera "eye" draws [ triangles {} ] }
    "none" { color "small" camera "eye" draws [ rectangle { x0 0.0625 y0 0.0625 x1 0.0625 y1 0.0625 } ] }
]
)");
}

TEST_CASE("a frame that samples as the chip does is left alone") {
    check_left_alone(&move_to_pixel_centers, "ps2", R"(
arithmetic { snap TRUNCATE pixel_center 0 blend FLIPPER_TRUNC256 }
targets [ "picture" { width 8 height 4 } ]
passes [ "draw" { color "picture" draws [ rectangle { x0 0.3 x1 8 y1 4 } ] } ]
)");
}

TEST_CASE("a rectangle at the limit of coordinates stays there, and its texels in their place") {
    const Frame frame = rewritten(parsed(R"(
targets [ "picture" { width 8 height 4 } ]
passes [ "draw" { color "picture" draws [ rectangle { x0 -16384 x1 0 y0 -16384 y1 -16384 } ] } ]
)"),
                                  &move_to_pixel_centers, "dx7");
    const auto& draw  = std::get<DrawRectangle>(frame.passes[0].draws[0]);
    CHECK(draw.x0 == -16384.0f);
    CHECK(draw.x1 == -0.5f);
    CHECK(draw.uv[0].u0 == 0.5f / 16384.0f);
    CHECK(draw.uv[0].u1 == 1.0f);
    CHECK(draw.y1 == -16384.0f);
}

TEST_CASE("rectangles give the same bytes on every chip's pixel centres") {
    const std::string_view chip = GENERATE("dx7", "ps2", "gamecube", "xbox", "ideal");
    for (std::uint32_t seed = 1; seed <= 150; ++seed) {
        INFO(chip << ", seed " << seed);
        Frame frame = random_frame(seed);
        keep_draws(frame, [](const Draw& draw) { return !is_triangles(draw); });
        REQUIRE(differing_pass(rewritten(frame, &move_to_pixel_centers, chip), frame) == -1);
    }
}

TEST_CASE("triangles with corners on the subpixel grid give the same bytes") {
    const std::string_view chip = GENERATE("dx7", "ps2", "gamecube", "xbox");
    Random random(7);
    // From the first pixel's centre on, before which cutting is upward.
    const Frame frame =
        triangles_at(random, [&](int size) { return static_cast<float>(random.from(8, 16 * size + 40)) / 16.0f; });
    const Frame moved = rewritten(frame, &move_to_pixel_centers, chip);
    CHECK(moved.arithmetic != frame.arithmetic);
    CHECK(differing_pixels(moved, frame) == 0);
}

TEST_CASE("triangles anywhere differ where the projection's rounding meets a tie") {
    const std::string_view chip = GENERATE("dx7", "ps2", "gamecube", "xbox");
    std::ptrdiff_t differing    = 0;
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        Random random(seed);
        const Frame frame =
            triangles_at(random, [&](int size) { return random.real(0.5f, static_cast<float>(size) + 3.0f); });
        differing += differing_pixels(rewritten(frame, &move_to_pixel_centers, chip), frame);
    }
    CHECK(differing <= 20 * 64 * 32 / 500);
}
