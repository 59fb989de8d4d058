// SPDX-License-Identifier: MIT
// The text form is read and written without knowing any field: these tests go through every field by way of random
// frames, and pin what a person sees by hand-written text.
#include "pipeline/frame/frame_text.h"

#include <bit>
#include <catch2/catch.hpp>
#include <limits>

#include "pipeline/frame/field_traits.h"
#include "tests/support/composite_frame.h"
#include "tests/support/random.h"
#include "tests/support/random_frame.h"

using namespace pipeline;
using namespace test_support;

namespace {

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
