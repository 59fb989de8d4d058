// SPDX-License-Identifier: MIT
// Programs for the GameCube, compiled against tests/support/gx_stub.h, run on the host, and what they do compared with the frame
// (tests/support/gx_check.h).
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "demo/scene.h"
#include "pipeline/emit/emit_gx.h"
#include "pipeline/frame/frame_text.h"
#include "tests/support/gx_check.h"
#include "tests/support/rewritten.h"

namespace {

using namespace pipeline;
using namespace test_support;

constexpr std::string_view kArithmetic =
    "arithmetic { pixel_center 9 filter FLIPPER_FLOOR7 combine TEV fog FLIPPER_FLOOR256 blend FLIPPER_TRUNC256 }\n";

// Nothing to be rewritten, but textures that nothing reads: the frame is the chip's own.
LegalFrame legal(const Frame& frame) {
    require_valid(frame);
    LegalFrame out = legalize(frame, *find_profile("gamecube"));
    for (const ChipFinding& finding : out.left) FAIL_CHECK(finding.where << " uses " << finding.uses);
    for (const RewriteNote& note : out.notes)
        if (note.rewrite != "unused") FAIL_CHECK(note.rewrite << " in " << note.where);
    return out;
}

std::vector<GxEvent> checked(const LegalFrame& frame, std::size_t step = 1) {
    const Emitted emitted             = emit_gx(frame, "frame.bin");
    const std::vector<GxEvent> events = run_gx(emitted.text, emitted.data);
    check_gx(frame.frame, events, emitted.data, step);
    return events;
}
std::vector<GxEvent> checked(const std::string& text) {
    return checked(legal(parsed(std::string(kArithmetic) + text)));
}

// One pass for each row, in one program, drawn with the pass given and what `set` makes of its state.
template <class Enum, class Set>
void check_each(const std::string& text, const std::vector<Enum>& values, Set set) {
    Frame frame     = parsed(std::string(kArithmetic) + text);
    const Pass pass = frame.passes.back();
    frame.passes.pop_back();
    for (const Enum value : values) {
        frame.passes.push_back(pass);
        frame.passes.back().label = std::string(enum_name(value));
        set(frame.passes.back(), value);
    }
    checked(legal(frame));
}

template <class Enum>
std::vector<Enum> without(std::vector<Enum> values, std::initializer_list<Enum> left_out) {
    std::erase_if(values,
                  [&](Enum value) { return std::find(left_out.begin(), left_out.end(), value) != left_out.end(); });
    return values;
}

const std::string kColor = "targets [ \"picture\" { format R6G6B6A6 width 12 height 8 } ]\n";
const std::string kDepth =
    "targets [ \"picture\" { format X8R8G8B8 width 12 height 8 } \"depth\" { format D24 width 12 height 8 } ]\n";
const std::string kTexels = R"(textures [ "texel" { width 2 height 2 texels [80402010 ff00ff00 11223344 55667788] }
    "light" { format L8 width 9 height 5 texels [000102030405060708 101112131415161718 202122232425262728 303132333435363738 404142434445464748] }
    "alpha" { format A8 width 16 height 8 levels 2 texels [
        00 01 02 03 04 05 06 07 08 09 0a 0b 0c 0d 0e 0f 10 11 12 13 14 15 16 17 18 19 1a 1b 1c 1d 1e 1f
        20 21 22 23 24 25 26 27 28 29 2a 2b 2c 2d 2e 2f 30 31 32 33 34 35 36 37 38 39 3a 3b 3c 3d 3e 3f
        40 41 42 43 44 45 46 47 48 49 4a 4b 4c 4d 4e 4f 50 51 52 53 54 55 56 57 58 59 5a 5b 5c 5d 5e 5f
        60 61 62 63 64 65 66 67 68 69 6a 6b 6c 6d 6e 6f 70 71 72 73 74 75 76 77 78 79 7a 7b 7c 7d 7e 7f
        80 81 82 83 84 85 86 87 88 89 8a 8b 8c 8d 8e 8f 90 91 92 93 94 95 96 97 98 99 9a 9b 9c 9d 9e 9f] } ]
)";
const std::string kTriangle =
    R"(cameras [ "eye" { projection ((1.5 0 0.1 0) (0 2 -0.2 0) (0 0 1.01 -1.01) (0 0 1 0)) } ]
