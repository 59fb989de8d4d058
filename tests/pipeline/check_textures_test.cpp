// SPDX-License-Identifier: MIT
// The rules of check for textures and their stages.
#include "tests/support/check_frame.h"

using namespace pipeline;
using namespace test_support::check_frame;

TEST_CASE("check: sizes of textures", "[check]") {
    const auto size = [](int width, int height) { return [=](Frame& f) { set_size(f.textures[0], width, height); }; };
    const auto clamped = [&](int width, int height) {
        return [=](Frame& f) {
            set_size(f.textures[0], width, height);
            stage(f).address_u = stage(f).address_v = TextureAddress::Clamp;
        };
    };
    check_allowed("ps2", size(1024, 512));
    check_refused("ps2", size(2048, 8),
                  "texture 0 'noise' | limits | width 2048 height 8 | up to width 1024 height 1024\n");
    check_allowed("gamecube", size(8, 1024));
    check_refused("gamecube", size(8, 2048),
                  "texture 0 'noise' | limits | width 8 height 2048 | up to width 1024 height 1024\n");
    check_allowed("dx7", size(2048, 8));
    check_refused("dx7", size(4096, 8),
                  "texture 0 'noise' | limits | width 4096 height 8 | up to width 2048 height 2048\n");
    check_allowed("xbox", size(4096, 8));
    check_refused("xbox", size(8192, 8),
                  "texture 0 'noise' | limits | width 8192 height 8 | up to width 4096 height 4096\n");
    for (const char* chip : {"dx7", "ps2", "gamecube", "xbox", "ideal"}) check_allowed(chip, clamped(48, 8));
    check_allowed("ideal", size(8192, 8));
}

TEST_CASE("check: formats of textures", "[check]") {
    // All chips have all that frames have; a chip that had less would say so.
    Profile chip                = profile("dx7");
    chip.limits.texture_formats = {TextureFormat::A8R8G8B8};
    CHECK(text_of(check(frame_for(chip), chip)) == "texture 1 'mips': format | limits | L8 | A8R8G8B8\n");
    for (const Profile& one : profiles())
        check_allowed(one.name, [](Frame& f) {
            f.textures[0].format = TextureFormat::A8;
            set_size(f.textures[0], 8, 8);
        });
}

TEST_CASE("check: the number of stages", "[check]") {
    const auto two = [](Frame& f) {
        state(f).stages[1].color_op = TextureOp::SelectArg2;
        state(f).stages[1].alpha_op = TextureOp::SelectArg2;
    };
    check_refused("ps2", two, "pass 0 'draw': state.stages | stages | 2 | 1\n");
    for (const char* chip : {"dx7", "gamecube", "xbox", "ideal"}) check_allowed(chip, two);
}

TEST_CASE("check: arguments of stages", "[check]") {
    const auto argument = [](const TextureArg& arg) { return [=](Frame& f) { stage(f).color_arg2 = arg; }; };
    const TextureArg factor{.source = ArgSource::TFactor}, inverse{.complement = true}, alpha{.alpha_replicate = true};
    check_refused("ps2", argument(factor),
                  "pass 0 'draw': state.stages[0].color_arg2.source | stages | TFACTOR | DIFFUSE CURRENT TEXTURE\n");
    check_refused("ps2", argument(alpha),
                  "pass 0 'draw': state.stages[0].color_arg2.alpha_replicate | stages | true | false\n");
    check_refused("gamecube", argument(inverse),
                  "pass 0 'draw': state.stages[0].color_arg2.complement | stages | true | false\n");
    check_allowed("gamecube", argument(factor));
    check_allowed("gamecube", argument(alpha));
    check_allowed("dx7", argument(inverse));
    // An argument that the function does not read.
    check_allowed("ps2", [&](Frame& f) {
        argument(factor)(f);
        stage(f).color_op = TextureOp::SelectArg1;
        stage(f).alpha_op = TextureOp::SelectArg1;
    });
    // Every one of both functions is looked at.
    check_refused(
        "ps2",
        [&](Frame& f) {
            stage(f).color_arg2 = factor;
            stage(f).alpha_arg2 = factor;
            state(f).stages[1]  = stage(f);
        },
        "pass 0 'draw': state.stages | stages | 2 | 1\n"
        "pass 0 'draw': state.stages[0].color_arg2.source | stages | TFACTOR | DIFFUSE CURRENT TEXTURE\n"
        "pass 0 'draw': state.stages[0].alpha_arg2.source | stages | TFACTOR | DIFFUSE CURRENT TEXTURE\n"
        "pass 0 'draw': state.stages[1].color_arg2.source | stages | TFACTOR | DIFFUSE CURRENT TEXTURE\n"
        "pass 0 'draw': state.stages[1].alpha_arg2.source | stages | TFACTOR | DIFFUSE CURRENT TEXTURE\n");
}

