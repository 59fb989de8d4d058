// SPDX-License-Identifier: MIT
// The text form is read and written without knowing any field: these tests go through every field by way of random
// frames, and pin what a person sees by hand-written text.
#include "pipeline/frame/frame_text.h"

#include <bit>
#include <catch2/catch.hpp>
#include <limits>

#include "pipeline/frame/field_traits.h"
#include "pipeline/frame/text_reader.h"
#include "tests/support/random.h"
#include "tests/support/random_frame.h"

using namespace pipeline;
using test_support::mutate_field;
using test_support::Random;
using test_support::random_frame;

namespace {

constexpr const char* kCompositeText = R"(nimbus7 frame 1
output "back buffer"

targets [
    "back buffer" { width 64 height 32 }
    "cloud" { width 64 height 32 }
    "scene depth" { format D24 width 64 height 32 }
]

cameras [
    "eye" { projection ((2 0 0 0) (0 2 0 0) (0 0 1 -0.5) (0 0 1 0)) }
]

passes [
    "particles" {
        color "cloud"
        depth "scene depth"
        camera "eye"
        clear { color 0x00204060 }
        state {
            depth { func LESSEQUAL write true }
            cull CCW
            lighting {
                enabled true
                lights [
                    { diffuse (0.7 0.679 0.63) direction (0 -1 0) }
                ]
            }
        }
        draws [
            triangles { index_count 3 world ((1 0 0 5) (0 1 0 6) (0 0 1 7) (0 0 0 1)) }
        ]
    }
    "composite" {
        color "back buffer"
        state {
            blend { source SRCALPHA dest INVSRCALPHA }
            color_mask { alpha false }
            stages [{ color_op SELECTARG1 alpha_op MODULATE alpha_arg2 { source TFACTOR } address_u CLAMP }]
        }
        draws [
            rectangle { x1 64 y1 32 uv [{} { u0 0.5 }] textures [{ target "cloud" } { texture "fractal" }] }
        ]
    }
]

textures [
    "fractal" {
        format A8
        width 2
        height 2
        texels [00ff8001]
    }
]

vertices [
    { position (-1 -1 2) normal (0 0 -1) diffuse 0x80ffffff }
    { position (0 1 2) uv0 (0.5 0) }
    { position (1 -1 2) uv0 (1 1) }
]

indices [0 1 2]
)";

Vertex vertex_at(const Vec3& position) {
    Vertex vertex;
    vertex.position = position;
    return vertex;
}

Vertex with_uv0(Vertex vertex, const Vec2& uv0) {
    vertex.uv0 = uv0;
    return vertex;
}

