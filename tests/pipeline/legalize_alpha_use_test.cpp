// SPDX-License-Identifier: MIT
#include "pipeline/legalize/alpha_use.h"

#include "tests/support/rewritten.h"

using namespace pipeline;
using namespace test_support;

namespace {

// Pass 0 draws to target "a"; others follow. The scissor is its left half.
std::string text(const std::string& passes) {
    return "targets [ \"a\" { width 8 height 4 } \"b\" { width 8 height 4 } \"d\" { format D24 width 8 height 4 } ] cameras [ {} ] "
           "passes [ \"p\" { color \"a\" draws [ rectangle { x1 8 y1 4 } ] } " +
           passes +
           "] window_vertices [ {} { x 4 } { y 4 } {} { x 4 diffuse 0x00000000 } { y 4 } { x 1 } ] "
           "indices [ 0 1 2 3 4 5 6 4 5 0 2 1 ]";
}
bool is_needed(const std::string& passes) {
    const Frame frame = parsed(text(passes));
    require_valid(frame);
    return is_alpha_needed(frame, 0);
}

std::string pass(const std::string& target, const std::string& state, const std::string& draw,
                 const std::string& more = "") {
    return "\"q\" { color \"" + target + "\" " + more + " state { " + state + " } draws [ " + draw + " ] } ";
}
std::string stages(const std::string& alpha_op, const std::string& color_op = "SELECTARG1") {
    return "stages [ { color_op " + color_op + " alpha_op " + alpha_op + " address_u CLAMP address_v CLAMP } ] ";
}
std::string copy(const std::string& target, const std::string& source, const std::string& channels,
                 const std::string& part = "from { x1 8 y1 4 }") {
    return pass(target, "", "copy { source \"" + source + "\" " + part + " channels " + channels + " }");
}
const std::string kAll = "rectangle { x1 8 y1 4 }", kOfA = "rectangle { x1 8 y1 4 textures [ { target \"a\" } ] }",
                  kByAlpha = "blend { source DESTALPHA dest INVDESTALPHA } color_mask { alpha false } ";
const std::string kReader  = pass("b", stages("SELECTARG1"), kOfA);
std::string triangles(const std::string& first) {
    return "window_triangles { first_index " + first + " index_count 3 }";
}

}  // namespace

TEST_CASE("alpha is needed where a later pass reads it", "[legalize]") {
    CHECK(!is_needed(""));
    CHECK(is_needed(kReader));
    CHECK(!is_needed(pass("b", stages("SELECTARG2"), kOfA)));
    CHECK(!is_needed(pass("b", stages("SELECTARG1"), kAll)));
    CHECK(is_needed(pass("b", stages("SELECTARG2", "BLENDTEXTUREALPHA"), kOfA)));
    CHECK(is_needed(pass("a", "blend { source ONE dest DESTALPHA } ", kAll)));
    CHECK(is_needed(pass("a", "blend { source INVDESTALPHA dest ONE } ", kAll)));
    CHECK(!is_needed(pass("a", "blend { source SRCALPHA dest DESTCOLOR } ", kAll)));
    CHECK(!is_needed(pass("b", "blend { source ONE dest DESTALPHA } ", kAll)));
    CHECK(!is_needed(pass("a", kByAlpha, "")));
    CHECK(is_needed(pass("a", "dest_alpha_test ONE ", kAll)));
    CHECK(is_needed(copy("b", "a", "ALL")));
    CHECK(is_needed(copy("b", "a", "ALPHA_TO_COLOR")));
    CHECK(!is_needed(copy("b", "a", "GREEN_TO_ALPHA")));
    // By register ALPHA: C is AD, and A is not B.
    const auto by_register = [](const std::string& blend) {
        const Frame frame = parsed("arithmetic { combine GS_SHIFT7 blend GS_SHIFT7 } " +
                                   text(pass("a", "gs_blend { " + blend + " } ", kAll)));
        return is_alpha_needed(frame, 0);
    };
    CHECK(by_register("b CD c AD d CD"));
    CHECK(!by_register("b CD c AS d CD"));
    CHECK(!by_register("c AD"));
}

TEST_CASE("alpha is not needed where it is cleared first", "[legalize]") {
    const std::string clear = "clear { color 0xff000000 }";
    CHECK(!is_needed(pass("a", "", "", clear) + kReader));
    CHECK(!is_needed(pass("a", kByAlpha, kAll, clear)));  // before the pass's own draws
    CHECK(is_needed(pass("a", "scissor { x1 4 y1 4 } ", "", clear) + kReader));
    CHECK(is_needed(pass("a", "viewport { x1 8 y1 3 } ", "", clear) + kReader));
    CHECK(is_needed(pass("b", "", "", clear) + kReader));
    CHECK(is_needed(kReader + pass("a", "", "", clear)));
    CHECK(is_needed(pass("a", "", "", "depth \"d\" clear { depth 1 }") + kReader));
}

TEST_CASE("alpha is not needed where all that is read is written anew", "[legalize]") {
    CHECK(!is_needed(pass("a", "", kAll) + kReader));
    CHECK(!is_needed(pass("a", "color_mask { red false green false blue false } ", kAll) + kReader));
    CHECK(is_needed(pass("b", "", kAll) + kReader));
    CHECK(is_needed(kReader + pass("a", "", kAll)));
    CHECK(is_needed(pass("a", "", "rectangle { x1 8 y1 3 }") + kReader));
    CHECK(is_needed(pass("a", "", kAll + kAll) + kReader));  // said of one rectangle alone
    CHECK(is_needed(pass("a", "color_mask { alpha false } ", kAll) + kReader));
    CHECK(is_needed(pass("a", "blend { source ONE dest ONE } ", kAll) + kReader));
    CHECK(is_needed(pass("a", "alpha_test { func GREATER } ", kAll) + kReader));
    CHECK(is_needed(pass("a", "depth { func LESS } ", kAll, "depth \"d\"") + kReader));
    CHECK(is_needed(pass("a", "scissor { x1 4 y1 4 } ", kAll) + kReader));
    // Within the reader's limits.
    CHECK(!is_needed(pass("a", "scissor { x1 4 y1 4 } ", kAll) +
                     pass("a", kByAlpha + "scissor { x0 1 x1 4 y1 2 } ", kAll)));
    CHECK(is_needed(pass("a", "scissor { x1 4 y1 4 } ", kAll) +
                    pass("a", kByAlpha + "scissor { x0 1 x1 5 y1 2 } ", kAll)));
}