TEST_CASE("check: functions of stages", "[check]") {
    using enum TextureOp;
    const auto ops = [](TextureOp color, TextureOp alpha) {
        return [=](Frame& f) {
            stage(f).color_op = color;
            stage(f).alpha_op = alpha;
        };
    };
    const std::string has = " | DISABLE SELECTARG1 SELECTARG2 MODULATE ADD MODULATECOLOR_ADDALPHA\n";
    check_refused("ps2", ops(AddSigned, Modulate2X),
                  "pass 0 'draw': state.stages[0].color_op | stages | ADDSIGNED" + has +
                      "pass 0 'draw': state.stages[0].alpha_op | stages | MODULATE2X" + has);
    for (const char* chip : {"dx7", "gamecube", "xbox"}) check_allowed(chip, ops(AddSigned, Modulate2X));

    // TFX and TCC. ARG1 is the texel, ARG2 the vertex's colour.
    check_allowed("ps2", ops(Modulate, Modulate));      // MODULATE, TCC 1
    check_allowed("ps2", ops(Modulate, SelectArg2));    // TCC 0
    check_allowed("ps2", ops(SelectArg1, SelectArg1));  // DECAL
    check_allowed("ps2", ops(SelectArg1, SelectArg2));
    check_allowed("ps2", ops(SelectArg2, SelectArg2));  // no texture
    const auto refused = [&](TextureOp color, TextureOp alpha, const std::string& uses) {
        check_refused("ps2", ops(color, alpha),
                      "pass 0 'draw': state.stages[0] | stages | " + uses + " | MODULATE DECAL HIGHLIGHT HIGHLIGHT2\n");
    };
    refused(Modulate, SelectArg1, "color_op MODULATE alpha_op SELECTARG1");
    refused(SelectArg1, Modulate, "color_op SELECTARG1 alpha_op MODULATE");
    refused(SelectArg2, SelectArg1, "color_op SELECTARG2 alpha_op SELECTARG1");
    refused(Add, Add, "color_op ADD alpha_op ADD");
    refused(ModulateColorAddAlpha, Add, "color_op MODULATECOLOR_ADDALPHA alpha_op ADD");  // adds the texel's alpha

    // HIGHLIGHT adds the vertex's alpha, so that it is ARG1 of the colour.
    const auto highlight = [&](TextureOp alpha) {
        return [=](Frame& f) {
            ops(ModulateColorAddAlpha, alpha)(f);
            stage(f).color_arg1 = {.source = ArgSource::Diffuse};
            stage(f).color_arg2 = {.source = ArgSource::Texture};
        };
    };
    check_allowed("ps2", highlight(Add));         // HIGHLIGHT
    check_allowed("ps2", highlight(SelectArg1));  // HIGHLIGHT2
    check_allowed("ps2", highlight(SelectArg2));
    check_refused("ps2", highlight(Modulate),
                  "pass 0 'draw': state.stages[0] | stages | color_op MODULATECOLOR_ADDALPHA color_arg1 { source "
                  "DIFFUSE } color_arg2 { source TEXTURE } alpha_op MODULATE | MODULATE DECAL HIGHLIGHT HIGHLIGHT2\n");
}

TEST_CASE("check: addresses and mip filters", "[check]") {
    const auto mirror = [](Frame& f) { stage(f).address_u = TextureAddress::Mirror; };
    check_refused("ps2", mirror, "pass 0 'draw': state.stages[0].address_u | stages | MIRROR | WRAP CLAMP\n");
    check_refused(
        "ps2", [](Frame& f) { stage(f).address_v = TextureAddress::Mirror; },
        "pass 0 'draw': state.stages[0].address_v | stages | MIRROR | WRAP CLAMP\n");
    check_allowed("gamecube", mirror);
    check_allowed("ps2", [&](Frame& f) {
        mirror(f);
        rectangle(f).textures = {};
    });

    const auto mips = [](Frame& f) {
        stage(f).mip_filter              = MipFilter::Point;
        rectangle(f).textures[0].texture = {1};
    };
    check_refused("ps2", mips, "pass 0 'draw': state.stages[0].mip_filter | lod | POINT | NONE\n");
    check_allowed("xbox", mips);
    // A texture with one level.
    check_allowed("ps2", [&](Frame& f) {
        mips(f);
        rectangle(f).textures[0].texture = {0};
    });
}