Frame composite_frame() {
    Frame frame;
    frame.output  = {0};
    frame.targets = {{.name = "back buffer", .width = 64, .height = 32},
                     {.name = "cloud", .width = 64, .height = 32},
                     {.name = "scene depth", .format = TargetFormat::D24, .width = 64, .height = 32}};
    Camera camera{.name = "eye"};
    camera.projection = Mat4(Vec4(2, 0, 0, 0), Vec4(0, 2, 0, 0), Vec4(0, 0, 1, 1), Vec4(0, 0, -0.5f, 0));
    frame.cameras     = {camera};
    frame.textures    = {{.name = "fractal", .format = TextureFormat::A8, .width = 2, .height = 2, .texels = {}}};
    frame.textures[0].texels  = {0x00, 0xff, 0x80, 0x01};
    frame.vertices            = {vertex_at(Vec3(-1, -1, 2)), with_uv0(vertex_at(Vec3(0, 1, 2)), Vec2(0.5f, 0)),
                                 with_uv0(vertex_at(Vec3(1, -1, 2)), Vec2(1, 1))};
    frame.vertices[0].normal  = Vec3(0, 0, -1);
    frame.vertices[0].diffuse = {0x80ffffff};
    frame.indices             = {0, 1, 2};

    Pass particles{
        .label = "particles", .color = {1}, .depth = {2}, .camera = {0}, .clear = {}, .state = {}, .draws = {}};
    particles.clear.color            = Argb{0x00204060};
    particles.state.depth            = {.func = CompareFunc::LessEqual, .write = true};
    particles.state.cull             = CullMode::CounterClockwise;
    particles.state.lighting.enabled = true;
    particles.state.lighting.lights  = {{.diffuse = Vec3(0.7f, 0.679f, 0.63f), .direction = Vec3(0, -1, 0)}};
    DrawTriangles triangles;
    triangles.index_count = 3;
    triangles.world[3]    = Vec4(5, 6, 7, 1);
    particles.draws       = {triangles};

    Pass composite{
        .label = "composite", .color = {0}, .depth = {}, .camera = {}, .clear = {}, .state = {}, .draws = {}};
    composite.state.blend            = kAlphaOver;
    composite.state.color_mask.alpha = false;
    TextureStage& stage              = composite.state.stages[0];
    stage.color_op                   = TextureOp::SelectArg1;
    stage.alpha_op                   = TextureOp::Modulate;
    stage.alpha_arg2.source          = ArgSource::TFactor;
    stage.address_u                  = TextureAddress::Clamp;
    DrawRectangle rectangle;
    rectangle.x1 = 64, rectangle.y1 = 32;
    rectangle.uv[1].u0            = 0.5f;
    rectangle.textures[0].target  = {1};
    rectangle.textures[1].texture = {0};
    composite.draws               = {rectangle};

    frame.passes = {particles, composite};
    return frame;
}

// "line:column: reason", or "" if the text is a frame.
std::string error_of(const std::string& text) {
    try {
        parse_frame(text);
    } catch (const ParseError& error) {
        return std::to_string(error.line) + ':' + std::to_string(error.column) + ": " + error.what();
    }
    return {};
}

void check_round_trip(const Frame& frame) {
    const std::string text = to_text(frame);
    const Frame back       = parse_frame(text);
    CHECK(identical(back, frame));
    CHECK(diff(frame, back).empty());
    CHECK(to_text(back) == text);
}

}  // namespace

TEST_CASE("a frame's text reads as its passes") {
    CHECK(to_text(composite_frame()) == kCompositeText);
    CHECK(diff(parse_frame(kCompositeText), composite_frame()) == std::vector<std::string>{});
    CHECK(parse_frame(kCompositeText) == composite_frame());
}

TEST_CASE("an empty frame is its first line") {
    CHECK(to_text(Frame{}) == "nimbus7 frame 1\n");
    CHECK(parse_frame("nimbus7 frame 1") == Frame{});
}

TEST_CASE("random frames, valid and changed, survive their text to the bit") {
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        INFO("seed " << seed);
        Frame frame = random_frame(seed);
        check_round_trip(frame);
        for (std::uint32_t i = 0; i < 8; ++i) mutate_field(frame, seed * 8 + i);
        check_round_trip(frame);
    }
}

TEST_CASE("order, blanks, comments and the form of ids are free") {
    const Frame frame = parse_frame(
        "// a comment before\r\nnimbus7  frame\t1 indices[0 1\n2]targets["
        "{height 3 name \"//\" width 2}// one\n \"z\"{format D16}] // two\n"
        "passes[{depth #1 color\"//\"} {color none depth #-7 camera none clear { depth none color 0xABCDEF01 }}] "
        "output #0");
    CHECK(frame.indices == std::vector<std::uint32_t>{0, 1, 2});
    REQUIRE(frame.targets.size() == 2);
    CHECK(frame.targets[0] == Target{.name = "//", .width = 2, .height = 3});
    CHECK(frame.targets[1] == Target{.name = "z", .format = TargetFormat::D16});
    CHECK(frame.output == TargetId{0});
    REQUIRE(frame.passes.size() == 2);
    CHECK(frame.passes[0].depth == TargetId{1});
    CHECK(frame.passes[0].color == TargetId{0});
    CHECK(frame.passes[1].color == TargetId{});
    CHECK(frame.passes[1].depth == TargetId{-7});
    CHECK(frame.passes[1].clear.color == Argb{0xabcdef01});
    CHECK_FALSE(frame.passes[1].clear.depth.has_value());
}

