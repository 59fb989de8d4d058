// SPDX-License-Identifier: MIT
// What the truth makes of a fragment's colour, in closed form: stages, tests, blends, copies, texels.
#include <catch2/catch.hpp>
#include <cmath>

#include "pipeline/truth/truth.h"
#include "tests/support/small_frame.h"

namespace {

using namespace pipeline;
using namespace test_support;
using Value = std::array<double, 4>;

// Red, green, blue, alpha, from bytes.
Value bytes(double r, double g, double b, double a) {
    return {r / 255.0, g / 255.0, b / 255.0, a / 255.0};
}

void check_near(const Value& got, const Value& want) {
    INFO(got[0] * 255 << " " << got[1] * 255 << " " << got[2] * 255 << " " << got[3] * 255);
    INFO(want[0] * 255 << " " << want[1] * 255 << " " << want[2] * 255 << " " << want[3] * 255);
    for (std::size_t i = 0; i < 4; ++i) CHECK(std::abs(got[i] - want[i]) < 1e-12);
}

// The one colour of a frame's picture, with any number of samples.
Value color_of(const Frame& frame) {
    const Value first = draw_truth(frame, {.samples_per_axis = 1}).pixels.at(0);
    for (const int samples : {1, 2})
        for (const Value& value : draw_truth(frame, {.samples_per_axis = samples}).pixels) check_near(value, first);
    return first;
}

// `source` drawn on `there` with the pass's state.
Frame drawn_on(std::uint32_t there, std::uint32_t source, const PipelineState& state) {
    Frame frame                 = small_frame(2, 2);
    frame.passes[0].clear.color = Argb{there};
    frame.passes[0].state       = state;
    frame.passes[0].draws.push_back(rectangle({0, 0, 2, 2}, source));
    return frame;
}

}  // namespace

TEST_CASE("the truth blends in closed form", "[truth]") {
    constexpr std::uint32_t kSource = 0x60c83214, kThere = 0x3264a0f0;
    const Value s = bytes(200, 50, 20, 96), d = bytes(100, 160, 240, 50);
    const auto blended = [&](BlendFactor source, BlendFactor dest) {
        return color_of(drawn_on(kThere, kSource, {.blend = {source, dest}}));
    };
    const auto want = [&](auto formula) {
        Value out{};
        for (std::size_t i = 0; i < 4; ++i) out[i] = std::min(1.0, formula(s[i], d[i]));
        return out;
    };
    using enum BlendFactor;
    check_near(blended(One, Zero), s);
    check_near(blended(SourceAlpha, InvSourceAlpha),
               want([&](double a, double b) { return a * s[3] + b * (1 - s[3]); }));
    check_near(blended(Zero, SourceColor), want([](double a, double b) { return a * b; }));
    check_near(blended(One, One), want([](double a, double b) { return a + b; }));
    check_near(blended(DestColor, InvSourceColor), want([](double a, double b) { return a * b + b * (1 - a); }));
    check_near(blended(InvDestColor, InvDestAlpha),
               want([&](double a, double b) { return a * (1 - b) + b * (1 - d[3]); }));
    check_near(blended(DestAlpha, SourceAlpha), want([&](double a, double b) { return a * d[3] + b * s[3]; }));
    check_near(color_of(drawn_on(kThere, kSource, {.color_mask = {true, false, true, false}})),
               {s[0], d[1], s[2], d[3]});
}

TEST_CASE("the truth blends as the Graphics Synthesizer means it, but unrounded", "[truth]") {
    const auto blended = [&](const GsBlend& blend, std::uint32_t there, std::uint32_t source) {
        Frame frame            = drawn_on(there, source, {.gs_blend = blend});
        frame.arithmetic.blend = BlendRule::GsShift7;
        return color_of(frame);
    };
    using enum GsColor;
    // (Cs - Cd) * As / 128 + Cd
    const GsBlend over{.a = Cs, .b = Cd, .c = GsAlpha::As, .d = Cd};
    check_near(blended(over, 0x10646464, 0x41c80000),
               bytes(100 + 100 * 65 / 128.0, 100 - 100 * 65 / 128.0, 100 - 100 * 65 / 128.0, 65));
    GsBlend only_high = over;
    only_high.pabe    = true;
    check_near(blended(only_high, 0x10646464, 0x41c80000), bytes(200, 0, 0, 65));
    check_near(blended({.a = Cd, .b = Zero, .c = GsAlpha::Fix, .d = Cs, .fix = 64}, 0x00646464, 0x10c80000),
               bytes(250, 50, 50, 16));
    GsBlend added{.a = Cd, .b = Zero, .c = GsAlpha::Fix, .d = Cs, .fix = 128, .fba = true};
    check_near(blended(added, 0x00646464, 0x10c80000), bytes(255, 100, 100, 144));
    added.colclamp = false;
    check_near(blended(added, 0x00646464, 0x10c80000), bytes(300 - 256, 100, 100, 144));
    check_near(blended({.a = Cs, .b = Zero, .c = GsAlpha::Ad, .d = Zero}, 0x40646464, 0x10c80000),
               bytes(100, 0, 0, 16));
}

