// SPDX-License-Identifier: MIT
#include "pipeline/legalize/light_at_vertices.h"

#include <cmath>

#include "tests/support/rewritten.h"

using namespace pipeline;
using namespace test_support;

namespace {

const std::string kThrown = "blend { source DESTCOLOR dest ONE } color_mask { alpha false } ";

std::string text(const std::string& passes, const std::string& vertices, const std::string& indices) {
    return "targets [ \"a\" { width 4 height 4 } ] passes [ " + passes +
           " ] textures [ \"t\" { width 1 height 1 texels [004080ff] } ] window_vertices [ " + vertices +
           " ] indices [ " + indices + " ]";
}

// One triangle with a stage or two of textures of one row of greys, its corners at u, and what light it has there.
struct Lit {
    std::vector<std::uint8_t> texels{255};
    std::array<float, 3> u{};
    std::array<TextureStage, 2> stages{
        TextureStage{.color_op = TextureOp::SelectArg1, .alpha_op = TextureOp::SelectArg1}};
    std::uint32_t diffuse = 0xffffffff, factor = 0xffffffff;
    FogState fog;
    std::uint32_t specular = 0xff000000;
    float q                = 1.0f;
};
Frame lit_frame(const Lit& lit) {
    Frame frame         = small_frame(4, 4);
    const TextureId row = add_texture(frame, TextureFormat::L8, static_cast<int>(lit.texels.size()), 1, lit.texels);
    Pass& pass          = frame.passes[0];
    pass.camera         = {};
    pass.state.blend    = {BlendFactor::DestColor, BlendFactor::One};
    pass.state.stages   = lit.stages;
    pass.state.fog      = lit.fog;
    pass.state.texture_factor   = {lit.factor};
    pass.state.color_mask.alpha = false;
    pass.clear.color            = Argb{0xff204060};
    const std::array<Vec2, 3> places{Vec2(0, 0), Vec2(4, 0), Vec2(0, 4)};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 uv(lit.u[i] * lit.q, 0.5f * lit.q, lit.q);
        frame.window_vertices.push_back({.x        = places[i].x,
                                         .y        = places[i].y,
                                         .diffuse  = {lit.diffuse},
                                         .specular = {lit.specular},
                                         .uv0      = uv,
                                         .uv1      = uv});
        frame.indices.push_back(static_cast<std::uint32_t>(i));
    }
    DrawWindowTriangles draw{.index_count = 3, .textures = {}};
    draw.textures = {bound(row), bound(row)};
    pass.draws    = {draw};
    return frame;
}
Frame rewritten_ps2(const Frame& frame) {
    return rewritten(frame, &rewrite_light_at_vertices, "ps2");
}

// The light in red at the three corners; -1 where the channel draws nothing.
std::array<int, 3> light_of(const Lit& lit) {
    const Frame other = rewritten_ps2(lit_frame(lit));
    REQUIRE(other.passes.size() == 3);
    const auto& red = std::get<DrawWindowTriangles>(other.passes[0].draws[0]);
    std::array<int, 3> light{-1, -1, -1};
    for (std::uint32_t i = 0; i < red.index_count; ++i) {
        const std::uint32_t color = other.window_vertices[other.indices[red.first_index + i]].diffuse.value;
        light[i]                  = static_cast<int>(color & 255);
        CHECK(color == (color & 255) * 0x01010101u);
    }
    return light;
}
using Levels = std::array<int, 3>;

constexpr TextureStage kSelect{.color_op = TextureOp::SelectArg1, .alpha_op = TextureOp::SelectArg1};

}  // namespace

TEST_CASE("light_at_vertices: a pass for each channel, of triangles that it lights", "[legalize]") {
    const std::string vertices =
        "{ diffuse 0xff102030 specular 0x80445566 uv1 (1 2 1) } { x 4 z 0.5 rhw 0.25 } { y 4 } ";
    const auto grey = [](const std::string& color) {
        return "{ diffuse " + color + " } { x 4 z 0.5 rhw 0.25 diffuse " + color + " } { y 4 diffuse " + color + " } ";
    };
    const auto pass = [](const std::string& name, const std::string& channels, const std::string& clear,
                         const std::string& draw) {
        return "\"p: " + name + "\" { color \"a\" " + clear +
               " state { blend { source DESTCOLOR dest ONE } color_mask { " + channels +
               " alpha false } scissor { x1 4 y1 2 } } draws [ window_triangles { " + draw + " } ] } ";
    };
    check_rewrite(
        &rewrite_light_at_vertices, "ps2",
        text("\"p\" { color \"a\" clear { color 0xff000000 } state { " + kThrown +
                 "scissor { x1 4 y1 2 } stages [ { color_op SELECTARG1 alpha_op SELECTARG1 } ] } draws [ "
                 "window_triangles { index_count 3 textures [ { texture \"t\" } ] } ] }",
             vertices, "0 1 2"),
        text(pass("red", "green false blue false", "clear { color 0xff000000 }", "first_index 3 index_count 3") +
                 pass("green", "red false blue false", "", "first_index 6 index_count 3") +
                 pass("blue", "red false green false", "", "first_index 9"),
             vertices + grey("0x80808080") + grey("0x40404040"), "0 1 2 3 4 5 6 7 8"));
}

