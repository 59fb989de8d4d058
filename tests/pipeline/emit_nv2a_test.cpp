// SPDX-License-Identifier: MIT
// What emit_nv2a writes, read back by tests/support/nv2a_state.h, says what the frame says: of the built-in scenes, of random
// frames, and of small ones with each thing that is treated in its own way. Values: emit_nv2a_values_test.cpp.
#include "pipeline/emit/emit_nv2a.h"

#include <algorithm>

#include "demo/scene.h"
#include "pipeline/emit/nv2a_memory.h"
#include "pipeline/frame/frame_text.h"
#include "tests/support/nv2a_agreement.h"
#include "tests/support/nv2a_state.h"
#include "tests/support/random_frame.h"
#include "tests/support/small_frame.h"

using namespace pipeline;
using namespace test_support;

namespace {

LegalFrame legal_frame(const Frame& frame) {
    return legalize(frame, *find_profile("xbox"));
}

Emitted require_agreement(const Frame& frame) {
    const LegalFrame legal = legal_frame(frame);
    REQUIRE(legal.left.empty());
    const Emitted emitted = emit_nv2a(legal, "frame.bin");
    for (const std::string& difference : nv2a_differences(legal.frame, emitted)) FAIL_CHECK(difference);
    return emitted;
}

// Of a frame that the chip draws as it is, so that numbers stay as the test wrote them.
Frame chip_frame(int width, int height, std::optional<TargetFormat> depth = {}) {
    Frame frame      = small_frame(width, height, depth);
    frame.arithmetic = find_profile("xbox")->arithmetic;
    return frame;
}

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

}  // namespace

TEST_CASE("emit_nv2a says what the scenes say", "[emit][nv2a]") {
    for (const demo::SceneInfo& info : demo::built_in_scenes()) {
        CAPTURE(info.name);
        require_agreement(demo::scene_frame(*demo::load_scene(info.name), {64, 48}, 0));
    }
}

TEST_CASE("emit_nv2a says what random frames say", "[emit][nv2a]") {
    int legal_ones = 0, lit_by_chip = 0, lit_by_program = 0;
    for (std::uint32_t seed = 0; seed < 400; ++seed) {
        CAPTURE(seed);
        const LegalFrame legal = legal_frame(random_frame(seed));
        // Of targets that nothing draws to check asks no format.
        const auto is_foreign  = [](const Target& target) {
            return target.format == TargetFormat::D32 ||
                   (!is_depth(target.format) && target.format > TargetFormat::R5G6B5);
        };
        const std::vector<Target>& targets = legal.frame.targets;
        if (!legal.left.empty() || std::any_of(targets.begin(), targets.end(), is_foreign)) continue;
        ++legal_ones;
        const Emitted emitted = emit_nv2a(legal, "frame.bin");
        for (const std::string& difference : nv2a_differences(legal.frame, emitted)) FAIL_CHECK(difference);
        lit_by_chip += emitted.text.find("SET_LIGHT_ENABLE_MASK") != std::string::npos;
        lit_by_program += emitted.text.find("lit by the program") != std::string::npos;
    }
    // Or the test would show little.
    CHECK(legal_ones >= 40);
    CHECK(lit_by_chip >= 5);
    CHECK(lit_by_program >= 5);
}

TEST_CASE("emit_nv2a refuses what is not legal on the Xbox", "[emit][nv2a]") {
    Frame frame = chip_frame(4, 4);
    frame.passes[0].draws.push_back(rectangle({0, 0, 4, 4}, 0xff112233));
    CHECK_NOTHROW(emit_nv2a({.frame = frame, .notes = {}, .left = {}}, "f"));
    const ChipFinding finding{.where = "pass 0", .rule = "states", .uses = "this", .has = "that"};
    CHECK_THROWS_WITH(emit_nv2a({.frame = frame, .notes = {}, .left = {finding, finding}}, "f"),
                      "the frame is not legal on the NV2A: pass 0: uses this; the chip has that, and 1 more");
    // Nor is it enough that nobody has looked.
    frame.passes[0].state.dest_alpha_test = DestAlphaTest::One;
    CHECK_THROWS_AS(emit_nv2a({.frame = frame, .notes = {}, .left = {}}, "f"), std::invalid_argument);
    frame.passes[0].state.dest_alpha_test = DestAlphaTest::Off;
    frame.targets[0].format               = TargetFormat::A1R5G5B5;
    CHECK_THROWS_AS(emit_nv2a({.frame = frame, .notes = {}, .left = {}}, "f"), std::invalid_argument);
    // A clip rectangle of the chip ends at 4095.
    frame.targets[0].format = TargetFormat::A8R8G8B8;
    frame.targets[0].width  = 4096;
    CHECK_NOTHROW(emit_nv2a({.frame = frame, .notes = {}, .left = {}}, "f"));
    frame.targets[0].width = 4097;
    CHECK_THROWS_AS(emit_nv2a({.frame = frame, .notes = {}, .left = {}}, "f"), std::invalid_argument);
}

