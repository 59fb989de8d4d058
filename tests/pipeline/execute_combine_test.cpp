// SPDX-License-Identifier: MIT
// Texture stages from the frame's state to the bytes: operations, arguments and their modifiers, colour and alpha
// apart.
// Expected bytes are worked out by hand: products are divided by 255 and rounded to nearest, ADDSIGNED takes 127 off.
#include "pipeline/frame/frame_text.h"
#include "tests/support/small_frame.h"

using namespace pipeline;
using namespace test_support;

namespace {

TextureId add_texel(Frame& frame, std::uint32_t argb) {
    const auto byte = [&](int shift) { return static_cast<std::uint8_t>(argb >> shift); };
    return add_texture(frame, TextureFormat::A8R8G8B8, 1, 1, {byte(0), byte(8), byte(16), byte(24)});
}

// Colour from one, alpha from the other.
std::uint32_t joined(std::uint32_t color, std::uint32_t alpha) {
    return (color & 0x00ffffff) | (alpha & 0xff000000);
}

}  // namespace

TEST_CASE("each texture operation, in colour and in alpha", "[execute]") {
    constexpr std::uint32_t kTexel = 0x9028c85a, kFactor = 0x50463cf0, kDiffuse = 0x11223344;
    constexpr std::uint32_t kCurrent = ~kFactor;  // what the first stage leaves
    const struct Row {
        TextureOp op;
        std::uint32_t expected;  // of the texel, then the texture factor
    } rows[] = {
        {TextureOp::Disable, kCurrent},
        {TextureOp::SelectArg1, kTexel},
        {TextureOp::SelectArg2, kFactor},
        {TextureOp::Modulate, 0x2d0b2f55},
        {TextureOp::Modulate2X, 0x5a165ea9},
        {TextureOp::Modulate4X, 0xb52cbcff},
        {TextureOp::Add, 0xe06effff},
        {TextureOp::AddSigned, 0x610085cb},
        {TextureOp::AddSigned2X, 0xc100ffff},
        {TextureOp::Subtract, 0x40008c00},
        {TextureOp::BlendDiffuseAlpha, 0x544445e6},      // red: (40 * 17 + 70 * 238) / 255 = 68
        {TextureOp::BlendTextureAlpha, 0x74358b9b},      // red: (40 * 144 + 70 * 111) / 255 = 53.06
        {TextureOp::BlendFactorAlpha, 0x643d68c1},       // red: (40 * 80 + 70 * 175) / 255 = 60.59
        {TextureOp::BlendCurrentAlpha, 0x7c319c89},      // red: (40 * 175 + 70 * 80) / 255 = 49.41
        {TextureOp::ModulateColorAddAlpha, 0xbd9bbfe5},  // red: 40 * 70 / 255 = 10.98, and 144
    };
    check_table(rows, &Row::op, &Row::expected);

    const auto combined = [&](TextureOp color_op, TextureOp alpha_op) {
        Frame frame               = small_frame(18, 1);
        Pass& pass                = frame.passes[0];
        pass.state.texture_factor = {kFactor};
        const TextureArg inverted = {.source = ArgSource::TFactor, .complement = true};
        pass.state.stages[0]      = {.color_op   = TextureOp::SelectArg1,
                                     .color_arg1 = inverted,
                                     .alpha_op   = TextureOp::SelectArg1,
                                     .alpha_arg1 = inverted};
        pass.state.stages[1]      = {.color_op   = color_op,
                                     .color_arg1 = {.source = ArgSource::Texture},
                                     .color_arg2 = {.source = ArgSource::TFactor},
                                     .alpha_op   = alpha_op,
                                     .alpha_arg1 = {.source = ArgSource::Texture},
                                     .alpha_arg2 = {.source = ArgSource::TFactor}};
        DrawRectangle draw        = rectangle({0, 0, 18, 1}, kDiffuse);
        draw.textures[1]          = bound(add_texel(frame, kTexel));
        pass.draws                = {draw};
        return color_on_both(frame);
    };
    for (const Row& color : rows)
        for (const Row& alpha : rows) {
            if ((color.op == TextureOp::Disable) != (alpha.op == TextureOp::Disable)) continue;  // not valid
            INFO(enum_name(color.op) << ", " << enum_name(alpha.op));
            CHECK(combined(color.op, alpha.op) == joined(color.expected, alpha.expected));
        }
}

TEST_CASE("each source of an argument, in both stages, in colour and in alpha", "[execute]") {
    const std::uint32_t texels[2] = {0x0badcafe, 0x55667788};
    const struct Row {
        ArgSource source;
        std::array<std::uint32_t, 2> expected;  // in the first stage; in the second, the first having left ~diffuse
    } rows[] = {
        {ArgSource::Diffuse, {0x12345678, 0x12345678}},  {ArgSource::Current, {0x12345678, 0xedcba987}},
        {ArgSource::Texture, {0x0badcafe, 0x55667788}},  {ArgSource::TFactor, {0xdeadbeef, 0xdeadbeef}},
        {ArgSource::Specular, {0xffbcdef0, 0xffbcdef0}},
    };
    check_table(rows, &Row::source, [](const Row& row) { return row.expected[1]; });

    for (const std::size_t index : {0, 1})
        for (const Row& color : rows)
            for (const Row& alpha : rows) {
                INFO("stage " << index << ": " << enum_name(color.source) << ", " << enum_name(alpha.source));
                Frame frame               = small_frame(5, 3);
                Pass& pass                = frame.passes[0];
                pass.state.texture_factor = {0xdeadbeef};
                const TextureArg inverted{.source = ArgSource::Diffuse, .complement = true};
                pass.state.stages[0] = {.color_op   = TextureOp::SelectArg1,
                                        .color_arg1 = inverted,
                                        .alpha_op   = TextureOp::SelectArg1,
                                        .alpha_arg1 = inverted};
                TextureStage& stage  = pass.state.stages[index];
                stage.color_op = stage.alpha_op = TextureOp::SelectArg1;
                stage.color_arg1                = {.source = color.source};
                stage.alpha_arg1                = {.source = alpha.source};
                DrawTriangles draw              = add_quad(frame, 0x12345678, 0.0f, 0x9abcdef0);
                draw.textures = {bound(add_texel(frame, texels[0])), bound(add_texel(frame, texels[1]))};
                pass.draws    = {draw};
                CHECK(color_on_both(frame) == joined(color.expected[index], alpha.expected[index]));
            }
}

