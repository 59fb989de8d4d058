// SPDX-License-Identifier: MIT
#include "pipeline/legalize/scissor.h"

#include "tests/support/random.h"
#include "tests/support/random_frame.h"
#include "tests/support/rewritten.h"

using namespace pipeline;
using namespace test_support;

TEST_CASE("the viewport becomes what it has in common with the scissor, and the projection fits it") {
    check_rewrite(&limit_by_viewport, "dx7", R"(
targets [ "picture" { width 16 height 8 } ]
cameras [ "eye" { projection ((1 0 0.5 0) (0 1 0 0) (0 0 1 0) (0 0 -1 0)) } ]
passes [
    "clear" { color "picture" clear { color 0x00000000 } state { viewport { x0 2 x1 9 y1 8 } scissor { x0 1 y0 1 x1 6 y1 5 } } }
    "rectangle" { color "picture" state { scissor { x0 4 y0 2 x1 8 y1 6 } } draws [ rectangle { x1 16 y1 8 } ] }
    "triangles" { color "picture" camera "eye" state { scissor { x0 4 y0 1 x1 8 y1 5 } } draws [ triangles {} ] }
    "all" { color "picture" camera "eye" draws [ triangles {} ] }
]
)",
                  // x' = 16/4 x + (16 - 12)/4 w, y' = 8/4 y - (8 - 6)/4 w, with w = -z
                  R"(
targets [ "picture" { width 16 height 8 } ]
cameras [
    "eye" { projection ((1 0 0.5 0) (0 1 0 0) (0 0 1 0) (0 0 -1 0)) }
    "eye 2" { projection ((4 0 1 0) (0 2 0.5 0) (0 0 1 0) (0 0 -1 0)) }
]
passes [
    "clear" { color "picture" clear { color 0x00000000 } state { viewport { x0 2 y0 1 x1 6 y1 5 } } }
    "rectangle" { color "picture" state { viewport { x0 4 y0 2 x1 8 y1 6 } } draws [ rectangle { x1 16 y1 8 } ] }
    "triangles" { color "picture" camera "eye 2" state { viewport { x0 4 y0 1 x1 8 y1 5 } } draws [ triangles {} ] }
    "all" { color "picture" camera "eye" draws [ triangles {} ] }
]
)");
}

TEST_CASE("a pass whose scissor leaves nothing of the viewport draws nothing") {
    check_rewrite(&limit_by_viewport, "dx7", R"(
targets [ "picture" { width 16 height 8 } "other" { width 4 height 4 } ]
passes [
    "draw" { color "picture" clear { color 0x00000000 } state { viewport { x1 4 y1 4 } scissor { x0 4 x1 8 y1 4 } } draws [ rectangle {} ] }
    "copy" { color "picture" clear { color 0x00000000 } state { viewport { x1 4 y1 4 } scissor { x0 4 x1 8 y1 4 } } draws [ copy { source "other" from { x1 4 y1 4 } } ] }
]
)",
                  R"(
targets [ "picture" { width 16 height 8 } "other" { width 4 height 4 } ]
passes [
    "draw" { color "picture" state { viewport { x1 4 y1 4 } } }
    "copy" { color "picture" state { viewport { x1 4 y1 4 } } draws [ copy { source "other" from { x1 4 y1 4 } } ] }
]
)");
}

TEST_CASE("a note says for each pass what limits it now") {
    const RewriteNotes notes = notes_of(parsed(R"(
targets [ "picture" { width 16 height 8 } ]
cameras [ "eye" {} ]
passes [
    "dome" { color "picture" camera "eye" state { scissor { x0 4 y0 2 x1 8 y1 6 } } draws [ triangles {} ] }
    "none" { color "picture" state { viewport { x1 4 y1 4 } scissor { x0 4 x1 8 y1 4 } } draws [ rectangle {} ] }
]
)"),
                                        &limit_by_viewport, "dx7");
    CHECK(notes == RewriteNotes{{"scissor", "pass 0 'dome'", "the chip has no scissor",
                                 "viewport x0 4 y0 2 x1 8 y1 6, with the projection to fit"},
                                {"scissor", "pass 1 'none'", "the chip has no scissor",
                                 "nothing is drawn, as nothing of the viewport is left"}});
}