TEST_CASE("ids are written by name only where the name is the only one") {
    Frame frame;
    frame.targets = {{.name = "a"}, {.name = "b"}, {.name = "b"}, {.name = ""}};
    for (int i = 0; i < 6; ++i) frame.passes.emplace_back().color = {i};
    const std::string text = to_text(frame);
    for (const char* expected : {"color \"a\"", "color #1", "color #2", "color #3", "color #4", "color #5"}) {
        INFO(expected);
        CHECK(text.find(expected) != std::string::npos);
    }
    check_round_trip(frame);
}

TEST_CASE("numbers keep every bit") {
    using Limits = std::numeric_limits<float>;
    Frame frame;
    for (const float value :
         {0.0f, -0.0f, 1.0f / 3.0f, Limits::denorm_min(), -Limits::denorm_min(), Limits::min(), Limits::max(),
          Limits::epsilon(), 16777217.0f, 1e-10f, Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()}) {
        frame.vertices.push_back(vertex_at(Vec3(value)));
        frame.passes.emplace_back().clear.depth = value;
        frame.passes.back().state.fog.density   = value;
        frame.cameras.emplace_back().view[1][2] = value;
    }
    Random random(1);
    for (int i = 0; i < 20000; ++i) {
        frame.vertices.push_back(vertex_at(Vec3(std::bit_cast<float>(random.bits() & 0xff7fffff))));
    }
    CHECK(identical(parse_frame(to_text(frame)), frame));
    CHECK(to_text(frame).find("clear { depth -0 }") != std::string::npos);
}

TEST_CASE("long lists are compact") {
    Frame frame;
    for (int i = 0; i < 100; ++i) {
        const auto x = static_cast<float>(i);
        frame.vertices.push_back(vertex_at(Vec3(x, 0, 0)));
        frame.vertices.back().uv1 = Vec2(x, 1);
        frame.indices.push_back(static_cast<std::uint32_t>(i) * 1000);
    }
    const std::string text = to_text(frame);
    CHECK(text.find("vertices columns (position uv1) [\n    (0 0 0) (0 1)\n    (1 0 0) (1 1)\n") != std::string::npos);
    std::size_t longest = 0, start = 0;
    for (std::size_t end; (end = text.find('\n', start)) != std::string::npos; start = end + 1) {
        longest = std::max(longest, end - start);
    }
    CHECK(longest <= 110);
    CHECK(longest > 90);
    CHECK(parse_frame(text) == frame);

    frame.vertices.assign(20, {});
    CHECK(parse_frame(to_text(frame)) == frame);
}

TEST_CASE("strings of any bytes survive") {
    std::string bytes;
    for (int i = 0; i < 256; ++i) bytes += static_cast<char>(i);
    Frame frame;
    frame.targets = {{.name = bytes}};
    frame.output  = {0};
    check_round_trip(frame);
    const std::string text = to_text(frame);
    CHECK(text.find(R"(\x00\x01)") != std::string::npos);
    CHECK(text.find(R"( !\"#)") != std::string::npos);
}

TEST_CASE("values without a name are shown and read") {
    Frame frame;
    frame.passes.emplace_back().state.cull = static_cast<CullMode>(200);
    CHECK(to_text(frame).find("cull #200") != std::string::npos);
    check_round_trip(frame);
}