TEST_CASE("texels of powers of two go in Z order", "[emit][nv2a]") {
    // 4 x 2: bits of the place are x0 y0 x1.
    const Texture wide{.format = TextureFormat::L8, .width = 4, .height = 2, .texels = {0, 1, 2, 3, 4, 5, 6, 7}};
    CHECK(nv2a_texels(wide, 4) == std::vector<std::uint8_t>{0, 1, 4, 5, 2, 3, 6, 7});
    const Texture high{.format = TextureFormat::L8, .width = 2, .height = 4, .texels = {0, 1, 2, 3, 4, 5, 6, 7}};
    CHECK(nv2a_texels(high, 2) == std::vector<std::uint8_t>{0, 1, 2, 3, 4, 5, 6, 7});
    const Texture square{
        .format = TextureFormat::A8, .width = 4, .height = 4, .levels = 3, .texels = {0,  1,  2,  3,  4,  5,  6,  7, 8,
                                                                                      9,  10, 11, 12, 13, 14, 15,  //
                                                                                      20, 21, 22, 23, 30}};
    CHECK(nv2a_texels(square, 4) ==
          std::vector<std::uint8_t>{0, 1, 4, 5, 2, 3, 6, 7, 8, 9, 12, 13, 10, 11, 14, 15, 20, 21, 22, 23, 30});
    const Texture color{.format = TextureFormat::A8R8G8B8, .width = 1, .height = 2, .texels = {1, 2, 3, 4, 5, 6, 7, 8}};
    CHECK(nv2a_texels(color, 4) == color.texels);
    // Others in rows.
    const Texture odd{.format = TextureFormat::L8, .width = 3, .height = 2, .texels = {1, 2, 3, 4, 5, 6}};
    const std::vector<std::uint8_t> rows = nv2a_texels(odd, 64);
    CHECK(rows.size() == 128);
    CHECK(std::equal(rows.begin() + 64, rows.begin() + 67, odd.texels.begin() + 3));
    CHECK(rows[3] == 0);
}

TEST_CASE("targets begin with zeros unless a pass clears all of them first", "[emit][nv2a]") {
    const auto clears_before = [](const Frame& frame) {
        const Emitted emitted = require_agreement(frame);
        return count_of(emitted.text.substr(0, emitted.text.find("# pass 0")), "NV097_CLEAR_SURFACE ");
    };
    Frame frame = chip_frame(4, 4, TargetFormat::D24);
    frame.passes[0].draws.push_back(rectangle({0, 0, 4, 4}, 0xff112233));
    CHECK(clears_before(frame) == 2);
    frame.passes[0].clear.depth = 1.0f;
    CHECK(clears_before(frame) == 1);
    frame.passes[0].clear.color = Argb{0xff000000};
    CHECK(clears_before(frame) == 0);
    frame.passes[0].state.scissor = {0, 0, 2, 4};
    CHECK(clears_before(frame) == 2);
}

TEST_CASE("copies are blits", "[emit][nv2a]") {
    Frame frame = chip_frame(8, 4);
    frame.targets.push_back({.name = "other", .width = 8, .height = 4});
    Pass& pass = frame.passes.emplace_back();
    pass.color = {1};
    pass.draws.push_back(CopyRectangle{.source = {0}, .from = {1, 2, 5, 4}, .x = 3, .y = 1});
    frame.passes[0].clear.color = Argb{0xff102030};
    const Emitted emitted       = require_agreement(frame);
    // y or height in the high half. Rows of 64 bytes, and the second surface after the first's 4 * 64.
    for (const char* line : {"0300  NV062_SET_COLOR_FORMAT 0x0000000a", "0304  NV062_SET_PITCH 0x00400040",
                             "0308  NV062_SET_OFFSET_SOURCE 0x00000000", "030c  NV062_SET_OFFSET_DESTIN 0x00000100",
                             "02fc  NV09F_SET_OPERATION 0x00000003", "0300  NV09F_CONTROL_POINT_IN 0x00020001",
                             "0304  NV09F_CONTROL_POINT_OUT 0x00010003", "0308  NV09F_SIZE 0x00020004"})
        CHECK(count_of(emitted.text, line) == 1);
}