vertices [ { position (-1 1 2) normal (0 0 -1) diffuse 0x80ff4020 specular 0x11223344 uv0 (0.25 0.5) uv1 (2 -3) }
    { position (1 1 3) normal (0 0.6 -0.8) diffuse 0xff00ff00 specular 0x55667788 uv0 (1 0.5) uv1 (0.125 7) }
    { position (1 -1 40) normal (0.6 0 -0.8) diffuse 0x010203ff specular 0x99aabbcc uv0 (-1 0) uv1 (1 1) } ]
indices [0 1 2 2 1 0]
)";
const std::string kDraw = R"(draws [ triangles { index_count 6 world ((0 -1 0 0.5) (1 0 0 0.25) (0 0 1 1) (0 0 0 1)) }
    rectangle { x0 1.25 y0 2 x1 7.5 y1 6 depth 0.75 color 0x12345678 } ] )";

const std::string kTexturedDraw =
    R"(draws [ triangles { index_count 6 textures [{ texture "texel" } { texture "alpha" }] }
    rectangle { x1 4 y1 4 uv [{ u0 0.5 v0 0.25 u1 2 v1 1 } { u0 -1 v0 0 u1 1 v1 3 }] textures [{ texture "light" } { texture "texel" }] }
    rectangle { x1 4 y1 4 textures [{ texture "alpha" } { texture "light" }] }
    rectangle { x1 4 y1 4 } ] )";

}  // namespace

TEST_CASE("GX: each comparison, for depth and for alpha", "[emit][gx]") {
    check_each(
        kDepth + kTriangle + "passes [ \"p\" { color \"picture\" depth \"depth\" camera \"eye\" " + kDraw + "} ]",
        all_of<CompareFunc>(), [](Pass& pass, CompareFunc func) {
            pass.state.depth      = {func, func != CompareFunc::Less};
            pass.state.alpha_test = {func, static_cast<std::uint8_t>(17 + 10 * static_cast<int>(func)),
                                     AlphaFail::Keep};
        });
}

TEST_CASE("GX: each blend factor on its side", "[emit][gx]") {
    using enum BlendFactor;
    const std::string text = kColor +
                             "passes [ \"p\" { color \"picture\" "
                             "draws [ rectangle { x1 4 y1 4 } ] } ]";
    check_each(text, without(all_of<BlendFactor>(), {SourceColor, InvSourceColor}), [](Pass& pass, BlendFactor factor) {
        pass.state.blend = {factor, InvSourceAlpha};
    });
    check_each(text, without(all_of<BlendFactor>(), {DestColor, InvDestColor}), [](Pass& pass, BlendFactor factor) {
        pass.state.blend = {DestAlpha, factor};
    });
}

TEST_CASE("GX: masks, dither, culling, viewport and scissor", "[emit][gx]") {
    const std::string text = kColor + kTriangle + "passes [ \"p\" { color \"picture\" camera \"eye\" " + kDraw + "} ]";
    check_each(text, all_of<CullMode>(), [](Pass& pass, CullMode mode) { pass.state.cull = mode; });
    check_each(text, without(all_of<DitherMode>(), {DitherMode::GsDimx}),
               [](Pass& pass, DitherMode mode) { pass.state.dither.mode = mode; });
    Frame frame = parsed(std::string(kArithmetic) + text);
    for (int i = 0; i < 3; ++i) {
        Pass& pass            = frame.passes.emplace_back(frame.passes.front());
        pass.clear.color      = Argb{0x11223344u + static_cast<std::uint32_t>(i)};
        pass.state.color_mask = {i == 0, i == 0, i == 0, i == 1};
        pass.state.viewport   = {1, 2, 10, 7};
        if (i == 1) pass.state.scissor = {3, 1, 12, 5};
    }
    checked(legal(frame));
}