TEST_CASE("the truth's stages compute without rounding", "[truth]") {
    struct Row {
        TextureOp op;
        double want;  // of arguments 200 and 90, in bytes; alphas: diffuse 60, texture factor 150
    };
    const Row row = GENERATE(Row{TextureOp::SelectArg1, 200}, Row{TextureOp::SelectArg2, 90},
                             Row{TextureOp::Modulate, 200 * 90 / 255.0}, Row{TextureOp::Modulate2X, 400 * 90 / 255.0},
                             Row{TextureOp::Modulate4X, 255}, Row{TextureOp::Add, 255},
                             Row{TextureOp::AddSigned, 290 - 127.5}, Row{TextureOp::AddSigned2X, 255},
                             Row{TextureOp::Subtract, 110}, Row{TextureOp::BlendDiffuseAlpha, 90 + 110 * 60 / 255.0},
                             Row{TextureOp::BlendFactorAlpha, 90 + 110 * 150 / 255.0},
                             Row{TextureOp::BlendTextureAlpha, 200},  // white, nothing is bound
                             Row{TextureOp::BlendCurrentAlpha, 90 + 110 * 60 / 255.0},
                             Row{TextureOp::ModulateColorAddAlpha, 200 * 90 / 255.0 + 60});
    PipelineState state;
    state.texture_factor = {0x965a5a5a};
    state.stages[0]      = {.color_op   = row.op,
                            .color_arg1 = {.source = ArgSource::Diffuse},
                            .color_arg2 = {.source = ArgSource::TFactor},
                            .alpha_op   = TextureOp::SelectArg1,
                            .alpha_arg1 = {.source = ArgSource::Diffuse, .complement = true}};
    INFO(enum_name(row.op));
    check_near(color_of(drawn_on(0, 0x3cc8c8c8, state)), bytes(row.want, row.want, row.want, 195));
    if (row.op != TextureOp::Modulate) return;
    Frame frame              = drawn_on(0, 0x3cc8c8c8, state);
    frame.arithmetic.combine = CombineRule::GsShift7;
    check_near(color_of(frame), bytes(200 * 90 / 128.0, 200 * 90 / 128.0, 200 * 90 / 128.0, 195));
}

TEST_CASE("the truth's tests take and leave what they should", "[truth]") {
    // Depth 0.5 is there; the fragment's is 0.25. Alpha 100 is there, the fragment's is 200.
    const auto drawn = [](const PipelineState& state, TargetFormat format = TargetFormat::A8R8G8B8) {
        Frame frame             = small_frame(2, 2, TargetFormat::D24);
        frame.targets[0].format = format;
        frame.passes[0].clear   = {.color = Argb{0x64101010}, .depth = 0.5f};
        Pass pass               = frame.passes[0];
        pass.clear              = {};
        pass.state              = state;
        pass.draws.push_back(rectangle({0, 0, 2, 2}, 0xc8202020, 0.25f));
        frame.passes.push_back(pass);
        // Blue tells whether the depth was written.
        pass.state = {.color_mask = {false, false, true, false}, .depth = {.func = CompareFunc::Less}};
        pass.draws = {rectangle({0, 0, 2, 2}, 0xffffffff, 0.375f)};
        frame.passes.push_back(pass);
        return color_of(frame);
    };
    const Value all = bytes(32, 32, 32, 200), none = bytes(16, 16, 255, 100);
    const DepthState write{.func = CompareFunc::Less, .write = true};
    check_near(drawn({.depth = write}), all);
    check_near(drawn({.depth = {.func = CompareFunc::Greater, .write = true}}), none);
    const auto alpha_test = [&](CompareFunc func, AlphaFail fail, TargetFormat format = TargetFormat::A8R8G8B8) {
        return drawn({.depth = write, .alpha_test = {.func = func, .reference = 200, .fail = fail}}, format);
    };
    check_near(alpha_test(CompareFunc::Equal, AlphaFail::Keep), all);
    check_near(alpha_test(CompareFunc::Less, AlphaFail::Keep), none);
    check_near(alpha_test(CompareFunc::Less, AlphaFail::FbOnly), bytes(32, 32, 255, 200));
    check_near(alpha_test(CompareFunc::Less, AlphaFail::ZbOnly), bytes(16, 16, 16, 100));
    check_near(alpha_test(CompareFunc::Less, AlphaFail::RgbOnly), bytes(32, 32, 255, 100));
    check_near(alpha_test(CompareFunc::Less, AlphaFail::RgbOnly, TargetFormat::R6G6B6A6), bytes(32, 32, 255, 200));
    check_near(drawn({.depth = write, .dest_alpha_test = DestAlphaTest::One}), none);
    check_near(drawn({.depth = write, .dest_alpha_test = DestAlphaTest::Zero}), all);
    const Value none_opaque = bytes(16, 16, 255, 255);
    check_near(drawn({.depth = write, .dest_alpha_test = DestAlphaTest::One}, TargetFormat::X8R8G8B8), none_opaque);
    check_near(drawn({.depth = write}, TargetFormat::Psmct24), bytes(32, 32, 32, 128));
}

