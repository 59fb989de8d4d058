// SPDX-License-Identifier: MIT
#include "pipeline/legalize/window_triangles.h"

#include <set>

#include "pipeline/execute/vertex_stage.h"
#include "pipeline/legalize/window_map.h"
#include "tests/support/random_frame.h"
#include "tests/support/rewritten.h"

using namespace pipeline;
using namespace test_support;

namespace {

// A camera with w = z, near plane 1 and far plane 2; vertices at window (8, 4), (12, 2), (12, 6) of 16x8 pixels, with depth 0, 1, 1
// and rhw 1, 1/2, 1/2.
const std::string kCamera   = R"(cameras [ "eye" { projection ((1 0 0 0) (0 1 0 0) (0 0 2 -2) (0 0 1 0)) } ])";
const std::string kTargets  = R"(targets [ "a" { width 16 height 8 } ])";
const std::string kVertices = R"(
vertices [
    { position (0 0 1) normal (0 0 -1) diffuse 0xff80ffff specular 0x11223344 uv0 (1 2) uv1 (3 4) }
    { position (1 1 2) diffuse 0x40ff0000 specular 0x00000005 uv1 (0.5 0.25) }
    { position (1 -1 2) diffuse 0x80000000 specular 0xff000000 uv1 (5 6) }
]
)";

std::string pass_text(const std::string& state, const std::string& draws,
                      const std::string& camera = "camera \"eye\"") {
    return "passes [ \"p\" { color \"a\" " + camera + " state { " + state + " } draws [ " + draws + " ] } ] ";
}
std::string before_text(const std::string& state, const std::string& indices = "0 1 2") {
    return kTargets + kCamera + pass_text(state, "triangles { index_count 3 }") + kVertices + "indices [ " + indices +
           " ]";
}
std::string after_text(const std::string& state, const std::string& vertices, const std::string& indices = "0 1 2",
                       const std::string& count = "index_count 3") {
    return kTargets + pass_text(state, "window_triangles { " + count + " }", "") + "window_vertices [ " + vertices +
           " ] indices [ " + indices + " ]";
}

// The vertices without stages, fog and lights.
const std::string kFirst  = "{ x 8 y 4 z 0 rhw 1 diffuse 0xff80ffff specular 0xff223344 } ",
                  kSecond = "{ x 12 y 2 z 1 rhw 0.5 diffuse 0x40ff0000 specular 0xff000005 } ",
                  kThird  = "{ x 12 y 6 z 1 rhw 0.5 diffuse 0x80000000 specular 0xff000000 } ";

void check_ps2(const std::string& before, const std::string& after) {
    check_rewrite(&rewrite_window_triangles, "ps2", before, after);
}

// Does the executor place all corners within the band that the rewrite leaves uncut? Then what it cuts, by a band that is wider, the
// rewrite would not cut elsewhere.
bool is_within_band(const Frame& frame) {
    constexpr float kBandPx = 1024.0f;
    for (const Pass& pass : frame.passes)
        for (const Draw& draw : pass.draws) {
            const auto* triangles = std::get_if<DrawTriangles>(&draw);
            if (triangles == nullptr) continue;
            const PixelRect viewport = viewport_of(frame, pass);
            raster::Draw placed;
            run_vertex_stage(frame, pass, *triangles, viewport, placed);
            for (const raster::TriangleCorners& corners : placed.triangles)
                for (const std::uint32_t corner : corners) {
                    const raster::Vertex& vertex = placed.vertices[corner];
                    const float beyond           = std::max(
                                  {static_cast<float>(viewport.x0) - vertex.x, vertex.x - static_cast<float>(viewport.x1),
                                   static_cast<float>(viewport.y0) - vertex.y, vertex.y - static_cast<float>(viewport.y1)});
                    if (beyond >= kBandPx) return false;
                }
        }
    return true;
}

}  // namespace