TEST_CASE("a rectangle's specular is black", "[execute]") {
    Frame frame          = small_frame(2, 2);
    Pass& pass           = frame.passes[0];
    pass.state.stages[0] = {.color_op   = TextureOp::SelectArg1,
                            .color_arg1 = {.source = ArgSource::Specular},
                            .alpha_op   = TextureOp::SelectArg1,
                            .alpha_arg1 = {.source = ArgSource::Specular}};
    pass.draws           = {rectangle({0, 0, 2, 2}, 0x12345678)};
    CHECK(color_on_both(frame) == 0xff000000);
}

TEST_CASE("complement and alpha_replicate change the argument they stand at", "[execute]") {
    const struct Row {
        bool complement, alpha_replicate;
        std::uint32_t expected;
    } rows[] = {
        {false, false, 0x4080c020}, {true, false, 0xbf7f3fdf}, {false, true, 0x40404040}, {true, true, 0xbfbfbfbf}};
    const struct Place {
        const char* name;
        TextureArg TextureStage::*arg;
        bool is_first, is_color;
    } places[] = {{"color_arg1", &TextureStage::color_arg1, true, true},
                  {"color_arg2", &TextureStage::color_arg2, false, true},
                  {"alpha_arg1", &TextureStage::alpha_arg1, true, false},
                  {"alpha_arg2", &TextureStage::alpha_arg2, false, false}};
    for (const Place& place : places)
        for (const Row& row : rows) {
            INFO(place.name << ' ' << row.complement << row.alpha_replicate);
            Frame frame         = small_frame(3, 1);
            Pass& pass          = frame.passes[0];
            // The other three arguments are the same texel as it is.
            TextureStage& stage = pass.state.stages[0];
            stage.color_op = stage.alpha_op = place.is_first ? TextureOp::SelectArg1 : TextureOp::SelectArg2;
            for (const Place& each : places) stage.*each.arg = {.source = ArgSource::Texture};
            stage.*place.arg          = {ArgSource::Texture, row.complement, row.alpha_replicate};
            DrawRectangle draw        = rectangle({0, 0, 3, 1}, 0);
            draw.textures[0]          = bound(add_texel(frame, 0x4080c020));
            pass.draws                = {draw};
            const std::uint32_t plain = rows[0].expected;
            CHECK(color_on_both(frame) == (place.is_color ? joined(row.expected, plain) : joined(plain, row.expected)));
        }
}

TEST_CASE("a stage works on what the stage before left, each with its own texture and coordinates", "[execute]") {
    // Stage 0 on the left: red 0x80 * 0xff, green 0x40 * 0x80, blue 0x20 * 0x40, alpha of the diffuse colour; on the
    // right the same with its second texel. Stage 1 takes its texels the other way around.
    Frame frame = parse_frame(R"(nimbus7 frame 1
        output "color"
        targets ["color" { width 2 height 1 }]
        passes ["two stages" {
            color "color"
            state { stages [
                { color_op MODULATE color_arg2 { source DIFFUSE } alpha_op SELECTARG2 }
                { color_op ADD alpha_op SUBTRACT alpha_arg1 { source CURRENT } alpha_arg2 { source TEXTURE } }
            ] }
            draws [rectangle {
                x1 2 y1 1 color 0x80ff8040
                uv [{} { u0 1 u1 0 }]
                textures [{ texture "first" } { texture "second" }]
            }]
        }]
        textures [
            "first" { width 2 height 1 texels [204080c0 ff000000] }
            "second" { width 2 height 1 texels [01020304 40301020] }
        ])");
    CHECK(pixels_on_both(frame) == std::vector<std::uint32_t>{0x60905048, 0x7c030241});

    frame.passes[0].state.stages[1] = {};
    CHECK(pixels_on_both(frame) == std::vector<std::uint32_t>{0x80802008, 0x80000040});
}

TEST_CASE("specular and fog come after the stages, where the state says so", "[execute]") {
    Frame frame           = small_frame(4, 4);
    PipelineState& state  = frame.passes[0].state;
    frame.passes[0].draws = {add_quad(frame, 0x40203040, 0.5f, 0x00e01020)};
    CHECK(color_on_both(frame) == 0x40203040);
    state.lighting.specular_enable = true;
    CHECK(color_on_both(frame) == 0x40ff4060);
    // Half-way between start and end: 128 of the colour, 127 of the fog.
    state.fog = {.mode = FogMode::Linear, .color = {0xff0000ff}, .start = 0.0f, .end = 1.0f};
    CHECK(color_on_both(frame) == 0x408020af);
    state.lighting.specular_enable = false;
    CHECK(color_on_both(frame) == 0x4010189f);
}