TEST_CASE("light_at_vertices: textures are read as the stage reads them", "[legalize]") {
    Lit lit{.texels = {0, 40, 100, 200}, .u = {0.125f, 0.5f, 1.0f}};
    CHECK(light_of(lit) == Levels{0, 100, 0});  // point: texels 0, 2, and 4, which repeats to 0
    lit.stages[0].address_u = TextureAddress::Clamp;
    CHECK(light_of(lit) == Levels{0, 100, 200});
    lit.q = 4.0f;
    CHECK(light_of(lit) == Levels{0, 100, 200});
    lit.stages[0].filter = TextureFilter::Linear;
    CHECK(light_of(lit) == Levels{0, 70, 200});  // between texels 1 and 2
    lit.stages[0].address_u = TextureAddress::Wrap;
    CHECK(light_of(lit) == Levels{0, 70, 100});  // between texels 3 and 0
    lit.u = {-0.125f, 0.25f, 2.375f};
    CHECK(light_of(lit) == Levels{200, 20, 40});
}

TEST_CASE("light_at_vertices: stages, factor, fog and clamps by hand", "[legalize]") {
    Lit lit{.texels = {128}, .diffuse = 0xff804020};
    CHECK(light_of(lit) == Levels{128, 128, 128});
    lit.stages[0] = {.color_op   = TextureOp::Modulate,
                     .color_arg2 = {.source = ArgSource::Diffuse},
                     .alpha_op   = TextureOp::SelectArg1};
    CHECK(light_of(lit) == Levels{64, 64, 64});  // 128 * 128 / 255 = 64.25
    lit.stages[0].color_op = TextureOp::Modulate2X;
    CHECK(light_of(lit) == Levels{129, 129, 129});  // 128.5
    lit.stages[1] = {.color_op = TextureOp::Modulate2X, .alpha_op = TextureOp::SelectArg1};
    CHECK(light_of(lit) == Levels{129, 129, 129});  // times 256 / 255: 129.006, of which nothing was rounded between
    lit.diffuse = 0xffff4020;
    CHECK(light_of(lit) == Levels{255, 255, 255});  // cut at one
    lit.stages[1] = {.color_op   = TextureOp::SelectArg2,
                     .color_arg2 = {.source = ArgSource::TFactor},
                     .alpha_op   = TextureOp::SelectArg1};
    lit.factor    = 0xff330000;
    CHECK(light_of(lit) == Levels{0x33, 0x33, 0x33});
    lit.fog      = {.mode = FogMode::Linear, .color = {0xff640000}};
    lit.specular = 0x33000000;
    CHECK(light_of(lit) == Levels{90, 90, 90});  // a fifth of 51, and four of 100: 90.2
    lit.stages[1].color_arg2.source = ArgSource::Diffuse;
    lit.fog                         = {};
    CHECK(light_of(lit) == Levels{255, 255, 255});
    lit.diffuse = 0xff000000;
    CHECK(light_of(lit) == Levels{-1, -1, -1});
}

TEST_CASE("light_at_vertices: every light on every colour, even over triangles, is the same",
          "[legalize][exhaustive]") {
    Frame frame            = small_frame(256, 256);
    frame.passes[0].camera = {};
    frame.cameras.clear();
    for (int x = 0; x < 256; ++x)
        frame.passes[0].draws.push_back(
            rectangle({x, 0, x + 1, 256}, 0xff000000 | static_cast<std::uint32_t>(x) * 0x010101));
    std::vector<std::uint8_t> texels;
    for (int y = 0; y < 256; ++y)
        for (const int c : {y, 255 - y, y / 2, 0}) texels.push_back(static_cast<std::uint8_t>(c));
    const TextureId column      = add_texture(frame, TextureFormat::A8R8G8B8, 1, 256, texels);
    Pass& pass                  = frame.passes.emplace_back();
    pass.color                  = {0};
    pass.state.blend            = {BlendFactor::DestColor, BlendFactor::One};
    pass.state.color_mask.alpha = false;
    pass.state.stages[0]        = kSelect;
    for (int y = 0; y < 256; ++y)
        for (const auto& [x, dy] :
             {std::pair{0.0f, 0.0f}, {256.0f, 0.0f}, {256.0f, 1.0f}, {0.0f, 0.0f}, {256.0f, 1.0f}, {0.0f, 1.0f}}) {
            frame.indices.push_back(static_cast<std::uint32_t>(frame.window_vertices.size()));
            frame.window_vertices.push_back({.x   = x,
                                             .y   = static_cast<float>(y) + dy,
                                             .uv0 = {0.5f, (static_cast<float>(y) + 0.5f) / 256.0f, 1.0f}});
        }
    DrawWindowTriangles draw{.index_count = 6 * 256, .textures = {}};
    draw.textures[0]  = bound(column);
    pass.draws        = {draw};
    const Frame other = rewritten_ps2(frame);
    CHECK(other.passes.size() == 4);
    const std::vector<std::uint32_t> want = pixels_of(frame);
    CHECK(pixels_of(other) == want);

    // The chip counts light to 0x80 and floors.
    const LegalFrame legal = legalize(frame, *find_profile("ps2"));
    CHECK(legal.left.empty());
    const std::vector<std::uint32_t> got = pixels_of(legal.frame);
    int worst                            = 0;
    for (std::size_t i = 0; i < want.size(); ++i)
        for (const int shift : {0, 8, 16})
            worst = std::max(
                worst, std::abs(static_cast<int>(got[i] >> shift & 255) - static_cast<int>(want[i] >> shift & 255)));
    CHECK(worst <= 2);
}

