// SPDX-License-Identifier: MIT
#include "pipeline/legalize/mip_levels.h"

#include "tests/support/rewritten.h"

using namespace pipeline;
using namespace test_support;

namespace {

// A8 of 4x2, 2x1 and 1x1 texels.
const std::string kTexture = "\"f\" { format A8 width 4 height 2 levels 3 texels [0102030405060708 a1a2 c1] } ";
const std::string kStage   = "{ color_op SELECTARG1 alpha_op SELECTARG1 ";

std::string text(const std::string& stages, const std::string& draws, const std::string& textures,
                 const std::string& rest = "") {
    return "targets [ \"a\" { width 16 height 16 } ] passes [ \"p\" { color \"a\" state { stages [ " + stages +
           " ] } draws [ " + draws + " ] } ] textures [ " + textures + "] " + rest;
}

// A triangle 16 pixels wide and high over `u` of a texture 16 texels wide to the right, `v` down: u and v texels a pixel.
Frame triangle_frame(const std::vector<Vec2>& texels_per_pixel, MipFilter filter = MipFilter::Linear, float q = 1.0f) {
    Frame frame = small_frame(16, 16);
    std::vector<std::uint8_t> texels;
    for (const int level : {0, 1, 2, 3, 4})
        for (int i = 0; i < 256 >> (2 * level); ++i) texels.push_back(static_cast<std::uint8_t>(level));
    const TextureId texture         = add_texture(frame, TextureFormat::L8, 16, 16, texels, 5);
    Pass& pass                      = frame.passes[0];
    pass.camera                     = {};
    pass.state.stages[0]            = kTextureOnly;
    pass.state.stages[0].mip_filter = filter;
    for (const Vec2& step : texels_per_pixel)
        for (const auto& [x, y] : {std::pair{0.0f, 0.0f}, {16.0f, 0.0f}, {0.0f, 16.0f}}) {
            frame.indices.push_back(static_cast<std::uint32_t>(frame.window_vertices.size()));
            frame.window_vertices.push_back(
                {.x = x, .y = y, .uv0 = Vec3(step.x * x / 16.0f, step.y * y / 16.0f, 1.0f) * q});
        }
    DrawWindowTriangles draw{.index_count = static_cast<std::uint32_t>(frame.indices.size()), .textures = {}};
    draw.textures[0] = bound(texture);
    pass.draws       = {draw};
    return frame;
}

// The texel at the start of what the first draw binds: its level.
int level_of(const Vec2& texels_per_pixel, float q = 1.0f) {
    const Frame other = rewritten(triangle_frame({texels_per_pixel}, MipFilter::Linear, q), &rewrite_mip_levels, "ps2");
    const TextureId id = textures_of(other.passes[0].draws.at(0))[0].texture;
    return other.textures[static_cast<std::size_t>(id.index)].texels[0];
}

}  // namespace

TEST_CASE("mip_levels: each triangle's level is a texture, and runs of one level are draws", "[legalize]") {
    // Corners 4 pixels apart, over one, two or four times the texture: 1, 2 and 4 texels a pixel to the right.
    const auto corners     = [](const std::string& u) { return "{} { x 4 uv0 (" + u + " 0 1) } { y 4 } "; };
    const std::string rest = "window_vertices [ " + corners("1") + corners("2") + corners("4") +
                             "] indices [ 0 1 2 0 1 2 3 4 5 6 7 8 3 4 5 0 1 2 ]";
    const auto draw = [](const std::string& range, const std::string& texture) {
        return "window_triangles { " + range + " textures [ { texture \"" + texture + "\" } ] } ";
    };
    check_rewrite(&rewrite_mip_levels, "ps2",
                  text(kStage + "filter LINEAR mip_filter LINEAR }", draw("index_count 18", "f"), kTexture, rest),
                  text(kStage + "filter LINEAR }",
                       draw("index_count 6", "f, level 0") + draw("first_index 6 index_count 3", "f, level 1") +
                           draw("first_index 9 index_count 3", "f, level 2") +
                           draw("first_index 12 index_count 3", "f, level 1") +
                           draw("first_index 15 index_count 3", "f, level 0"),
                       kTexture + "\"f, level 0\" { format A8 width 4 height 2 texels [0102030405060708] } "
                                  "\"f, level 1\" { format A8 width 2 height 1 texels [a1a2] } "
                                  "\"f, level 2\" { format A8 width 1 height 1 texels [c1] } ",
                       rest));
}