TEST_CASE("errors of the text say where and why") {
    const struct {
        const char* text;
        const char* error;
    } cases[] = {
        {"", "1:1: a frame's text starts with 'nimbus7 frame 1'"},
        {"\n nimbus8 frame 1", "2:2: a frame's text starts with 'nimbus7 frame 1'"},
        {"nimbus7 frame 2", "1:15: unknown version 2 of the text; this program reads version 1"},
        {"nimbus7 frame", "1:14: expected an integer from 0 to 2147483647, got the end of the text"},
        {"nimbus7 frame 1\n}", "2:1: expected a field of the frame, got '}'"},
        {"nimbus7 frame 1\noutput none trailing",
         "2:13: unknown field 'trailing' in the frame; there are output, arithmetic, targets, cameras, passes, textures, vertices, "
         "window_vertices, indices"},
        {"nimbus7 frame 1\npasses [ {} { state {\n  blnd {} } } ]",
         "3:3: unknown field 'blnd' in passes[1].state; there are blend, gs_blend, dither, color_mask, "
         "depth, alpha_test, dest_alpha_test, cull, shade, fog, texture_factor, stages, lighting, viewport, scissor"},
        {"nimbus7 frame 1\npasses [ { state { stages [{} { color_op MODULATE3X }] } } ]",
         "2:42: unknown value 'MODULATE3X' for passes[0].state.stages[1].color_op; one of DISABLE, SELECTARG1, "
         "SELECTARG2, MODULATE, MODULATE2X, MODULATE4X, ADD, ADDSIGNED, ADDSIGNED2X, SUBTRACT, "
         "BLENDDIFFUSEALPHA, BLENDTEXTUREALPHA, BLENDFACTORALPHA, BLENDCURRENTALPHA, MODULATECOLOR_ADDALPHA"},
        {"nimbus7 frame 1\npasses [ { state { cull } } ]", "2:25: expected one of NONE, CW, CCW, got '}'"},
        {"nimbus7 frame 1\npasses [ { state { alpha_test { reference 256 } } } ]",
         "2:43: expected an integer from 0 to 255, got '256'"},
        {"nimbus7 frame 1\ntargets [{ width 12.5 }]",
         "2:18: expected an integer from -2147483648 to 2147483647, got '12.5'"},
        {"nimbus7 frame 1 indices [0 -1]", "1:28: expected an integer from 0 to 4294967295, got '-1'"},
        {"nimbus7 frame 1\npasses [{ clear { depth 1e39 } }]",
         "2:25: the number '1e39' is out of the range of single precision"},
        {"nimbus7 frame 1\npasses [{ clear { depth 1,5 } }]", "2:25: expected a number, got '1,5'"},
        {"nimbus7 frame 1\npasses [{ clear { color 0xffffff } }]",
         "2:25: expected a colour, 0xAARRGGBB, got '0xffffff'"},
        {"nimbus7 frame 1\npasses [{ clear { color 0xfffffffg } }]",
         "2:25: expected a colour, 0xAARRGGBB, got '0xfffffffg'"},
        {"nimbus7 frame 1\npasses [{ state { color_mask { red 1 } } }]", "2:36: expected true or false, got '1'"},
        {"nimbus7 frame 1\nvertices [{ position (1 2) }]", "2:26: expected a number, got ')'"},
        {"nimbus7 frame 1\nvertices [{ position (1 2 3 4) }]", "2:29: expected ')' after 3 numbers, got '4'"},
        {"nimbus7 frame 1\nvertices [{ position 1 }]", "2:22: expected '(' before 3 numbers, got '1'"},
        {"nimbus7 frame 1\noutput \"clod\" targets [\"cloud\" {} {} \"z\" {}]",
         "2:8: nothing in targets is named \"clod\"; there are \"cloud\", \"z\""},
        {"nimbus7 frame 1\noutput \"z\" targets [{} \"z\" {} \"z\" {}]",
         "2:8: 2 of targets are named \"z\"; write #1 for the first"},
        {"nimbus7 frame 1\noutput \"\"", "2:8: an empty name refers to nothing; write none"},
        {"nimbus7 frame 1\noutput 3", "2:8: expected \"a name\", #number or none, got '3'"},
        {"nimbus7 frame 1\noutput #99999999999",
         "2:9: expected an integer from -2147483648 to 2147483647, got '99999999999'"},
        {"nimbus7 frame 1\ntargets [\n{ width 1\n", "4:1: missing '}': targets[0] is still open, since line 3"},
        {"nimbus7 frame 1\ntargets [\n{ width 1 }", "3:12: missing ']': targets is still open, since line 2"},
        {"nimbus7 frame 1\ntargets { width 1 }", "2:9: expected '[', got '{'"},
        {"nimbus7 frame 1\ntargets [ width ]", "2:11: expected '{', got 'width'"},
        {"nimbus7 frame 1\ntargets [ { width 1 height 1 width 2 } ]",
         "2:30: field 'width' of targets[0] is given twice"},
        {"nimbus7 frame 1\ntargets [ \"a\" { name \"b\" } ]", "2:17: field 'name' of targets[0] is given twice"},
        {"nimbus7 frame 1\ntargets [ \"a\n\" {} ]", "2:11: the string is not closed on its line"},
        {"nimbus7 frame 1\ntargets [ \"a\\q\" {} ]",
         "2:13: unknown escape in a string: there are \\\" \\\\ \\n \\t \\r \\x7f"},
        {"nimbus7 frame 1\npasses [{ draws [ circle {} ] }]",
         "2:19: expected one of triangles rectangle copy window_triangles"},
        {"nimbus7 frame 1\npasses [{ draws [ rectangle { textures [{}{}{}] } ] }]",
         "2:45: too many: passes[0].draws[0].textures has 2 entries"},
        {"nimbus7 frame 1\ntextures [{ texels [00 f] }]", "2:25: half a byte: a byte has two hexadecimal digits"},
        {"nimbus7 frame 1\ntextures [{ texels [0g] }]", "2:22: half a byte: a byte has two hexadecimal digits"},
        {"nimbus7 frame 1\ntextures [{ texels [00 zz] }]", "2:24: expected hexadecimal bytes or ']', got 'zz'"},
        {"nimbus7 frame 1\nvertices columns (uv0 uv2) []",
         "2:23: unknown field 'uv2' in vertices; there are position, normal, diffuse, specular, uv0, uv1"},
        {"nimbus7 frame 1\nvertices columns (uv0 uv0) []", "2:23: the column is given twice"},
        {"nimbus7 frame 1\nvertices columns () []", "2:10: a table has at least one column"},
        {"nimbus7 frame 1\nvertices columns (uv0 uv1) [(0 0)]", "2:34: expected '(' before 2 numbers, got ']'"},
        {"nimbus7 frame 1\n\x01", "2:1: expected a field of the frame, got '\\x01'"},
    };
    for (const auto& [text, error] : cases) {
        INFO(text);
        CHECK(error_of(text) == error);
    }
}