TEST_CASE("light_at_vertices: what it cannot evaluate is left alone", "[legalize]") {
    const std::vector<std::pair<const char*, std::function<void(Frame&, Pass&)>>> refused{
        {"other blend", [](Frame&, Pass& p) { p.state.blend.dest = BlendFactor::Zero; }},
        {"alpha written", [](Frame&, Pass& p) { p.state.color_mask.alpha = true; }},
        {"specular", [](Frame&, Pass& p) { p.state.lighting.specular_enable = true; }},
        {"alpha test", [](Frame&, Pass& p) { p.state.alpha_test.func = CompareFunc::Greater; }},
        {"no stage", [](Frame&, Pass& p) { p.state.stages = {}; }},
        {"nothing drawn", [](Frame&, Pass& p) { p.draws.clear(); }},
        {"a rectangle",
         [](Frame&, Pass& p) {
             p.draws.push_back(rectangle({0, 0, 4, 4}, 0xffffffff));
         }},
        {"a sum", [](Frame&, Pass& p) { p.state.stages[0].color_op = TextureOp::Add; }},
        {"a sum in the second stage",
         [](Frame&, Pass& p) { p.state.stages[1] = {.color_op = TextureOp::Add, .alpha_op = TextureOp::SelectArg1}; }},
        {"complement", [](Frame&, Pass& p) { p.state.stages[0].color_arg1.complement = true; }},
        {"alpha as colour", [](Frame&, Pass& p) { p.state.stages[0].color_arg1.alpha_replicate = true; }},
        {"the second colour", [](Frame&, Pass& p) { p.state.stages[0].color_arg1.source = ArgSource::Specular; }},
        {"mirrored", [](Frame&, Pass& p) { p.state.stages[0].address_u = TextureAddress::Mirror; }},
        {"nothing bound", [](Frame&, Pass& p) { (*bindings_of(p.draws[0]))[0] = {}; }},
        {"a target",
         [](Frame& f, Pass& p) {
             f.targets.push_back(f.targets[0]);
             (*bindings_of(p.draws[0]))[0] = {.texture = {}, .target = {1}};
         }},
        {"triangles with a camera",
         [](Frame& f, Pass& p) {
             f.vertices.resize(3);
             p.camera = {0};
             p.draws  = {DrawTriangles{.index_count = 3, .textures = {}}};
         }},
        {"depth that is written, so that a second pass would meet it",
         [](Frame& f, Pass& p) {
             f.targets.push_back({.name = "depth", .format = TargetFormat::D24, .width = 4, .height = 4});
             p.depth       = {1};
             p.clear.depth = 1.0f;
             p.state.depth = {.func = CompareFunc::Less, .write = true};
         }},
    };
    for (const auto& [name, change] : refused) {
        INFO(name);
        Frame frame = lit_frame({});
        change(frame, frame.passes[0]);
        CHECK(rewritten_ps2(frame) == frame);
    }
    // But not for these.
    const std::vector<std::function<void(Frame&, Pass&)>> taken{
        [](Frame&, Pass&) {}, [](Frame&, Pass& p) { p.state.stages[0].address_v = TextureAddress::Clamp; },
        [](Frame&, Pass& p) { p.state.stages[0].alpha_op = TextureOp::Add; },
        [](Frame& f, Pass& p) {
            f.targets.push_back({.name = "depth", .format = TargetFormat::D24, .width = 4, .height = 4});
            p.depth       = {1};
            p.clear.depth = 1.0f;
            p.state.depth = {.func = CompareFunc::LessEqual};
        }};
    for (const auto& change : taken) {
        Frame frame = lit_frame({});
        change(frame, frame.passes[0]);
        const Frame other = rewritten_ps2(frame);
        CHECK(other.passes.size() == 3);
        CHECK(pixels_of(other) == pixels_of(frame));
    }
    for (const char* chip : {"ideal", "dx7", "gamecube", "xbox"})
        CHECK(rewritten(lit_frame({}), &rewrite_light_at_vertices, chip) == lit_frame({}));
}

TEST_CASE("light_at_vertices: a mask of colour stays", "[legalize]") {
    Frame frame                            = lit_frame({});
    frame.passes[0].state.color_mask.green = false;
    const Frame other                      = rewritten_ps2(frame);
    CHECK(other.passes[1].state.color_mask == ColorMask{false, false, false, false});
    CHECK(pixels_of(other) == pixels_of(frame));
}
