// SPDX-License-Identifier: MIT
// Surfaces, rectangles, copies, lights, and what lies in the side file.
#include <bit>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <cstring>

#include "pipeline/emit/dx7_data.h"
#include "pipeline/emit/dx7_text.h"
#include "pipeline/emit/emit_dx7.h"
#include "pipeline/frame/frame_text.h"

using namespace pipeline;

namespace {

Frame parsed(const std::string& text) {
    return parse_frame("nimbus7 frame 1\narithmetic { snap TRUNCATE pixel_center 0 }\n" + text);
}

std::string emitted_text(const Frame& frame) {
    CHECK(check(frame, *find_profile("dx7")) == std::vector<ChipFinding>{});
    return emit_dx7({.frame = frame, .notes = {}, .left = {}}, "frame.bin").text;
}

std::string pass_text(const std::string& text, int pass) {
    const std::size_t from = text.find("static void pass_" + std::to_string(pass) + "() {"),
                      to   = text.find("\n}\n", from);
    REQUIRE(to != std::string::npos);
    return text.substr(from, to + 3 - from);
}

int count_of(const std::string& text, const std::string& words) {
    int count = 0;
    for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++count;
    return count;
}

template <class Word>
Word word_at(const std::vector<std::uint8_t>& bytes, std::size_t place) {
    if (place + sizeof(Word) > bytes.size()) FAIL("beyond the side file");
    Word word = 0;
    for (std::size_t i = sizeof(Word); i-- > 0;)
        word = static_cast<Word>(word << 8 * (sizeof(Word) > 1) | bytes[place + i]);
    return word;
}
float float_at(const std::vector<std::uint8_t>& bytes, std::size_t place) {
    return std::bit_cast<float>(word_at<std::uint32_t>(bytes, place));
}

Vertex vertex_at(const std::vector<std::uint8_t>& bytes, std::size_t place) {
    const auto number = [&](std::size_t i) { return float_at(bytes, place + 4 * i); };
    return {.position = {number(0), number(1), number(2)},
            .normal   = {number(3), number(4), number(5)},
            .diffuse  = {word_at<std::uint32_t>(bytes, place + 24)},
            .specular = {word_at<std::uint32_t>(bytes, place + 28)},
            .uv0      = {number(8), number(9)},
            .uv1      = {number(10), number(11)}};
}

// The vertices that a draw's meshes name, corner by corner.
std::vector<Vertex> corners_of(const dx7::Data& data, const dx7::MeshRange& range) {
    std::vector<Vertex> corners;
    for (std::size_t i = range.first; i < range.first + range.count; ++i) {
        const dx7::Mesh& mesh = data.meshes[i];
        for (std::size_t k = 0; k < mesh.index_count; ++k) {
            const std::size_t index = word_at<std::uint16_t>(data.bytes, mesh.indices + 2 * k);
            if (index >= mesh.vertex_count) FAIL("an index beyond the mesh");
            corners.push_back(vertex_at(data.bytes, mesh.vertices + dx7::kVertexBytes * index));
        }
    }
    return corners;
}

}  // namespace

TEST_CASE("Direct3D 7: what check has left is refused, and named", "[emit]") {
    LegalFrame legal{
        .frame = parsed("output #0 targets [ \"picture\" { width 4 height 4 } ]"), .notes = {}, .left = {}};
    CHECK_NOTHROW(emit_dx7(legal, "frame.bin"));
    legal.left = {{"pass 3 'glow': state.scissor", "states", "x1 3", "none"}, {"frame", "memory", "", ""}};
    CHECK_THROWS_AS(emit_dx7(legal, "frame.bin"), std::invalid_argument);
    CHECK_THROWS_WITH(emit_dx7(legal, "frame.bin"),
                      "Direct3D 7 cannot draw this frame: pass 3 'glow': state.scissor: "
                      "uses x1 3; the chip has none, and 1 more");
}