TEST_CASE("GX: each function of stages, on each source and texture", "[emit][gx]") {
    const std::string text =
        kColor + kTexels + kTriangle + "passes [ \"p\" { color \"picture\" camera \"eye\" " + kTexturedDraw + "} ]";
    const std::vector<TextureOp> ops = without(all_of<TextureOp>(), {TextureOp::Disable});
    for (const ArgSource source : all_of<ArgSource>()) {
        for (const bool replicate : {false, true}) {
            check_each(text, ops, [&](Pass& pass, TextureOp op) {
                pass.state.texture_factor = {0x8040ff20};
                TextureStage& one         = pass.state.stages[0];
                one.color_op = one.alpha_op = op;
                one.color_arg1 = one.alpha_arg1 = {source, false, replicate};
                one.color_arg2 = one.alpha_arg2 = {ArgSource::Texture};
                one.address_u = one.address_v = TextureAddress::Clamp;
                TextureStage& two             = pass.state.stages[1];
                two.color_op = two.alpha_op = op;
                two.color_arg1 = two.alpha_arg1 = {ArgSource::Current, false, replicate};
                two.color_arg2 = two.alpha_arg2 = {source};
                two.coords                      = CoordSource::Vertex1;
                two.address_u = two.address_v = TextureAddress::Clamp;
            });
        }
    }
}

TEST_CASE("GX: specular goes through a register where both vertex colours meet", "[emit][gx]") {
    const std::vector<GxEvent> events = checked(kColor + kTriangle + R"(passes [ "p" { color "picture" camera "eye"
        clear { color 0x00000000 }
        state { lighting { specular_enable true } stages [{ color_op ADD color_arg1 { source DIFFUSE } color_arg2 { source SPECULAR }
            alpha_op SUBTRACT alpha_arg1 { source SPECULAR } alpha_arg2 { source DIFFUSE } }] }
        draws [ triangles { index_count 6 } ] } ])");
    REQUIRE(events.size() == 3);
    CHECK(events[1].registers.tev_stages == 3);
    CHECK(events[1].registers.tev[0].color_op[4] == 2);  // GX_TEVREG1
}

TEST_CASE("GX: a texture in the second stage alone has the first coordinate", "[emit][gx]") {
    const std::vector<GxEvent> events =
        checked(kColor + kTexels + kTriangle + R"(passes [ "p" { color "picture" camera "eye"
        clear { color 0x00000000 }
        state { stages [{ color_op SELECTARG2 alpha_op SELECTARG2 } { color_op MODULATE alpha_op MODULATE coords VERTEX1 }] }
        draws [ triangles { index_count 6 textures [{} { texture "texel" }] }
            rectangle { x1 4 y1 4 textures [{} { texture "alpha" }] } ] } ])");
    CHECK(events.at(1).registers.texgens == 1);
}

TEST_CASE("GX: addresses, filters and mip levels", "[emit][gx]") {
    const std::string text = kColor + kTexels + R"(passes [ "p" { color "picture"
        state { stages [{ color_op SELECTARG1 alpha_op SELECTARG1 }] } draws [ rectangle { x1 4 y1 4 textures [{ texture "alpha" }] } ] } ])";
    check_each(text, all_of<TextureAddress>(), [](Pass& pass, TextureAddress address) {
        pass.state.stages[0].address_u = address;
        pass.state.stages[0].address_v = TextureAddress::Mirror;
    });
    for (const TextureFilter filter : all_of<TextureFilter>())
        check_each(text, all_of<MipFilter>(), [&](Pass& pass, MipFilter mips) {
            pass.state.stages[0].filter     = filter;
            pass.state.stages[0].mip_filter = mips;
        });
}