TEST_CASE("every prefix of a text is a frame or an error") {
    const std::string text = kCompositeText;
    int frames             = 0;
    for (std::size_t length = 0; length <= text.size(); ++length) frames += error_of(text.substr(0, length)).empty();
    CHECK(frames > 2);
    CHECK(frames < 40);
}

TEST_CASE("text with damaged bytes is read or refused, never more") {
    int refused = 0;
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        Random random(seed);
        std::string text = kCompositeText;
        for (int i = random.from(1, 4); i > 0; --i) {
            const std::size_t at = random.below(text.size());
            switch (random.from(0, 3)) {
                case 0:
                    text[at] = static_cast<char>(random.bits());
                    break;
                case 1:
                    text.erase(at, random.below(9));
                    break;
                case 2:
                    text.insert(at, text.substr(random.below(text.size()), 20));
                    break;
                default:
                    text[at] = random.one_of({'{', '}', '[', ']', '(', ')', '"', '#', '-', '9', '\n', '/'});
                    break;
            }
        }
        INFO(text);
        const std::string error = error_of(text);
        if (error.empty()) {
            const Frame frame = parse_frame(text);
            CHECK(identical(parse_frame(to_text(frame)), frame));
        } else {
            ++refused;
        }
    }
    CHECK(refused > 1000);
}