TEST_CASE("Direct3D 7: numbers read back to the same bits", "[emit]") {
    for (const float value : {0.0f, -0.0f, 1.0f, 0.1f, -1e-45f, 3.4028235e38f, 16777216.0f, 1e9f, -0.5f}) {
        const std::string text = dx7::literal(value);
        INFO(text);
        CHECK(text.find_first_of(".e") != std::string::npos);
        CHECK(text.back() == 'f');
        CHECK(std::bit_cast<std::uint32_t>(std::strtof(text.c_str(), nullptr)) == std::bit_cast<std::uint32_t>(value));
    }
    CHECK(dx7::literal(std::string_view("a\\b\"\n1")) == R"("a\\b\"\0121")");
}

TEST_CASE("Direct3D 7: rectangles are neither culled nor fogged, and bring their coordinates", "[emit]") {
    const std::string pass      = pass_text(emitted_text(parsed(R"(
output "picture"
targets [ "picture" { width 16 height 8 } "other" { width 4 height 4 } ]
cameras [ "eye" {} ]
vertices columns (position) [ (0 0 0) ]
indices [0 0 0]
passes [
    "all" {
        color "picture" camera "eye"
        state {
            cull CCW fog { mode EXP density 2 } shade FLAT
            stages [{ color_op MODULATE alpha_op MODULATE coords CAMERAPOSITION transform ((2 0 0 0) (0 2 0 0) (0 0 1 0) (0 0 0 1)) }]
        }
        draws [
            rectangle { x0 -0.5 y0 -0.5 x1 7.5 y1 3.25 depth 0.125 color 0x80ffffff uv [{ u0 0.5 u1 2 }] textures [{ target "other" }] }
            triangles { index_count 3 textures [{ target "other" }] }
        ]
    }
]
)")),
                                            0);
    const std::string rectangle = R"(    TRY(device->SetRenderState(D3DRENDERSTATE_SHADEMODE, D3DSHADE_FLAT));
    TRY(device->SetTextureStageState(0, D3DTSS_COLOROP, D3DTOP_MODULATE));
    TRY(device->SetTextureStageState(0, D3DTSS_ALPHAOP, D3DTOP_MODULATE));
    TRY(device->BeginScene());
    TRY(device->SetTexture(0, targets[1]));  // 'other'
    draw_rectangle(-0.5f, -0.5f, 7.5f, 3.25f, 0.125f, 0x80ffffff, {0.5f, 0.0f, 2.0f, 1.0f}, {0.0f, 0.0f, 1.0f, 1.0f});
    TRY(device->SetRenderState(D3DRENDERSTATE_CULLMODE, D3DCULL_CCW));
    TRY(device->SetRenderState(D3DRENDERSTATE_FOGENABLE, TRUE));
    TRY(device->SetRenderState(D3DRENDERSTATE_FOGVERTEXMODE, D3DFOG_EXP));
    TRY(device->SetRenderState(D3DRENDERSTATE_FOGDENSITY, as_dword(2.0f)));
    TRY(device->SetTextureStageState(0, D3DTSS_TEXCOORDINDEX, D3DTSS_TCI_CAMERASPACEPOSITION));
    TRY(device->SetTextureStageState(0, D3DTSS_TEXTURETRANSFORMFLAGS, D3DTTFF_COUNT3 | D3DTTFF_PROJECTED));
    set_transform(D3DTRANSFORMSTATE_WORLD, )";
    INFO(pass);
    CHECK(pass.find(rectangle) != std::string::npos);
    CHECK(pass.find("set_transform(D3DTRANSFORMSTATE_TEXTURE0, {2.0f, 0.0f, 0.0f, 0.0f, 0.0f, 2.0f,") !=
          std::string::npos);
}

TEST_CASE("Direct3D 7: window triangles bring their fog", "[emit]") {
    const std::string text = emitted_text(parsed(R"(
output "picture"
targets [ "picture" { width 16 height 8 } ]
window_vertices columns (x y z rhw diffuse specular uv0 uv1) [
    1 2 0.5 0.25 0x01020304 0x80060708 (6 3 2) (9 9 9)
]
indices [0 0 0]
passes [
    "all" {
        color "picture"
        state { cull CW fog { mode EXP density 2 color 0xff010203 } stages [{ color_op MODULATE alpha_op MODULATE }] }
        draws [ window_triangles { index_count 3 } ]
    }
]
)"));
    const std::string pass = pass_text(text, 0);
    CHECK(count_of(pass, "CULLMODE, D3DCULL_CW)") == 1);
    CHECK(count_of(pass, "FOGENABLE, TRUE)") == 1);
    CHECK(count_of(pass, "FOGCOLOR, 0xff010203)") == 1);
    CHECK(count_of(pass, "FOGVERTEXMODE") == 0);
    CHECK(count_of(pass, "TRANSFORMSTATE") == 0);
    CHECK(count_of(pass, "draw_mesh(0);") == 1);
    CHECK(count_of(text, "    {true, 0, 1, 48, 3},  // 0 from the frame's index 0 on\n") == 1);
}

TEST_CASE("Direct3D 7: window vertices are divided by the q of the stage that reads them", "[emit]") {
    Frame frame        = parsed(R"(
output "picture"
targets [ "picture" { width 16 height 8 } ]
window_vertices columns (x y z rhw diffuse specular uv0 uv1) [
    1 2 0.5 0.25 0x01020304 0x80060708 (6 3 2) (8 12 4)
]
indices [0 0 0]
passes [ "all" { color "picture" draws [ window_triangles { index_count 3 } ] } ]
)");
    const auto numbers = [&] {
        const dx7::Data data = dx7::make_data(frame);
        std::vector<float> all;
        for (const std::size_t place : {0, 4, 8, 12, 24, 28, 32, 36}) all.push_back(float_at(data.bytes, place));
        CHECK(word_at<std::uint32_t>(data.bytes, 16) == 0x01020304);
        CHECK(word_at<std::uint32_t>(data.bytes, 20) == 0x80060708);
        return all;
    };
    CHECK(numbers() == std::vector<float>{1, 2, 0.5f, 0.25f, 6, 3, 8, 12});
    TextureStage reads;
    reads.color_op = reads.alpha_op = TextureOp::SelectArg1;
    frame.passes[0].state.stages[0] = reads;
    CHECK(numbers() == std::vector<float>{1, 2, 0.5f, 0.5f, 3, 1.5f, 4, 6});
    frame.passes[0].state.stages[1] = reads;
    CHECK_THROWS_WITH(dx7::make_data(frame),
                      "pass 0 'all': window vertex 0 has coordinates whose q is not above 0, or "
                      "differs between the stages");
    frame.passes[0].state.stages[0].color_arg1.source = frame.passes[0].state.stages[0].alpha_arg1.source =
        ArgSource::Diffuse;
    CHECK(numbers() == std::vector<float>{1, 2, 0.5f, 1, 1.5f, 0.75f, 2, 3});
}

TEST_CASE("Direct3D 7: surfaces", "[emit]") {
    const std::string text = emitted_text(parsed(R"(
output "picture"
targets [
    "picture" { width 16 height 8 }
    "shadow" { format D16 width 12 height 4 }
    "unused" { format PSMCT16 width 3 height 3 }
    "read" { format R5G6B5 width 16 height 8 }
    "cleared" { format A1R5G5B5 width 16 height 8 }
    "copied" { width 16 height 8 }
]
cameras [ "eye" {} ]
vertices columns (position) [ (0 0 0) ]
indices [0 0 0]
passes [
    "depth alone" { depth "shadow" camera "eye" clear { depth 1 } state { depth { func LESS write true } } draws [ triangles { index_count 3 } ] }
    "clear" { color "cleared" clear { color 0x00000000 } state { viewport { x1 16 y1 8 } } }
    "part" { color "read" clear { color 0x00000000 } state { viewport { x0 1 x1 16 y1 8 } } }
    "copy" { color "picture" draws [ copy { source "copied" from { x0 2 y0 1 x1 9 y1 3 } x 5 y 4 } ] }
    "blit" { color "picture" state { stages [{ color_op SELECTARG1 alpha_op SELECTARG1 }] } draws [ rectangle { x1 2 y1 2 textures [{ target "read" }] } ] }
    "nothing" { color "picture" }
]
)"));
    for (const char* line :
         {R"(    {"picture", A8R8G8B8, 16, 8, true, false, true},  // 0 )",
          R"(    {"shadow", D16, 12, 4, true, false, false},  // 1 )",
          R"(    {"unused", A8R8G8B8, 3, 3, false, false, false},  // 2 not used)",
          R"(    {"read", R5G6B5, 16, 8, true, true, true},  // 3 )",
          R"(    {"cleared", A1R5G5B5, 16, 8, true, false, false},  // 4 )",
          R"(    {"copied", A8R8G8B8, 16, 8, true, false, true},  // 5 )",
          R"(    {"spare", A8R8G8B8, 12, 4, true, false, false},  // 6 for passes that draw depth alone)",
          "    {pass_0, -1},", "    {pass_1, 4},", "    {pass_3, 0},", "    {pass_5, -1},"}) {
        INFO(line);
        CHECK(count_of(text, std::string(line) + '\n') == 1);
    }
    CHECK(count_of(pass_text(text, 0), "begin_pass(targets[6], targets[1], 0, 0, 12, 4);") == 1);
    CHECK(count_of(pass_text(text, 0), "Clear(0, nullptr, D3DCLEAR_ZBUFFER, 0x00000000, 1.0f, 0)") == 1);
    CHECK(pass_text(text, 1) ==
          "static void pass_1() {\n    // to 'cleared'\n    begin_pass(targets[4], nullptr, 0, 0, 16, "
          "8);\n    TRY(device->Clear(0, nullptr, D3DCLEAR_TARGET, 0x00000000, 1.0f, 0));\n}\n");
    CHECK(pass_text(text, 3) ==
          "static void pass_3() {\n    copy(targets[0], 5, 4, targets[5], {2, 1, 9, 3});  // "
          "'copied'\n}\n");
    CHECK(pass_text(text, 5) == "static void pass_5() {\n    // Nothing is cleared or drawn.\n}\n");
}

TEST_CASE("Direct3D 7: material and lights", "[emit]") {
    Frame frame             = parsed(R"(
output "picture"
targets [ "picture" { width 16 height 8 } ]
cameras [ "eye" {} ]
vertices columns (position) [ (0 0 0) ]
indices [0 0 0]
passes [
    "lit" {
        color "picture" camera "eye"
        state { lighting { enabled true local_viewer false normalize_normals true
            material { diffuse (1 0.5 0.25 0.75) ambient (0 1 0) specular (0 0 2) emissive (0.1 0 0) power 8 }
            lights [ { type POINT diffuse (-1 0 0) specular (0 1 0) ambient (0 0 1) position (1 2 3) range 1e38 attenuation (0 1 0.5) }
                     { direction (0 -1 0) } ] } }
        draws [ triangles { index_count 3 } ]
    }
]
)");
    LightingState& lighting = frame.passes[0].state.lighting;
    const auto pass         = [&] { return pass_text(emitted_text(frame), 0); };
    const std::string text  = pass();
    for (const char* line : {"LIGHTING, TRUE));",
                             "LOCALVIEWER, FALSE));",
                             "NORMALIZENORMALS, TRUE));",
                             "material.dcvDiffuse = color(1.0f, 0.5f, 0.25f, 0.75f);",
                             "material.dcvAmbient = color(0.0f, 1.0f, 0.0f, 1.0f);",
                             "material.dcvSpecular = color(0.0f, 0.0f, 2.0f, 1.0f);",
                             "material.dcvEmissive = color(0.1f, 0.0f, 0.0f, 1.0f);",
                             "material.dvPower = 8.0f;",
                             "TRY(device->SetMaterial(&material));",
                             "light_0.dltType = D3DLIGHT_POINT;",
                             "light_0.dcvDiffuse = color(-1.0f, 0.0f, 0.0f, 1.0f);",
                             "light_0.dcvSpecular = color(0.0f, 1.0f, 0.0f, 1.0f);",
                             "light_0.dcvAmbient = color(0.0f, 0.0f, 1.0f, 1.0f);",
                             "light_0.dvPosition = vector(1.0f, 2.0f, 3.0f);",
                             "light_0.dvRange = 1.8446743e+19f;",  // D3DLIGHT_RANGE_MAX
                             "light_0.dvAttenuation0 = 0.0f;",
                             "light_0.dvAttenuation1 = 1.0f;",
                             "light_0.dvAttenuation2 = 0.5f;",
                             "TRY(device->SetLight(0, &light_0));",
                             "TRY(device->LightEnable(0, TRUE));",
                             "light_1.dltType = D3DLIGHT_DIRECTIONAL;",
                             "light_1.dvDirection = vector(0.0f, -1.0f, 0.0f);",
                             "light_1.dcvAmbient = color(0.0f, 0.0f, 0.0f, 1.0f);",
                             "TRY(device->LightEnable(1, TRUE));"}) {
        INFO(line);
        CHECK(count_of(text, std::string(line) + '\n') == 1);
    }
    CHECK(count_of(text, "AMBIENT") == 0);

    // 51 / 255
    lighting.ambient = Vec3(0.2f, 1.0f, 0.0f);
    CHECK(count_of(pass(), "D3DRENDERSTATE_AMBIENT, 0x0033ff00));") == 1);
    CHECK(count_of(pass(), "dltType") == 2);

    lighting.ambient = Vec3(0.25f, 2.0f, 0.0f);
    CHECK(count_of(pass(), "D3DRENDERSTATE_AMBIENT,") == 0);
    CHECK(count_of(pass(), "light_1.dcvAmbient = color(0.25f, 2.0f, 0.0f, 1.0f);") == 1);

    lighting.lights.resize(1);
    CHECK(count_of(pass(), "light_1.dcvAmbient = color(0.25f, 2.0f, 0.0f, 1.0f);") == 1);
    CHECK(count_of(pass(), "light_1.dcvDiffuse = color(0.0f, 0.0f, 0.0f, 1.0f);") == 1);

    lighting.lights.resize(8, lighting.lights[0]);
    CHECK(count_of(pass(), "dltType") == 8);
    CHECK(count_of(pass(), "D3DRENDERSTATE_AMBIENT, 0x0040ff00));") == 1);
    CHECK(count_of(pass(), "is rounded to bytes") == 1);
}

TEST_CASE("Direct3D 7: every texel is in the side file, where its table says", "[emit]") {
    Frame frame       = parsed(R"(
output #0
targets [ "picture" { width 16 height 8 } ]
textures [
    "alpha" { format A8 width 4 height 2 levels 3 texels [0102030405060708 1112 21] }
    "color" { width 1 height 2 texels [a1a2a3a4 b1b2b3b4] }
]
)");
    const Emitted out = emit_dx7({.frame = frame, .notes = {}, .left = {}}, "frame.bin");
    CHECK(count_of(out.text, "    {A8, 4, 2, 3, 0},  // 0 'alpha'\n") == 1);
    CHECK(count_of(out.text, "    {A8R8G8B8, 1, 2, 1, 16},  // 1 'color'\n") == 1);
    CHECK(count_of(out.text, "static const size_t data_size = 24;\n") == 1);
    CHECK(out.data == std::vector<std::uint8_t>{1, 2, 3, 4, 5,    6,    7,    8,    0x11, 0x12, 0x21, 0,
                                                0, 0, 0, 0, 0xa1, 0xa2, 0xa3, 0xa4, 0xb1, 0xb2, 0xb3, 0xb4});
}

TEST_CASE("Direct3D 7: every vertex is in the side file, where its table says", "[emit]") {
    Frame frame;
    frame.output  = {0};
    frame.targets = {{.name = "picture", .width = 16, .height = 8}};
    frame.cameras.resize(1);
    for (std::uint32_t i = 0; i < 70000; ++i) {
        const auto x = static_cast<float>(i);
        frame.vertices.push_back({.position = {x, -x, 0.1f * x},
                                  .normal   = {0.5f, x + 0.5f, 2.0f},
                                  .diffuse  = {i * 40503u},
                                  .specular = {i},
                                  .uv0      = {x / 7.0f, 1.0f},
                                  .uv1      = {3.0f, x / 9.0f}});
        frame.indices.push_back(69999 - i);
    }
    frame.indices.resize(69999);
    frame.indices.insert(frame.indices.end(), {5, 69999, 5, 5, 0, 69999});
    frame.passes.resize(2);
    for (Pass& pass : frame.passes) pass.color = {0}, pass.camera = {0};
    frame.passes[0].draws = {DrawTriangles{.first_index = 0, .index_count = 69999},
                             DrawTriangles{.first_index = 69999, .index_count = 6}};
    frame.passes[1].draws = {DrawTriangles{.first_index = 69999, .index_count = 6}, DrawTriangles{}};
    const dx7::Data data  = dx7::make_data(frame);

    for (const std::size_t pass : {0, 1})
        for (const std::size_t draw : {0, 1}) {
            const auto& triangles = std::get<DrawTriangles>(frame.passes[pass].draws[draw]);
            std::vector<Vertex> expected;
            for (std::uint32_t i = 0; i < triangles.index_count; ++i)
                expected.push_back(frame.vertices[frame.indices[triangles.first_index + i]]);
            CHECK((corners_of(data, data.draws[pass][draw]) == expected));
        }
    // Three corners of a triangle have to fit into what is left of 65535.
    REQUIRE(data.meshes.size() == 3);
    CHECK(data.meshes[0].vertex_count == 65535);
    CHECK(data.meshes[1].vertex_count == 69999 - 65535);
    CHECK(data.meshes[2].vertex_count == 3);  // 5, 69999 and 0, once each
    CHECK(data.draws[1][0].first == 2);       // the same indices, the same mesh
    CHECK(data.draws[1][1].count == 0);
    for (const dx7::Mesh& mesh : data.meshes) {
        CHECK(mesh.vertices % 16 == 0);
        CHECK(mesh.indices % 16 == 0);
    }
    CHECK(data.bytes.size() == data.meshes[2].indices + 12);
}

TEST_CASE("Direct3D 7: a stage that reads the alpha of the specular colour reads one", "[emit]") {
    Frame frame         = parsed(R"(
output "picture"
targets [ "picture" { width 16 height 8 } ]
cameras [ "eye" {} ]
vertices columns (position specular) [ (0 0 0) 0x40102030 ]
indices [0 0 0]
passes [
    "plain" { color "picture" camera "eye" draws [ triangles { index_count 3 } ] }
    "reads" {
        color "picture" camera "eye"
        state { stages [{ color_op SELECTARG1 alpha_op SELECTARG1 alpha_arg1 { source SPECULAR } }] }
        draws [ triangles { index_count 3 } ]
    }
]
)");
    const auto specular = [&](std::size_t pass) {
        const dx7::Data data = dx7::make_data(frame);
        return word_at<std::uint32_t>(data.bytes, data.meshes[data.draws[pass][0].first].vertices + 28);
    };
    CHECK(specular(0) == 0x40102030);
    CHECK(specular(1) == 0xff102030);
    frame.passes[1].state.stages[0].alpha_op = TextureOp::SelectArg2;
    CHECK(specular(1) == 0x40102030);
    frame.passes[1].state.fog.mode           = FogMode::Exp;
    frame.passes[1].state.stages[0].alpha_op = TextureOp::SelectArg1;
    CHECK(count_of(emitted_text(frame), "// Not known: the alpha of D3DTA_SPECULAR") == 1);
}