TEST_CASE("GX: fog is the chip's by depth, the TEV's by distance", "[emit][gx]") {
    const std::string text = kColor + kTriangle + "passes [ \"p\" { color \"picture\" camera \"eye\" " + kDraw + "} ]";
    const auto set = [](Pass& pass, FogMode mode) { pass.state.fog = {mode, {0x00204060}, 2.0f, 45.0f, 0.03f, false}; };
    check_each(text, all_of<FogMode>(), set);
    for (const bool range : {false, true}) {
        Frame frame = parsed(std::string(kArithmetic) + text);
        set(frame.passes[0], FogMode::Exp);
        frame.passes[0].state.fog.range   = range;
        const std::vector<GxEvent> events = checked(legal(frame));
        const auto triangle =
            std::find_if(events.begin(), events.end(), [](const GxEvent& event) { return event.primitive == 0x90; });
        REQUIRE(triangle != events.end());
        CHECK(triangle->registers.fog[0] == (range ? 0.0 : 4.0));
        CHECK(triangle->registers.tev_stages == (range ? 2 : 1));
    }
}

TEST_CASE("GX: projections of both kinds, and others by their rows", "[emit][gx]") {
    struct Row {
        const char* projection;
        int type;
    };
    const Row row =
        GENERATE(Row{"((1.5 0 0.1 0) (0 2 -0.2 0) (0 0 1.01 -1.01) (0 0 1 0))", 0},      // along +z
                 Row{"((1.5 0 0.1 0) (0 2 -0.2 0) (0 0 -1.01 -1.01) (0 0 -1 0))", 0},    // along -z
                 Row{"((3 0 0.2 0) (0 4 -0.4 0) (0 0 -0.02 2.02) (0 0 2 0))", 0},        // w times 2, depth reversed
                 Row{"((1.5 0 0 0) (0 2 0 0) (0 0 1.5 -3) (0 0 1 0))", 0},               // from 2 to 6
                 Row{"((0.25 0 0 -1) (0 0.5 0 0.25) (0 0 0.02 -0.01) (0 0 0 1))", 1},    // orthographic
                 Row{"((0.5 0 0 -2) (0 1 0 0.5) (0 0 -0.04 2) (0 0 0 2))", 1},           // reversed, w = 2
                 Row{"((1.5 0.5 0 0) (0 2 0 0.1) (0 0 1.01 -1.01) (0 0 1 0))", 0},       // sheared
                 Row{"((1.5 0 0 0) (0 2 0 0) (0.101 0 1.01 -1.01) (0.1 0 1 0))", 0},     // w of x as well
                 Row{"((0.25 0.1 0 -1) (0 0.5 0 0.25) (0 0.01 0.02 0) (0 0 0 1))", 1});  // oblique
    INFO(row.projection);
    Frame frame =
        parsed(std::string(kArithmetic) + kColor + kTriangle +
               "passes [ \"p\" { color \"picture\" camera \"eye\" clear { color 0x00000000 } " + kDraw + "} ]");
    frame.cameras = parsed("cameras [ { view ((1 0 0 0.5) (0 0.8 -0.6 0) (0 0.6 0.8 2) (0 0 0 1)) projection " +
                           std::string(row.projection) + " } ]")
                        .cameras;
    const std::vector<GxEvent> events = checked(legal(frame));
    CHECK(events.at(1).registers.projection_type == row.type);
    // With fog by depth, whichever way it is done.
    frame.passes[0].state.fog = {FogMode::Linear, {0x00204060}, 1.0f, 45.0f, 1.0f, false};
    checked(legal(frame));
}

TEST_CASE("GX: depth is no function of w: refused", "[emit][gx]") {
    Frame frame                       = parsed(std::string(kArithmetic) + kColor + kTriangle +
                                               "passes [ \"p\" { color \"picture\" camera \"eye\" " + kDraw + "} ]");
    frame.cameras[0].projection[0][2] = 0.3f;
    CHECK_THROWS_AS(emit_gx(legal(frame), "frame.bin"), std::invalid_argument);
}