TEST_CASE("window_triangles: places, depth and 1/w by hand", "[legalize]") {
    check_ps2(before_text(""), after_text("", kFirst + kSecond + kThird));
    // Only vertices that are drawn, in the order in which triangles name them.
    check_ps2(before_text("", "2 0 1"), after_text("", kThird + kFirst + kSecond));
}

TEST_CASE("window_triangles: coordinates come with q, from where the stage has them", "[legalize]") {
    const std::string op = "color_op MODULATE alpha_op SELECTARG2 ", other = "color_arg2 { source CURRENT } ";
    check_ps2(before_text("stages [ { " + op + "coords VERTEX1 } { " + op +
                          "coords CAMERAPOSITION transform ((2 0 0 0) "
                          "(0 1 0 0) (0 0 1 1) (0 0 0 1)) } ]"),
              after_text("stages [ { " + op + "} { " + op + "} ]",
                         "{ x 8 y 4 z 0 rhw 1 diffuse 0xff80ffff specular 0xff223344 uv0 (3 4 1) uv1 (0 0 2) }"
                         "{ x 12 y 2 z 1 rhw 0.5 diffuse 0x40ff0000 specular 0xff000005 uv0 (0.5 0.25 1) uv1 (2 1 3) }"
                         "{ x 12 y 6 z 1 rhw 0.5 diffuse 0x80000000 specular 0xff000000 uv0 (5 6 1) uv1 (2 -1 3) }"));
    check_ps2(
        before_text("stages [ { " + op + "} ]"),
        after_text("stages [ { " + op + "} ]",
                   "{ x 8 y 4 z 0 rhw 1 diffuse 0xff80ffff specular 0xff223344 uv0 (1 2 1) } " + kSecond + kThird));
}

TEST_CASE("window_triangles: fog is a factor at the vertices, of no formula", "[legalize]") {
    // (4 - 1) / 4 of 255 is 191.25, (4 - 2) / 4 is 127.5.
    const std::string fogged =
        "{ x 8 y 4 z 0 rhw 1 diffuse 0xff80ffff specular 0xbf223344 }"
        "{ x 12 y 2 z 1 rhw 0.5 diffuse 0x40ff0000 specular 0x80000005 }"
        "{ x 12 y 6 z 1 rhw 0.5 diffuse 0x80000000 specular 0x80000000 }";
    check_ps2(before_text("fog { mode LINEAR color 0xff123456 end 4 }"),
              after_text("fog { mode LINEAR color 0xff123456 }", fogged));
    // exp(-1/2) and exp(-1): 154.7 and 93.8.
    check_ps2(before_text("fog { mode EXP color 0xff123456 start 3 end 4 density 0.5 }"),
              after_text("fog { mode LINEAR color 0xff123456 }",
                         "{ x 8 y 4 z 0 rhw 1 diffuse 0xff80ffff specular 0x9b223344 }"
                         "{ x 12 y 2 z 1 rhw 0.5 diffuse 0x40ff0000 specular 0x5e000005 }"
                         "{ x 12 y 6 z 1 rhw 0.5 diffuse 0x80000000 specular 0x5e000000 }"));
}

TEST_CASE("window_triangles: lights are in the vertices' colours", "[legalize]") {
    // Along the first vertex's normal; the others have none. 0x80, half of 255 (127.5), nothing; alpha is the vertex's.
    check_ps2(before_text("lighting { enabled true specular_enable true lights [ { diffuse (1 0.5 0) } ] }"),
              after_text("lighting { specular_enable true }",
                         "{ x 8 y 4 z 0 rhw 1 diffuse 0xff808000 specular 0xff000000 }"
                         "{ x 12 y 2 z 1 rhw 0.5 diffuse 0x40000000 specular 0xff000000 }" +
                             kThird));
}