TEST_CASE("mip_levels: rectangles have a level too", "[legalize]") {
    const auto rectangle = [](const std::string& uv, const std::string& texture) {
        return "rectangle { x1 4 y1 2 uv [ " + uv + " ] textures [ { texture \"" + texture + "\" } ] } ";
    };
    check_rewrite(&rewrite_mip_levels, "ps2",
                  text(kStage + "mip_filter POINT }", rectangle("{}", "f") + rectangle("{ v1 2 }", "f"), kTexture),
                  text(kStage + "}", rectangle("{}", "f, level 0") + rectangle("{ v1 2 }", "f, level 1"),
                       kTexture + "\"f, level 0\" { format A8 width 4 height 2 texels [0102030405060708] } "
                                  "\"f, level 1\" { format A8 width 2 height 1 texels [a1a2] } "));
    // One level has none to choose; the filter goes.
    const std::string one = "\"f\" { format A8 width 1 height 1 texels [01] } ";
    check_rewrite(&rewrite_mip_levels, "ps2", text(kStage + "mip_filter POINT }", rectangle("{}", "f"), one),
                  text(kStage + "}", rectangle("{}", "f"), one));
}

TEST_CASE("mip_levels: the level is the nearest, of the steeper direction", "[legalize]") {
    CHECK(level_of({0.25f, 0.25f}) == 0);
    CHECK(level_of({1.0f, 1.0f}) == 0);
    CHECK(level_of({1.40625f, 1.0f}) == 0);  // below the root of 2
    CHECK(level_of({1.4375f, 1.0f}) == 1);   // above it
    CHECK(level_of({1.0f, 2.0f}) == 1);
    CHECK(level_of({2.8125f, 0.0f}) == 1);  // twice as much
    CHECK(level_of({0.0f, 2.875f}) == 2);
    CHECK(level_of({8.0f, 4.0f}) == 3);
    CHECK(level_of({1000.0f, 4.0f}) == 4);      // the last
    CHECK(level_of({2.0f, 1.0f}, 0.25f) == 1);  // by s/q
}

TEST_CASE("mip_levels: levels of whole powers of two give the picture of the nearest level", "[legalize]") {
    for (const float step : {0.5f, 1.0f, 2.0f, 4.0f, 8.0f, 16.0f}) {
        INFO(step);
        const Frame frame = triangle_frame({{step, step}}, GENERATE(MipFilter::Point, MipFilter::Linear));
        CHECK(pixels_of(rewritten(frame, &rewrite_mip_levels, "ps2")) == pixels_of(frame));
    }
}

TEST_CASE("mip_levels: what it cannot split, and what the chip has, is left alone", "[legalize]") {
    const Frame frame = triangle_frame({{4.0f, 4.0f}});
    for (const char* chip : {"ideal", "dx7", "gamecube", "xbox"})
        CHECK(rewritten(frame, &rewrite_mip_levels, chip) == frame);
    CHECK(rewritten(frame, &rewrite_mip_levels, "ps2") != frame);
    const auto check_alone = [&](const auto& change) {
        Frame other = frame;
        change(other, other.passes[0]);
        CHECK(rewritten(other, &rewrite_mip_levels, "ps2") == other);
    };
    check_alone([](Frame&, Pass& p) { p.state.stages[0].mip_filter = MipFilter::None; });
    check_alone([](Frame&, Pass& p) { p.draws.clear(); });
    check_alone([](Frame&, Pass& p) {
        p.state.stages[0] = {
            .color_op = TextureOp::SelectArg2, .alpha_op = TextureOp::SelectArg2, .mip_filter = MipFilter::Linear};
    });
    check_alone([](Frame&, Pass& p) { p.state.stages[1] = p.state.stages[0]; });
    check_alone([](Frame& f, Pass& p) {
        f.vertices.resize(3);
        p.camera = {0};
        p.draws.emplace_back(DrawTriangles{.index_count = 3, .textures = {}});
    });
}