TEST_CASE("GX: coordinates from the camera", "[emit][gx]") {
    checked(kColor + kTexels + kTriangle + R"(passes [ "p" { color "picture" camera "eye"
        state { stages [{ color_op SELECTARG1 alpha_op SELECTARG1 coords CAMERAPOSITION transform ((2 0 0.5 0.25) (0 3 0.5 1) (0 0.5 1 0) (0 0 0 1)) }
            { color_op MODULATE alpha_op SELECTARG1 coords VERTEX1 }] }
        draws [ triangles { index_count 6 world ((0 -1 0 0.5) (1 0 0 0.25) (0 0 1 1) (0 0 0 1)) textures [{ texture "texel" } { texture "alpha" }] } ] } ])");
}

TEST_CASE("GX: the chip's lights where they say the same", "[emit][gx]") {
    struct Row {
        const char* lighting;
        bool by_chip;
    };
    const Row row = GENERATE(
        Row{"lights [ { direction (0 0 1) diffuse (0.5 0.25 1) } ] diffuse_source MATERIAL material { diffuse (0.5 1 0.75 0.5) }",
            true},
        Row{"lights [ { direction (0 -1 2) diffuse (0.5 0.25 0.125) ambient (0.1 0.2 0) } { direction (1 0 0) } ] ambient (0.25 0 0) diffuse_source MATERIAL material { diffuse (0.5 0.5 0.5 1) emissive (0 0 0.2) }",
            true},
        Row{"lights [ { direction (0 0 1) diffuse (0.5 0.25 1) } ]", true},  // the vertex's colour
        Row{"lights [ { direction (0 0 1) diffuse (0.5 0.25 0.5) } ] ambient (0.25 0.1 0) ambient_source COLOR1", true},
        Row{"lights [ { type POINT position (0 1 -2) attenuation (0.5 0.25 0.125) diffuse (2 1 0.5) } ] diffuse_source MATERIAL",
            true},
        Row{"lights [ { type POINT position (0 1 -2) attenuation (1 0 0) range 5 } ] diffuse_source MATERIAL",
            false},  // cut
        Row{"lights [ { direction (0 0 1) diffuse (-0.5 1 1) } ] ambient (1 1 1) diffuse_source MATERIAL",
            false},                                                            // takes away
        Row{"lights [ { direction (0 0 1) diffuse (3 3 3) } ]", false},        // cut before the material
        Row{"lights [ { direction (0 0 1) } ] ambient (0.5 0.5 0.5)", false},  // ambient beside a vertex's colour
        Row{"lights [ { direction (0 0 1) specular (1 1 1) } ] specular_enable true specular_source MATERIAL material { specular (1 1 1) power 5 }",
            false},
        Row{"lights [ { direction (0 0 1) } ] diffuse_source COLOR2", false});
    INFO(row.lighting);
    const std::vector<GxEvent> events = checked(
        kColor + kTriangle +
        "passes [ \"p\" { color \"picture\" camera \"eye\" clear { color 0x00000000 } state { lighting { enabled true " +
        row.lighting + " } } " + kDraw + "} ]");
    CHECK(events.at(1).registers.channel.at(0)[0] == (row.by_chip ? 1 : 0));
}

TEST_CASE("GX: normals that lengthen are lit for the vertices unless they are made unit vectors", "[emit][gx]") {
    const std::string text =
        kColor + kTriangle + R"(passes [ "p" { color "picture" camera "eye" clear { color 0x00000000 }
        state { lighting { enabled true diffuse_source MATERIAL lights [ { direction (0 0 1) diffuse (0.4 0.4 0.4) } ] } }
        draws [ triangles { index_count 6 world ((2 0 0 0) (0 2 0 0) (0 0 2 0) (0 0 0 1)) } ] } ])";
    Frame frame = parsed(std::string(kArithmetic) + text);
    CHECK(checked(legal(frame)).at(1).registers.channel.at(0)[0] == 0);
    frame.passes[0].state.lighting.normalize_normals = true;
    CHECK(checked(legal(frame)).at(1).registers.channel.at(0)[0] == 1);
}