TEST_CASE("window_triangles: flat triangles have three vertices of the first one's colours and fog", "[legalize]") {
    const auto colored = [](const std::string& colors) {
        return "{ x 8 y 4 z 0 rhw 1 " + colors + "} { x 12 y 2 z 1 rhw 0.5 " + colors + "} { x 12 y 6 z 1 rhw 0.5 " +
               colors + "} ";
    };
    check_ps2(before_text("shade FLAT"), after_text("", colored("diffuse 0xff80ffff specular 0xff223344")));
    check_ps2(before_text("shade FLAT fog { mode LINEAR end 4 }"),
              after_text("fog { mode LINEAR }", colored("diffuse 0xff80ffff specular 0xbf223344")));
}

TEST_CASE("window_triangles: what is culled or has no area is not there", "[legalize]") {
    check_ps2(before_text("cull CCW"), after_text("", kFirst + kSecond + kThird));
    check_ps2(before_text("cull CCW", "0 2 1"), after_text("", "", "", ""));
    check_ps2(before_text("cull CW", "0 2 1"), after_text("", kFirst + kThird + kSecond));
    check_ps2(before_text("", "0 1 1"), after_text("", "", "", ""));
}

TEST_CASE("window_triangles: what reaches before the near plane is cut", "[legalize]") {
    // From (-1, 0, 0), where w is 0, to the others: cut half way, where z = 1, at (0, 0.5, 1) and (0, -0.5, 1).
    std::string before = before_text("");
    before.replace(before.find("position (0 0 1)"), 16, "position (-1 0 0)");
    const Frame other = rewritten(parsed(before), &rewrite_window_triangles, "ps2");
    REQUIRE(other.indices.size() == 6);
    std::set<std::pair<float, float>> places;
    for (const WindowVertex& vertex : other.window_vertices) {
        places.insert({vertex.x, vertex.y});
        CHECK(vertex.z == (vertex.x == 8.0f ? 0.0f : 1.0f));
        CHECK(vertex.rhw == (vertex.x == 8.0f ? 1.0f : 0.5f));
    }
    CHECK(places == std::set<std::pair<float, float>>{{8, 2}, {8, 6}, {12, 2}, {12, 6}});
}

TEST_CASE("window_triangles: the viewport becomes part of the scissor", "[legalize]") {
    // The middle 8x4 pixels: window (8, 4), (10, 3), (10, 5).
    const std::string vertices =
        "{ x 8 y 4 rhw 1 diffuse 0xff80ffff specular 0xff223344 }"
        "{ x 10 y 3 z 1 rhw 0.5 diffuse 0x40ff0000 specular 0xff000005 }"
        "{ x 10 y 5 z 1 rhw 0.5 diffuse 0x80000000 specular 0xff000000 }";
    const std::string viewport = "viewport { x0 4 y0 2 x1 12 y1 6 }";
    check_ps2(before_text(viewport), after_text("scissor { x0 4 y0 2 x1 12 y1 6 }", vertices));
    check_ps2(before_text(viewport + "scissor { x0 6 y0 0 x1 16 y1 5 }"),
              after_text("scissor { x0 6 y0 2 x1 12 y1 5 }", vertices));
    check_ps2(before_text("viewport { x1 16 y1 8 }"), after_text("", kFirst + kSecond + kThird));
    check_ps2(before_text("scissor { x0 1 x1 2 y1 3 }"),
              after_text("scissor { x0 1 x1 2 y1 3 }", kFirst + kSecond + kThird));
}

TEST_CASE("window_triangles: where the scissor leaves nothing of the viewport nothing is drawn", "[legalize]") {
    Frame frame                 = parsed(before_text("viewport { x1 8 y1 8 } scissor { x0 9 x1 16 y1 8 }"));
    frame.passes[0].clear.color = Argb{0xff0000ff};
    const Frame other           = rewritten(frame, &rewrite_window_triangles, "ps2");
    CHECK(pixels_of(other) == std::vector<std::uint32_t>(16 * 8));
    // Nor is what is left all of the target.
    frame.passes[0].state.scissor = {8, 0, 16, 8};
    CHECK(pixels_of(rewritten(frame, &rewrite_window_triangles, "ps2")) == std::vector<std::uint32_t>(16 * 8));
}

