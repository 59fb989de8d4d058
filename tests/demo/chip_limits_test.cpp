// SPDX-License-Identifier: MIT
// What frames are told that a chip does not have, and the formats that they get on it.
#include <catch2/catch.hpp>
#include <functional>

#include "demo/command_profiles.h"
#include "demo/vectors/chip_limits.h"
#include "tests/support/small_frame.h"

namespace demo {
namespace {

using namespace pipeline;

const Profile& profile(std::string_view name) {
    const Profile* found = find_profile(name);
    REQUIRE(found != nullptr);
    return *found;
}

// One pass, of a rectangle, on a target of the format.
Frame one_pass(TargetFormat format = TargetFormat::A8R8G8B8) {
    Frame frame;
    frame.output = {0};
    frame.targets.push_back({"picture", format, 4, 4});
    Pass& pass = frame.passes.emplace_back();
    pass.color = {0};
    pass.draws = {DrawRectangle{.x1 = 4, .y1 = 4}};
    return frame;
}

std::string missing(std::string_view name, const std::function<void(Pass&)>& change,
                    TargetFormat format = TargetFormat::A8R8G8B8) {
    Frame frame = one_pass(format);
    change(frame.passes[0]);
    return what_is_missing(put_on_chip(frame, profile(name)), profile(name));
}

}  // namespace

TEST_CASE("targets become the chip's own formats", "[vectors]") {
    using enum TargetFormat;
    const auto on = [](std::string_view name, TargetFormat format) {
        return put_on_chip(one_pass(format), profile(name)).targets[0].format;
    };
    CHECK(on("ideal", A8R8G8B8) == A8R8G8B8);
    CHECK(on("dx7", A8R8G8B8) == A8R8G8B8);
    CHECK(on("xbox", X8R8G8B8) == X8R8G8B8);
    CHECK(on("ps2", A8R8G8B8) == Psmct32);
    CHECK(on("ps2", X8R8G8B8) == Psmct24);
    CHECK(on("ps2", R5G6B5) == R5G6B5);  // which it lacks
    CHECK(on("gamecube", A8R8G8B8) == R6G6B6A6);
    CHECK(on("gamecube", X8R8G8B8) == X8R8G8B8);

    // What the GameCube copies to alone stays what it is.
    Frame frame = one_pass(X8R8G8B8);
    frame.targets.push_back({"copy", A8R8G8B8, 4, 4});
    Pass& copy = frame.passes.emplace_back();
    copy.color = {1};
    copy.draws = {CopyRectangle{.source = {0}, .from = {0, 0, 4, 4}}};
    CHECK(put_on_chip(frame, profile("gamecube")).targets[1].format == A8R8G8B8);
    CHECK(what_is_missing(put_on_chip(frame, profile("gamecube")), profile("gamecube")) == "");
    CHECK(what_is_missing(put_on_chip(frame, profile("xbox")), profile("xbox")) ==
          "xbox has no copies from one format to another");
    copy.clear.color = Argb{0};
    CHECK(put_on_chip(frame, profile("gamecube")).targets[1].format == R6G6B6A6);
    CHECK(what_is_missing(put_on_chip(frame, profile("gamecube")), profile("gamecube")) ==
          "gamecube has no copies to R6G6B6A6");
}

TEST_CASE("what a chip does not have is said in words", "[vectors]") {
    const auto blend = [](BlendFactor source, BlendFactor dest) {
        return [=](Pass& pass) { pass.state.blend = {source, dest}; };
    };
    using enum BlendFactor;
    CHECK(missing("ps2", blend(SourceAlpha, InvSourceAlpha)) == "ps2 has no blend by two factors");
    CHECK(missing("gamecube", blend(SourceColor, Zero)) == "gamecube has no blend factor SRCCOLOR for the source");
    CHECK(missing("gamecube", blend(Zero, InvDestColor)) ==
          "gamecube has no blend factor INVDESTCOLOR for the destination");
    CHECK(missing("gamecube", blend(DestColor, SourceColor)) == "");
    CHECK(missing("xbox", blend(SourceColor, DestColor)) == "");
    CHECK(missing("dx7", [](Pass& pass) { pass.state.gs_blend.a = GsColor::Cd; }) ==
          "dx7 has no blend by register ALPHA");

    const auto mask = [](Pass& pass) { pass.state.color_mask.alpha = false; };
    const auto red  = [](Pass& pass) { pass.state.color_mask.red = false; };
    CHECK(missing("dx7", mask) == "dx7 has no colour mask");
    CHECK(missing("gamecube", mask) == "");
    CHECK(missing("gamecube", red) == "gamecube has no mask for red, green or blue alone");
    CHECK(missing("ps2", red) == "");
    CHECK(missing("xbox", red) == "");

    const auto scissor = [](Pass& pass) { pass.state.scissor = {0, 0, 2, 2}; };
    CHECK(missing("dx7", scissor) == "dx7 has no scissor");
    CHECK(missing("xbox", scissor) == "");
    CHECK(missing("xbox", [](Pass& pass) { pass.state.dest_alpha_test = DestAlphaTest::One; }) ==
          "xbox has no test of the alpha in the target");
    CHECK(missing("gamecube", [](Pass& pass) { pass.state.alpha_test.fail = AlphaFail::ZbOnly; }) ==
          "gamecube has no write of fragments that fail the alpha test (ZB_ONLY)");
    CHECK(missing("xbox", [](Pass& pass) { pass.state.dither.mode = DitherMode::Flipper2x2; }) ==
          "xbox has no dither FLIPPER_2X2");
    CHECK(missing("ps2", [](Pass& pass) { pass.state.lighting.specular_enable = true; }) ==
          "ps2 has no addition of a second colour");
    CHECK(missing(
              "xbox", [](Pass&) {}, TargetFormat::A1R5G5B5) == "xbox has no drawing to A1R5G5B5");

    const auto flat = [](Pass& pass) {
        pass.state.shade = ShadeMode::Flat;
        pass.draws       = {DrawTriangles{}};
    };
    CHECK(missing("ps2", flat) == "ps2 has no flat shading by the first vertex");
    CHECK(missing("gamecube", flat) == "gamecube has no flat shading");
    CHECK(missing("dx7", flat) == "");
    CHECK(missing("ps2", [](Pass& pass) {
              pass.state.cull = CullMode::Clockwise;
              pass.draws      = {DrawTriangles{}};
          }) == "ps2 has no culling");
}

TEST_CASE("the Graphics Synthesizer has its texture functions alone", "[vectors]") {
    const TextureArg diffuse{.source = ArgSource::Diffuse}, texel{.source = ArgSource::Texture};
    const auto of = [&](TextureOp color, TextureOp alpha, TextureArg one, TextureArg other) {
        return missing("ps2", [=](Pass& pass) {
            pass.state.stages[0] = {.color_op   = color,
                                    .color_arg1 = one,
                                    .color_arg2 = other,
                                    .alpha_op   = alpha,
                                    .alpha_arg1 = texel,
                                    .alpha_arg2 = diffuse};
        });
    };
    using enum TextureOp;
    for (const TextureOp alpha : {Modulate, SelectArg2}) CHECK(of(Modulate, alpha, texel, diffuse) == "");
    for (const TextureOp alpha : {SelectArg1, SelectArg2}) CHECK(of(SelectArg1, alpha, texel, diffuse) == "");
    for (const TextureOp alpha : {Add, SelectArg1, SelectArg2})
        CHECK(of(ModulateColorAddAlpha, alpha, diffuse, texel) == "");
    CHECK(of(SelectArg2, SelectArg2, texel, diffuse) == "");
    for (const TextureOp alpha : {SelectArg1, Add}) CHECK(of(Modulate, alpha, texel, diffuse) != "");
    CHECK(of(SelectArg1, Modulate, texel, diffuse) != "");
    CHECK(of(SelectArg2, SelectArg1, texel, diffuse) != "");
    CHECK(of(Add, Add, texel, diffuse) == "ps2 has no texture function ADD with ADD of alpha and such arguments");
    CHECK(of(ModulateColorAddAlpha, Add, texel, diffuse) != "");
    CHECK(of(Modulate, Modulate, diffuse, diffuse) != "");
    CHECK(of(Subtract, Modulate, texel, diffuse) == "ps2 has no texture function SUBTRACT");

    const auto stage = [](const std::function<void(TextureStage&)>& change) {
        return missing("ps2", [&](Pass& pass) {
            pass.state.stages[0] = {.color_op = SelectArg1, .alpha_op = SelectArg1};
            change(pass.state.stages[0]);
        });
    };
    CHECK(stage([](TextureStage& one) { one.address_v = TextureAddress::Mirror; }) ==
          "ps2 has no texture address MIRROR");
    CHECK(stage([](TextureStage& one) { one.mip_filter = MipFilter::Point; }) ==
          "ps2 has no level of detail by the texels that a pixel spans (mip filter POINT)");
    CHECK(stage([](TextureStage& one) { one.color_arg1.source = ArgSource::TFactor; }) ==
          "ps2 has no stage argument TFACTOR");
    CHECK(stage([](TextureStage& one) { one.color_arg2.source = ArgSource::TFactor; }) == "");  // not read
    CHECK(stage([](TextureStage& one) { one.color_arg1.complement = true; }) ==
          "ps2 has no complement of a stage argument");
    CHECK(stage([](TextureStage& one) { one.alpha_arg1.alpha_replicate = true; }) ==
          "ps2 has no stage argument of alpha in every channel");
    CHECK(missing("ps2", [](Pass& pass) {
              pass.state.stages[0] = pass.state.stages[1] = {.color_op = SelectArg1, .alpha_op = SelectArg1};
          }) == "ps2 has no second texture stage");
}

TEST_CASE("a depth format that the colour format does not go with is missing", "[vectors]") {
    Frame frame = one_pass();
    frame.targets.push_back({"depth", TargetFormat::D16, 4, 4});
    frame.passes[0].depth = {1};
    const auto of         = [&](std::string_view name) {
        return what_is_missing(put_on_chip(frame, profile(name)), profile(name));
    };
    CHECK(of("ps2") == "ps2 has no D16 beside PSMCT32");
    CHECK(of("gamecube") == "gamecube has no depth of D16");
    CHECK(of("dx7") == "");
    frame.targets[0].format = TargetFormat::Psmct16;
    CHECK(of("ps2") == "");
}

TEST_CASE("open questions are told of one profile or of all", "[vectors]") {
    const std::string all = open_questions();
    std::string joined;
    for (const Profile& one : profiles()) joined += open_questions(&one);
    CHECK(joined == all);
    CHECK(open_questions(&profile("ideal")) == "");
    const std::string ps2 = open_questions(&profile("ps2"));
    CHECK(ps2.find("`ps2`, targets: ") != std::string::npos);
    CHECK(ps2.find("`dx7`") == std::string::npos);
}

}  // namespace demo