TEST_CASE("the truth copies channels, and halves without rounding", "[truth]") {
    Frame frame = small_frame(2, 2);
    frame.targets.push_back({.name = "source", .width = 4, .height = 4});
    frame.passes[0].clear.color = Argb{0x0a0b0c0d};
    Pass from;
    from.color       = {1};
    from.clear.color = Argb{0x64503c28};
    frame.passes.push_back(from);
    from.clear = {};
    from.draws = {rectangle({0, 0, 1, 4}, 0), rectangle({2, 0, 3, 4}, 0)};  // every other column
    frame.passes.push_back(from);
    Pass to;
    to.color = {0};
    CopyRectangle copy{.source = {1}, .from = {0, 0, 4, 4}, .halve = true};
    to.draws = {copy};
    frame.passes.push_back(to);
    // At the edge finer samples read beyond it, so in pixels.
    for (const Value& value : draw_truth(frame, {.samples_per_axis = 1}).pixels)
        check_near(value, bytes(40, 30, 20, 50));
    copy.halve         = false;
    copy.from          = {1, 0, 2, 1};
    CopyRectangle next = copy;
    const auto copied  = [&](CopyChannels channels) {
        frame.passes.back().draws.clear();
        for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
            next          = copy;
            next.channels = channels;
            next.x = x, next.y = y;
            frame.passes.back().draws.push_back(next);
        }
        return color_of(frame);
    };
    check_near(copied(CopyChannels::All), bytes(0x50, 0x3c, 0x28, 0x64));
    check_near(copied(CopyChannels::AlphaToColor), bytes(0x64, 0x64, 0x64, 0x0a));
    check_near(copied(CopyChannels::GreenToAlpha), bytes(0x0b, 0x0c, 0x0d, 0x3c));
}

TEST_CASE("the truth weighs texels and levels exactly", "[truth]") {
    // Level 0 is 0 and 240 in columns, level 1 is 100, level 2 is 200.
    Frame frame = small_frame(1, 1);
    std::vector<std::uint8_t> texels;
    for (int i = 0; i < 16; ++i) texels.push_back(i % 2 == 0 ? 0 : 240);
    texels.insert(texels.end(), 4, 100);
    texels.push_back(200);
    const TextureId texture = add_texture(frame, TextureFormat::L8, 4, 4, texels, 3);
    DrawRectangle draw      = rectangle({0, 0, 1, 1}, 0);
    draw.textures[0]        = bound(texture);
    TextureStage stage      = kTextureOnly;
    const auto read         = [&](double u, double width) {  // texels
        draw.uv[0]                      = {.u0 = static_cast<float>((u - width / 2) / 4),
                                                   .v0 = 0.5f - static_cast<float>(width / 8),
                                                   .u1 = static_cast<float>((u + width / 2) / 4),
                                                   .v1 = 0.5f + static_cast<float>(width / 8)};
        frame.passes[0].draws           = {draw};
        frame.passes[0].state.stages[0] = stage;
        return 255.0 * draw_truth(frame, {.samples_per_axis = 1}).pixels[0][0];
    };
    CHECK(read(1.25, 1) == Approx(240));
    CHECK(read(2.25, 1) == Approx(0).margin(1e-9));
    stage.filter = TextureFilter::Linear;
    CHECK(read(1.25, 1) == Approx(0.75 * 240));
    CHECK(read(2.625, 1) == Approx(0.125 * 240));
    // Between columns 3 and 0, or 3 and 3.
    CHECK(read(3.75, 1) == Approx(0.75 * 240));
    stage.address_u = TextureAddress::Clamp;
    CHECK(read(3.75, 1) == Approx(240));
    CHECK(read(-7, 1) == Approx(0).margin(1e-9));
    stage.address_u = TextureAddress::Mirror;
    CHECK(read(-1.25, 1) == Approx(240 * 0.75));
    CHECK(read(-0.25, 1) == Approx(0).margin(1e-9));
    stage.mip_filter = MipFilter::Linear;
    CHECK(read(2, std::exp2(1.25)) == Approx(125).epsilon(1e-5));
    CHECK(read(2, 0.5) == Approx(120));
    CHECK(read(2, 100) == Approx(200));
    stage.mip_filter = MipFilter::Point;
    CHECK(read(2, std::exp2(0.49)) == Approx(120));
    CHECK(read(2, std::exp2(0.51)) == Approx(100));
    CHECK(read(2, std::exp2(1.51)) == Approx(200));
    // With more samples the level stays that of the pixel.
    draw.uv[0]            = {.u0 = 0, .v0 = 0, .u1 = 1, .v1 = 1};
    frame.passes[0].draws = {draw};
    CHECK(255.0 * draw_truth(frame, {.samples_per_axis = 4}).pixels[0][0] == Approx(200));
}