TEST_CASE("window_triangles: passes keep what they draw else, and window triangles their place", "[legalize]") {
    const auto text = [](const std::string& camera, const std::string& state, const std::string& triangles,
                         const std::string& first_index, const std::string& rest) {
        return kTargets + camera +
               "passes [ \"w\" { color \"a\" state { cull CW viewport { x1 8 y1 8 } } draws [ "
               "window_triangles { " +
               first_index + "index_count 3 } ] } \"p\" { color \"a\" " + (camera.empty() ? "" : "camera \"eye\" ") +
               "clear { color 0xff000001 } state { " + state +
               " } draws [ "
               "rectangle { x1 4 y1 4 } " +
               triangles + " rectangle { x1 2 y1 2 } ] } ]" + rest;
    };
    const std::string window = "window_vertices [ { x 1 } { x 2 } { x 3 y 1 } ";
    check_ps2(text(kCamera, "cull CCW", "triangles { first_index 1 index_count 3 }", "first_index 4 ",
                   kVertices + window + "] indices [ 2 0 1 2 1 2 0 ]"),
              text("", "", "window_triangles { first_index 3 index_count 3 }", "",
                   window + kFirst + kSecond + kThird + "] indices [ 1 2 0 3 4 5 ]"));
}

TEST_CASE("window_triangles: a frame with a pass of both kinds, or without triangles, is left alone", "[legalize]") {
    const std::string both = kTargets + kCamera +
                             pass_text("cull CW", "triangles { index_count 3 } window_triangles { index_count 3 }") +
                             kVertices + "window_vertices [ {} { x 1 } { y 1 } ] indices [ 0 1 2 ]";
    check_left_alone(&rewrite_window_triangles, "ps2", both);
    check_left_alone(&rewrite_window_triangles, "ps2",
                     kTargets + kCamera + pass_text("viewport { x1 8 y1 8 }", "rectangle { x1 4 y1 4 }") + kVertices);
}

TEST_CASE("window_triangles: chips that transform are given their frame back", "[legalize]") {
    for (const char* chip : {"ideal", "dx7", "gamecube", "xbox"})
        check_left_alone(&rewrite_window_triangles, chip, before_text("cull CW viewport { x1 8 y1 8 }"));
}

TEST_CASE("window_triangles: a note for each pass that has changed", "[legalize]") {
    const RewriteNotes notes = notes_of(parsed(before_text("")), &rewrite_window_triangles, "ps2");
    REQUIRE(notes.size() == 1);
    CHECK(notes[0].rewrite == "window_triangles");
    CHECK(notes[0].where == "pass 0 'p'");
    CHECK(is_found(parsed(before_text("")), "ps2", "states"));
    CHECK(!is_found(rewritten(parsed(before_text("")), &rewrite_window_triangles, "ps2"), "ps2", "states"));
}

TEST_CASE("window_triangles: random frames give the same bytes, pass by pass", "[legalize][agreement]") {
    std::size_t equal = 0, cut = 0;
    std::ptrdiff_t differing = 0, pixels = 0;
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        INFO("seed " << seed);
        const Frame frame = random_frame(seed);
        const Frame other = rewritten(frame, &rewrite_window_triangles, "ps2");
        if (other == frame) continue;
        CHECK(other.vertices.empty());
        CHECK(other.cameras.empty());
        if (is_within_band(frame)) {
            ++equal;
            CHECK(differing_pass(frame, other) == -1);
        } else {
            ++cut;
            differing += differing_pixels(frame, other);
            pixels += std::ssize(pixels_of(frame));
        }
    }
    CHECK(equal > 100);
    CHECK(cut > 30);
    // Textures over triangles of thousands of pixels, cut elsewhere: a few pixels in a hundred.
    CHECK(differing > 0);
    CHECK(differing * 100 < 3 * pixels);
}