TEST_CASE("deep and long nonsense is refused at once") {
    const std::string start = "nimbus7 frame 1\n";
    for (const std::string part : {"[", "{", "(", "passes [{", "draws [", "\"", "// ", "#", "state {", "\n"}) {
        std::string text = start;
        while (text.size() < 1000000) text += part;
        INFO(part);
        const bool is_frame = part == "// " || part == "\n";
        CHECK(error_of(text).empty() == is_frame);
        CHECK(error_of(start + "passes " + text.substr(start.size())).empty() == false);
    }
}

TEST_CASE("a list has no more entries than memory is meant for") {
    const std::size_t most = 10 * sizeof(Pass);
    const auto read        = [&](const std::string& text) {
        Frame frame;
        TextReader(text, most).read_top_level(frame);
        return frame;
    };
    std::string passes = "passes [";
    for (int i = 0; i < 10; ++i) passes += " {}";
    CHECK(read(passes + "]").passes.size() == 10);
    CHECK_THROWS_WITH(read(passes + " {}]"), "too many: passes may have 10 entries");
    const std::size_t rows = most / sizeof(Vertex);
    std::string vertices   = "vertices columns (uv0) [";
    for (std::size_t i = 0; i < rows; ++i) vertices += " (0 0)";
    CHECK(read(vertices + "]").vertices.size() == rows);
    CHECK_THROWS_AS(read(vertices + " (0 0)]"), ParseError);
}

TEST_CASE("diff names each field that differs") {
    const Frame before = composite_frame();
    CHECK(diff(before, before).empty());

    Frame after                 = before;
    after.output                = {1};
    after.passes[1].state.blend = {.source = BlendFactor::One, .dest = BlendFactor::InvSourceAlpha};
    after.passes[1].color       = {7};
    after.passes[0].clear.depth = 0.5f;
    after.passes[0].clear.color = {};
    after.passes[0].state.stages[1].color_arg1.source = ArgSource::Specular;
    after.passes[0].state.lighting.lights.push_back({});
    std::get<DrawTriangles>(after.passes[0].draws[0]).index_count = 6;
    after.passes[1].draws[0]                                      = DrawTriangles{};
    after.textures[0].texels                                      = {0, 0, 0, 1};
    after.vertices[2].uv0                                         = Vec2(1, -1);
    CHECK(diff(before, after) ==
          std::vector<std::string>{
              "output: \"back buffer\" -> \"cloud\"",
              "passes[0].clear.color: 0x00204060 -> none",
              "passes[0].clear.depth: none -> 0.5",
              "passes[0].state.stages[1].color_arg1.source: TEXTURE -> SPECULAR",
              "passes[0].state.lighting.lights: 1 -> 2 entries",
              "passes[0].draws[0].index_count: 3 -> 6",
              "passes[1].color: \"back buffer\" -> #7",
              "passes[1].state.blend.source: SRCALPHA -> ONE",
              "passes[1].draws[0]: rectangle { x1 64 y1 32 uv [{} { u0 0.5 }] textures [{ target \"cloud\" } { texture "
              "\"fractal\" }] } -> triangles {}",
              "textures[0].texels[1]: 255 -> 0; 1 more differ",
              "vertices[2].uv0: (1 1) -> (1 -1)",
          });
}

TEST_CASE("diff of long lists stays short") {
    Frame before, after;
    before.vertices.resize(1000);
    after.vertices.assign(1000, with_uv0({}, Vec2(1, 0)));
    const std::vector<std::string> lines = diff(before, after);
    REQUIRE(lines.size() == 9);
    CHECK(lines[0] == "vertices[0].uv0: (0 0) -> (1 0)");
    CHECK(lines[8] == "vertices: 992 more differ");
}

TEST_CASE("one change anywhere is one line of diff") {
    for (std::uint32_t seed = 0; seed < 600; ++seed) {
        INFO("seed " << seed);
        const Frame before = random_frame(seed % 60);
        Frame after        = before;
        mutate_field(after, seed);
        CHECK(after != before);
        CHECK(diff(before, after).size() == 1);
    }
}