TEST_CASE("GX: targets in one frame buffer, copies, and what is read of them", "[emit][gx]") {
    const std::vector<GxEvent> events = checked(R"(
targets [ "picture" { format X8R8G8B8 width 16 height 12 } "depth" { format D24 width 16 height 12 }
    "cloud" { format R6G6B6A6 width 18 height 10 } "copy" { width 18 height 9 } "half" { width 9 height 5 } ]
passes [
    "scene" { color "picture" depth "depth" clear { color 0xff102030 depth 1 } state { depth { func LESSEQUAL write true } }
        draws [ rectangle { x1 8 y1 8 depth 0.5 } ] }
    "cloud" { color "cloud" draws [ rectangle { x0 2 x1 8 y1 8 color 0x80ffffff } ] }
    "to copy" { color "copy" draws [ copy { source "cloud" from { x0 2 y0 2 x1 16 y1 6 } x 4 y 4 } ] }
    "halve" { color "half" draws [ copy { source "cloud" from { x1 18 y1 10 } halve true } ] }
    "over" { color "picture" depth "depth" state { blend { source SRCALPHA dest INVSRCALPHA } depth { func GREATER }
            stages [{ color_op SELECTARG1 alpha_op SELECTARG1 filter LINEAR address_u CLAMP address_v CLAMP } { color_op ADD alpha_op MODULATE address_u CLAMP address_v CLAMP }] }
        draws [ rectangle { x1 16 y1 12 depth 1 textures [{ target "half" } { target "copy" }] } ] }
])");
    // Scene's clear and rectangle; the cloud's rectangle; two copies, each after zeros where it is the first to look; the last;
    // the display.
    std::vector<GxEvent> copies;
    std::copy_if(events.begin(), events.end(), std::back_inserter(copies),
                 [](const GxEvent& event) { return event.kind == GxEvent::Kind::Copy; });
    REQUIRE(copies.size() == 2);
    const GxEvent &cloud = events.at(2), &last = events.at(events.size() - 2);
    CHECK(cloud.registers.scissor[0] == 16);  // beside the larger one
    CHECK(copies[0].copy_from ==
          std::array<int, 4>{cloud.registers.scissor[0] + 2, cloud.registers.scissor[1] + 2, 14, 4});
    // Tile (1, 1) of 5 in a row, 64 bytes each.
    CHECK((copies[0].address - last.registers.textures.at(1).address) == (5 + 1) * 64);
    CHECK(last.registers.textures.at(0).address == copies[1].address);
}

TEST_CASE("GX: a copied target, or none drawn to, can be the picture", "[emit][gx]") {
    checked(R"(targets [ "picture" { width 8 height 4 } "buffer" { format R6G6B6A6 width 16 height 8 } ]
passes [ "halve" { color "picture" draws [ copy { source "buffer" from { x1 16 y1 8 } halve true } ] } ])");
    const Frame frame     = parsed(std::string(kArithmetic) + kColor);
    const Emitted undrawn = emit_gx(legal(frame), "frame.bin");
    CHECK(run_gx(undrawn.text, undrawn.data).size() == 2);  // zeros, display
}

TEST_CASE("GX: depth alone is drawn, and cleared", "[emit][gx]") {
    checked(R"(targets [ "picture" { format X8R8G8B8 width 8 height 4 } "depth" { format D24 width 8 height 4 } ]
passes [ "depth" { depth "depth" clear { depth 0.5 } state { depth { func LESS write true } } draws [ rectangle { x1 4 y1 4 depth 0.25 } ] }
    "color" { color "picture" depth "depth" state { depth { func EQUAL } } draws [ rectangle { x1 8 y1 4 depth 0.25 color 0xff00ff00 } ] } ])");
}

