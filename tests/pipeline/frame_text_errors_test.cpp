// SPDX-License-Identifier: MIT
// What is no text of a frame: refused with the place and the reason, however it is damaged.
#include <catch2/catch.hpp>

#include "pipeline/frame/frame_text.h"
#include "pipeline/frame/text_reader.h"
#include "tests/support/composite_frame.h"
#include "tests/support/random.h"

using namespace pipeline;
using namespace test_support;

namespace {

// "line:column: reason", or "" if the text is a frame.
std::string error_of(const std::string& text) {
    try {
        parse_frame(text);
    } catch (const ParseError& error) {
        return std::to_string(error.line) + ':' + std::to_string(error.column) + ": " + error.what();
    }
    return {};
}

}  // namespace

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