TEST_CASE("a scissor that the chip has, or that cuts nothing, is left alone") {
    constexpr std::string_view kCuts = R"(
targets [ "picture" { width 16 height 8 } ]
passes [ "draw" { color "picture" state { scissor { x1 4 y1 4 } } draws [ rectangle {} ] } ]
)";
    for (const std::string_view chip : {"ideal", "ps2", "gamecube", "xbox"})
        check_left_alone(&limit_by_viewport, chip, kCuts);
    check_left_alone(&limit_by_viewport, "dx7", R"(
targets [ "picture" { width 16 height 8 } "other" { width 4 height 4 } ]
passes [
    "viewport within" { color "picture" state { viewport { x0 1 x1 4 y1 4 } scissor { x1 4 y1 4 } } draws [ rectangle {} ] }
    "copy" { color "picture" state { scissor { x1 4 y1 4 } } draws [ copy { source "other" from { x1 4 y1 4 } } ] }
    "nothing" { color "picture" state { scissor { x1 4 y1 4 } } }
]
)");
}

TEST_CASE("rectangles, clears and copies without a scissor give the same bytes") {
    int cut = 0;
    for (std::uint32_t seed = 1; seed <= 300; ++seed) {
        INFO("seed " << seed);
        Frame frame = random_frame(seed);
        keep_draws(frame, [](const Draw& draw) { return !is_triangles(draw); });
        const Frame without = rewritten(frame, &limit_by_viewport, "dx7");
        cut += is_found(frame, "dx7", "scissor");
        REQUIRE(!is_found(without, "dx7", "scissor"));
        REQUIRE(differing_pass(without, frame) == -1);
    }
    CHECK(cut >= 100);
}

TEST_CASE("triangles without a scissor give the same pixels") {
    // 12x12 pixels of 64x64, so that neither scale is a power of two: 64/12 and 64/10.
    std::ptrdiff_t differing = 0, drawn = 0;
    for (std::uint32_t seed = 1; seed <= 100; ++seed) {
        Random random(seed);
        Frame frame                 = small_frame(64, 64);
        frame.cameras[0].projection = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 1}, {0, 0, 0, 0}};
        Pass& pass                  = frame.passes[0];
        pass.state.scissor          = {random.from(0, 52), random.from(0, 54), 0, 0};
        pass.state.scissor.x1       = pass.state.scissor.x0 + 12;
        pass.state.scissor.y1       = pass.state.scissor.y0 + 10;
        for (std::uint32_t i = 0; i < 3 * 20; ++i) {
            const float w = random.real(1.0f, 4.0f);
            frame.indices.push_back(i);
            frame.vertices.push_back({.position = {random.real(-2.0f, 2.0f) * w, random.real(-2.0f, 2.0f) * w, w},
                                      .diffuse  = {random.bits()}});
        }
        frame.cameras[0].projection[2][2] = 0.0f;
        frame.cameras[0].projection[3][2] = 0.5f;
        pass.draws                        = {DrawTriangles{.index_count = 3 * 20}};
        const Frame without               = rewritten(frame, &limit_by_viewport, "dx7");
        CHECK(without.passes[0].state.scissor == PixelRect{});
        differing += differing_pixels(without, frame);
        const std::vector<std::uint32_t> pixels = pixels_of(frame);
        drawn += std::ssize(pixels) - std::count(pixels.begin(), pixels.end(), 0u);
    }
    CHECK(drawn > 100 * 120 / 2);
    CHECK(differing <= drawn / 200);  // colours by rounding, edges by a tie
}