TEST_CASE("GX: more vertices than an index of 16 bits reaches", "[emit][gx]") {
    Frame frame =
        parsed(std::string(kArithmetic) + kColor + kTriangle +
               "passes [ \"p\" { color \"picture\" camera \"eye\" state { fog { mode LINEAR end 40 range true } } " +
               kDraw + "} ]");
    const std::vector<Vertex> three = frame.vertices;
    frame.vertices.clear();
    for (std::uint32_t i = 0; i < 150000; ++i) {
        frame.vertices.push_back(three[i % 3]);
        frame.vertices.back().position.x += static_cast<float>(i) / 65536.0f;
    }
    frame.indices.clear();
    for (std::uint32_t i = 0; i + 3 <= 90000; i += 3) frame.indices.insert(frame.indices.end(), {i, i + 1, i + 2});
    frame.indices.insert(frame.indices.end(),
                         {0u, 70000u, 140000u, 140000u, 149999u, 1u, 65535u, 65536u, 65537u, 0u, 65534u, 65535u});
    auto& draw                        = std::get<DrawTriangles>(frame.passes[0].draws[0]);
    draw.index_count                  = static_cast<std::uint32_t>(frame.indices.size());
    const std::vector<GxEvent> events = checked(legal(frame), 101);
    CHECK(events.size() >= 5);
    // The three triangles whose corners are far apart, every corner.
    Frame last                                                   = frame;
    std::get<DrawTriangles>(last.passes[0].draws[0]).first_index = 90000;
    std::get<DrawTriangles>(last.passes[0].draws[0]).index_count = 12;
    checked(legal(last));
}

TEST_CASE("GX: the test frames that the chip can draw", "[emit][gx]") {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(NIMBUS7_SOURCE_DIR "/demo/frames")) {
        INFO(entry.path().filename().string());
        std::ostringstream text;
        text << std::ifstream(entry.path()).rdbuf();
        const LegalFrame frame = legalize(parse_frame(text.str()), *find_profile("gamecube"));
        if (!frame.left.empty()) continue;
        // Each is a program to compile: every other one will do.
        if (count++ % 2 == 0) checked(frame);
    }
    CHECK(count >= 40);
}

TEST_CASE("GX: the canyon", "[emit][gx]") {
    Frame frame      = demo::scene_frame(*demo::load_scene("canyon"), {64, 48}, 0);
    LegalFrame whole = legalize(frame, *find_profile("gamecube"));
    if (!whole.left.empty()) {
        // What draws to the picture, and reads no other target.
        std::erase_if(whole.frame.passes, [&](const Pass& pass) {
            return pass.color != whole.frame.output ||
                   std::any_of(pass.draws.begin(), pass.draws.end(), [](const Draw& draw) {
                       const TextureBindings textures = textures_of(draw);
                       return std::any_of(textures.begin(), textures.end(),
                                          [](const TextureBinding& b) { return static_cast<bool>(b.target); });
                   });
        });
        whole.left = check(whole.frame, *find_profile("gamecube"));
    }
    REQUIRE(whole.left.empty());
    REQUIRE(whole.frame.passes.size() >= 6);
    const std::vector<GxEvent> events = checked(whole, 37);
    CHECK(events.size() > whole.frame.passes.size());
    const Emitted once = emit_gx(whole, "frame.bin"), again = emit_gx(whole, "frame.bin");
    CHECK(once.text == again.text);
    CHECK(once.data == again.data);
}

TEST_CASE("GX: a frame that the chip cannot draw is refused, and a name that C cannot spell", "[emit][gx]") {
    LegalFrame frame = legal(parsed(std::string(kArithmetic) + kColor +
                                    R"(passes [ "p" { color "picture" draws [ rectangle { x1 4 y1 4 } ] } ])"));
    CHECK_NOTHROW(emit_gx(frame, "frame data.bin"));
    CHECK_THROWS_AS(emit_gx(frame, ""), std::invalid_argument);
    CHECK_THROWS_AS(emit_gx(frame, "a\"b"), std::invalid_argument);
    CHECK_THROWS_AS(emit_gx(frame, "a\\b"), std::invalid_argument);
    frame.left.push_back({"pass 0 'p': state.dest_alpha_test", "states", "ONE", "none"});
    CHECK_THROWS_WITH(emit_gx(frame, "frame.bin"),
                      Catch::Contains("pass 0 'p': state.dest_alpha_test: uses ONE; the chip has none"));
}

TEST_CASE("GX: labels cannot end a comment", "[emit][gx]") {
    checked(kColor + R"(passes [ "p */ #error // /* \\" { color "picture" clear { color 0x01020304 } } ])");
}