TEST_CASE("many vertices are drawn with 32-bit indices, few with 16", "[emit][nv2a]") {
    Frame frame              = chip_frame(4, 4);
    const DrawTriangles quad = add_quad(frame, 0xffffffff);
    frame.passes[0].draws    = {quad};
    const Emitted few        = require_agreement(frame);
    CHECK(count_of(few.text, "1800* NV097_ARRAY_ELEMENT16 0x00010000 0x00000002 0x00030002") == 1);
    CHECK(count_of(few.text, "ARRAY_ELEMENT32 ") == 0);
    // Three of them leave an odd one.
    std::get<DrawTriangles>(frame.passes[0].draws[0]).index_count = 3;
    const Emitted odd                                             = require_agreement(frame);
    CHECK(count_of(odd.text, "1800* NV097_ARRAY_ELEMENT16 0x00010000 ") == 1);
    CHECK(count_of(odd.text, "1808* NV097_ARRAY_ELEMENT32 0x00000002 ") == 1);
    frame.vertices.resize(70000);
    frame.indices[2]   = 69999;
    const Emitted many = require_agreement(frame);
    CHECK(count_of(many.text, "ARRAY_ELEMENT16 ") == 0);
    CHECK(count_of(many.text, "1808* NV097_ARRAY_ELEMENT32 0x00000000 0x00000001 0x0001116f") == 1);
}

TEST_CASE("window triangles keep their place, their w and their fog", "[emit][nv2a]") {
    Frame frame = chip_frame(8, 8, TargetFormat::D16);
    for (int i = 0; i < 3; ++i)
        frame.window_vertices.push_back({.x        = 1.5f + 2.0f * static_cast<float>(i),
                                         .y        = i == 1 ? 7.0f : 0.25f,
                                         .z        = 0.25f * static_cast<float>(i),
                                         .rhw      = 1.0f / (1.0f + static_cast<float>(i)),
                                         .diffuse  = {0xff804020},
                                         .specular = {0x40102030u + static_cast<std::uint32_t>(i)},
                                         .uv0      = {0.5f, 1.0f, 2.0f}});
    frame.indices = {0, 1, 2};
    Pass& pass    = frame.passes[0];
    pass.draws    = {DrawWindowTriangles{.first_index = 0, .index_count = 3}};
    require_agreement(frame);
    pass.state.fog                                           = {.mode = FogMode::Exp, .color = {0xff010203}};
    pass.state.lighting.specular_enable                      = true;
    pass.state.stages[0]                                     = kTextureOnly;
    const TextureId texture                                  = add_texture(frame, TextureFormat::L8, 3, 1, {1, 2, 3});
    std::get<DrawWindowTriangles>(pass.draws[0]).textures[0] = bound(texture);
    const Emitted emitted                                    = require_agreement(frame);
    // Fog by SPEC_ALPHA, LINEAR: p0 + p1 d - 1 with both 1.
    CHECK(count_of(emitted.text, "02a0  NV097_SET_FOG_GEN_MODE 0x00000000") == 1);
    CHECK(count_of(emitted.text, "09c0  NV097_SET_FOG_PARAMS 0x3f800000 0x3f800000 0x00000000") == 1);
}

TEST_CASE("nothing is drawn where viewport and scissor do not meet", "[emit][nv2a]") {
    Frame frame                    = chip_frame(4, 4);
    frame.passes[0].state.viewport = {0, 0, 2, 4};
    frame.passes[0].state.scissor  = {2, 0, 4, 4};
    frame.passes[0].draws.push_back(rectangle({0, 0, 4, 4}, 0xff112233));
    CHECK(count_of(require_agreement(frame).text, "SET_BEGIN_END ") == 0);
    frame.passes[0].state.scissor = {1, 0, 4, 4};
    CHECK(count_of(require_agreement(frame).text, "SET_BEGIN_END ") == 2);
}

TEST_CASE("names of the frame cannot end a comment", "[emit][nv2a]") {
    Frame frame            = chip_frame(4, 4);
    frame.passes[0].label  = "two\n0100  NV097_NO_OPERATION 0x00000000";
    frame.targets[0].name  = "a\nb";
    const TextureId stone  = add_texture(frame, TextureFormat::L8, 1, 1, {7});
    frame.textures[0].name = "c\nd";
    DrawRectangle draw     = rectangle({0, 0, 4, 4}, 0xff112233);
    draw.textures[0]       = bound(stone);
    frame.passes[0].draws.push_back(draw);
    frame.passes[0].state.stages[0] = kTextureOnly;
    const Emitted emitted           = require_agreement(frame);
    CHECK(count_of(emitted.text, "\n0100") == 0);
    CHECK(count_of(emitted.text, "'a?b'") > 0);
    CHECK(count_of(emitted.text, "'c?d'") > 0);
}

TEST_CASE("the same frame gives the same text and data", "[emit][nv2a]") {
    const LegalFrame legal = legal_frame(demo::scene_frame(*demo::load_scene("plume"), {64, 48}, 0));
    const Emitted one = emit_nv2a(legal, "plume.bin"), two = emit_nv2a(legal, "plume.bin");
    CHECK(one.text == two.text);
    CHECK(one.data == two.data);
    CHECK(one.text.find("side file: plume.bin") != std::string::npos);
}