TEST_CASE("alpha is not needed where a copy brings another", "[legalize]") {
    CHECK(!is_needed(copy("a", "b", "GREEN_TO_ALPHA") + kReader));
    CHECK(!is_needed(copy("a", "b", "ALL") + kReader));
    CHECK(is_needed(copy("a", "b", "ALPHA_TO_COLOR") + kReader));
    CHECK(is_needed(copy("a", "b", "ALL", "from { x1 7 y1 4 }") + kReader));
    CHECK(is_needed(copy("a", "b", "ALL", "from { x1 8 y1 4 } halve true") + kReader));
    CHECK(!is_needed(copy("a", "b", "ALL", "from { x0 1 x1 4 y1 4 } x 2") +
                     copy("b", "a", "ALL", "from { x0 2 x1 5 y1 4 }")));
    CHECK(is_needed(copy("a", "b", "ALL", "from { x0 1 x1 4 y1 4 } x 2") +
                    copy("b", "a", "ALL", "from { x0 1 x1 4 y1 4 }")));
}

TEST_CASE("alpha is not needed where triangles of the same shape write it", "[legalize]") {
    const std::string alpha_alone = "color_mask { red false green false blue false } ";
    const auto both = [&](const std::string& writer, const std::string& reader, const std::string& first = "0",
                          const std::string& other = "3") {
        return is_needed(pass("a", alpha_alone + writer, triangles(first)) +
                         pass("a", kByAlpha + reader, triangles(other)));
    };
    CHECK(!both("", ""));
    CHECK(!both("cull CCW ", "cull CCW "));
    CHECK(both("", "", "0", "6"));  // one corner elsewhere
    CHECK(both("scissor { x1 4 y1 4 } ", ""));
    CHECK(both("cull CW ", ""));
    CHECK(both("viewport { x1 4 y1 4 } ", ""));
    CHECK(is_needed(pass("a", alpha_alone, triangles("0")) + pass("a", kByAlpha, triangles("3") + triangles("3"))));
    CHECK(is_needed(pass("a", alpha_alone, triangles("0")) + pass("a", kByAlpha, kAll)));
    CHECK(is_needed(pass("a", alpha_alone, triangles("0")) + kReader));  // all of it
}

TEST_CASE("alpha is read by textures' arguments, each where it counts", "[legalize]") {
    using enum TextureOp;
    const auto reads = [](const TextureStage& stage) {
        PipelineState state;
        state.stages[0] = stage;
        return reads_texture_alpha(state, 0);
    };
    const TextureArg texture{.source = ArgSource::Texture}, current{.source = ArgSource::Current};
    TextureArg replicated      = texture;
    replicated.alpha_replicate = true;
    CHECK(!reads({}));
    CHECK(!reads({.color_op = Modulate, .alpha_op = SelectArg2}));
    CHECK(reads({.color_op = Modulate, .alpha_op = SelectArg1}));
    CHECK(reads({.color_op = Modulate, .alpha_op = SelectArg2, .alpha_arg2 = texture}));
    CHECK(!reads({.color_op = Modulate, .alpha_op = SelectArg1, .alpha_arg1 = current, .alpha_arg2 = texture}));
    CHECK(reads({.color_op = Modulate, .color_arg1 = replicated, .alpha_op = SelectArg2}));
    CHECK(!reads({.color_op = SelectArg2, .color_arg1 = replicated, .alpha_op = SelectArg2}));
    CHECK(reads({.color_op = ModulateColorAddAlpha, .alpha_op = SelectArg2}));
    CHECK(!reads(
        {.color_op = ModulateColorAddAlpha, .color_arg1 = current, .color_arg2 = texture, .alpha_op = SelectArg2}));
    CHECK(reads({.color_op = BlendTextureAlpha, .color_arg1 = current, .alpha_op = SelectArg2}));
    CHECK(!reads({.color_op = BlendCurrentAlpha, .alpha_op = SelectArg2}));
    PipelineState state;
    state.stages[1] = {.color_op = SelectArg1, .alpha_op = SelectArg1};
    CHECK(!reads_texture_alpha(state, 1));  // after the end of the chain
}

TEST_CASE("alpha of a target is read in a frame, whenever", "[legalize]") {
    const auto is_read = [](const std::string& passes, int target) {
        return is_alpha_read(parsed(text(passes)), {target});
    };
    CHECK(!is_read("", 0));
    CHECK(is_read(kReader, 0));
    CHECK(!is_read(kReader, 1));
    CHECK(is_read(pass("a", "dest_alpha_test ZERO ", kAll), 0));
    CHECK(is_read(copy("b", "a", "ALL"), 0));
}

TEST_CASE("formats that keep alpha", "[legalize]") {
    using enum TargetFormat;
    for (const TargetFormat format : {A8R8G8B8, A1R5G5B5, R6G6B6A6, Psmct32, Psmct16}) CHECK(keeps_alpha(format));
    for (const TargetFormat format : {X8R8G8B8, R5G6B5, Psmct24, D16, D24, D32}) CHECK(!keeps_alpha(format));
}
