// SPDX-License-Identifier: MIT
// Blends by the target's colours, which register ALPHA has for some colours of vertices alone.
#include <cmath>

#include "pipeline/legalize/gs_alpha.h"
#include "pipeline/legalize/gs_blend.h"
#include "tests/support/rewritten.h"

using namespace pipeline;
using namespace test_support;

namespace {

const std::string kInvert = "blend { source INVDESTCOLOR dest ZERO } ",
                  kRest   = "gs_blend { b CD c FIX d ZERO fix 128 } ";
const std::string kMore = "blend { source DESTCOLOR dest ONE } ", kAlphaMore = "gs_blend { a CD b ZERO d CD } ";

std::string text(const std::string& rules, const std::string& state, const std::string& draw) {
    return "arithmetic { combine GS_SHIFT7 " + rules +
           "} targets [ \"a\" { format PSMCT32 width 4 height 4 } ] passes [ \"p\" { color \"a\" state { " + state +
           "} draws [ " + draw +
           " ] } ] window_vertices [ { diffuse 0x20404040 } { x 4 diffuse 0x20404040 } "
           "{ y 4 diffuse 0x80ffffff } { diffuse 0x80fffffe } ] indices [ 0 1 2 2 2 2 2 3 2 ]";
}
void check_ps2(const std::string& before, const std::string& after, const std::string& draw) {
    check_rewrite(&rewrite_gs_blend, "ps2", text("", before, draw), text("blend GS_SHIFT7", after, draw));
}
void check_alone(const std::string& state, const std::string& draw) {
    check_left_alone(&rewrite_gs_blend, "ps2", text("", state, draw));
}

// Columns of grey 0..255 under rows of a colour each, blended with alpha masked.
template <class Color>
Frame blended_frame(const BlendState& blend, Color&& color) {
    Frame frame             = small_frame(256, 256);
    frame.targets[0].format = TargetFormat::Psmct32;
    frame.passes.push_back(frame.passes[0]);
    for (int i = 0; i < 256; ++i) {
        const auto grey = static_cast<std::uint32_t>(i) * 0x010101u;
        frame.passes[0].draws.push_back(rectangle({i, 0, i + 1, 256}, 0xff000000 | grey));
        frame.passes[1].draws.push_back(rectangle({0, i, 256, i + 1}, color(static_cast<std::uint32_t>(i))));
    }
    frame.passes[1].state.blend            = blend;
    frame.passes[1].state.color_mask.alpha = false;
    return frame;
}

int worst_on_ps2(const Frame& frame) {
    const Frame other = rewritten(rewritten(frame, &rewrite_gs_alpha, "ps2"), &rewrite_gs_blend, "ps2");
    REQUIRE(other.arithmetic.blend == BlendRule::GsShift7);
    const std::vector<std::uint32_t> want = pixels_of(frame), got = pixels_of(other);
    int worst = 0;
    for (std::size_t i = 0; i < want.size(); ++i)
        worst = std::max(worst, std::abs(static_cast<int>(got[i] & 255) - static_cast<int>(want[i] & 255)));
    return worst;
}

const std::string kWhite = "rectangle { x1 4 y1 4 color 0x40ffffff }",
                  kGrey  = "rectangle { x1 4 y1 4 color 0x20404040 }";

}  // namespace

TEST_CASE("gs_blend: white by the rest of the target's colours is their complement", "[legalize]") {
    check_ps2(kInvert, kRest, kWhite);
    check_ps2(kInvert, kRest, "window_triangles { first_index 3 index_count 3 }");
    check_ps2(kInvert + "stages [ { color_op SELECTARG1 color_arg1 { source DIFFUSE } alpha_op SELECTARG1 } ] ",
              kRest + "stages [ { color_op SELECTARG1 color_arg1 { source DIFFUSE } alpha_op SELECTARG1 } ] ", kWhite);
    check_alone(kInvert, "rectangle { x1 4 y1 4 color 0x40fffeff }");
    check_alone(kInvert, "window_triangles { first_index 6 index_count 3 }");  // one vertex
    check_alone(kInvert, kWhite + kGrey);
    check_alone(kInvert + "stages [ { color_op SELECTARG1 alpha_op SELECTARG1 } ] ", kWhite);
    check_alone(kInvert + "fog { mode LINEAR } ", kWhite);
    check_alone(kInvert + "lighting { specular_enable true } ", kWhite);
    check_alone("blend { source INVDESTCOLOR dest ONE } ", kWhite);
}

TEST_CASE("gs_blend: greys that are their own alpha add that much of what is there", "[legalize]") {
    check_ps2(kMore, kAlphaMore, kGrey);
    check_ps2(kMore, kAlphaMore, "window_triangles { index_count 3 }");  // greys of two levels, one of them white
    check_alone(kMore, "rectangle { x1 4 y1 4 color 0x21404040 }");
    check_alone(kMore, "rectangle { x1 4 y1 4 color 0x20404140 }");
    check_alone(kMore, "window_triangles { first_index 6 index_count 3 }");
    check_alone(kMore + "stages [ { color_op SELECTARG1 color_arg1 { source DIFFUSE } alpha_op SELECTARG1 } ] ", kGrey);
    check_alone(kMore + "fog { mode LINEAR } ", kGrey);
}

TEST_CASE("gs_blend: complements are exact, for all colours and whatever alpha", "[legalize][exhaustive]") {
    CHECK(worst_on_ps2(blended_frame({BlendFactor::InvDestColor, BlendFactor::Zero},
                                     [](std::uint32_t i) { return i << 24 | 0xffffffu; })) == 0);
}

TEST_CASE("gs_blend: every grey on every grey adds its share, but for 1 of 255", "[legalize][exhaustive]") {
    CHECK(worst_on_ps2(blended_frame({BlendFactor::DestColor, BlendFactor::One},
                                     [](std::uint32_t i) { return i * 0x01010101u; })) <= 1);
}
