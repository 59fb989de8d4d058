// SPDX-License-Identifier: MIT
// Dumps of frames, replayed by a model of the chip that shares no code with what draws frames: the same pixels.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>

#include "pipeline/execute/execute.h"
#include "tests/support/gs_frames.h"

using namespace pipeline;
using namespace test_support;

namespace {

// Both kinds of draw over what a texture has left, with all that states can act on.
Frame busy_frame(TargetFormat color, TargetFormat depth) {
    Frame frame = gs_frame(70, 40, color, depth);
    Random random(7);
    const TextureId texture = add_random_texture(frame, TextureFormat::A8R8G8B8, 128, 64, random);
    const TextureBinding bound{.texture = texture, .target = {}};
    DrawRectangle over{.x1 = 70.0f, .y1 = 40.0f, .depth = 0.5f};
    over.textures[0]      = bound;
    Pass first            = frame.passes[0];
    first.state.stages[0] = {.color_op = TextureOp::SelectArg1, .alpha_op = TextureOp::SelectArg1};
    first.state.depth     = {.func = CompareFunc::Always, .write = true};
    first.draws           = {over};
    Pass& pass            = frame.passes[0];
    const auto corner     = [&](float x, float y, float z, float rhw, std::uint32_t fog) {
        return WindowVertex{.x        = x,
                                .y        = y,
                                .z        = z,
                                .rhw      = rhw,
                                .diffuse  = {random.bits()},
                                .specular = {fog << 24},
                                .uv0      = {x * 0.03f, y * 0.05f, 1.0f}};
    };
    pass.state.stages[0] = {.color_op   = TextureOp::Modulate,
                            .color_arg2 = {.source = ArgSource::Diffuse},
                            .alpha_op   = TextureOp::Modulate,
                            .alpha_arg2 = {.source = ArgSource::Diffuse}};
    add_triangle(frame, pass,
                 {corner(3.3f, 2.1f, 0.2f, 1.0f, 10), corner(66.0f, 9.0f, 0.9f, 0.5f, 255),
                  corner(20.5f, 38.9f, 0.4f, 2.0f, 100)},
                 bound);
    DrawRectangle draw{.x0 = 20.0f, .y0 = 10.0f, .x1 = 69.0f, .y1 = 39.0f, .depth = 0.55f, .color = {0x90c06030}};
    draw.uv[0]       = {-0.5f, 0.25f, 1.7f, 1.0f};
    draw.textures[0] = bound;
    pass.draws.push_back(draw);
    frame.passes.insert(frame.passes.begin(), first);
    return frame;
}

void check_replay(const Frame& frame) {
    CHECK(difference_of(frame, replayed(frame)) == "");
}

// With each enumerator that `allowed` has, on targets of 32 and of 16 bits.
template <class Enum, class Set>
void check_each(const std::vector<Enum>& allowed, Set set) {
    for (const Enum value : allowed) {
        for (const auto& [color, depth] :
             {std::pair{TargetFormat::Psmct32, TargetFormat::D24}, {TargetFormat::Psmct16, TargetFormat::D16}}) {
            INFO(enum_name(value) << " on " << enum_name(color));
            Frame frame = busy_frame(color, depth);
            set(frame.passes[1].state, value);
            check_replay(frame);
        }
    }
}

}  // namespace

TEST_CASE("Random frames come out of their dumps as they are drawn") {
    for (std::uint32_t seed = 1; seed <= 150; ++seed) {
        INFO("seed " << seed);
        CHECK(difference_in_targets(random_gs_frame(seed)) == "");
    }
}

TEST_CASE("Each state of the chip, in a dump") {
    const ChipStates& chip = find_profile("ps2")->states;
    for (const GsColor a : all_of<GsColor>())
        check_each(all_of<GsColor>(), [&](PipelineState& state, GsColor b) {
            state.gs_blend = {.a = a, .b = b, .c = GsAlpha::As, .d = GsColor::Cd};
        });
    check_each(all_of<GsColor>(), [](PipelineState& state, GsColor d) {
        state.gs_blend = {.a = GsColor::Cs, .b = GsColor::Cd, .c = GsAlpha::Ad, .d = d, .colclamp = false};
    });
    check_each(all_of<GsAlpha>(), [](PipelineState& state, GsAlpha c) {
        state.gs_blend = {
            .a = GsColor::Cd, .b = GsColor::Zero, .c = c, .d = GsColor::Cs, .fix = 200, .pabe = true, .fba = true};
    });
    check_each(chip.depth_funcs,
               [](PipelineState& state, CompareFunc func) { state.depth = {.func = func, .write = true}; });
    for (const AlphaFail fail : all_of<AlphaFail>())
        check_each(all_of<CompareFunc>(), [&](PipelineState& state, CompareFunc func) {
            state.depth      = {.func = CompareFunc::GreaterEqual, .write = true};
            state.alpha_test = {.func = func, .reference = 0x50, .fail = fail};
        });
    check_each(all_of<DestAlphaTest>(), [](PipelineState& state, DestAlphaTest test) { state.dest_alpha_test = test; });
    check_each(all_of<TextureFilter>(),
               [](PipelineState& state, TextureFilter filter) { state.stages[0].filter = filter; });
    check_each(chip.addresses,
               [](PipelineState& state, TextureAddress address) { state.stages[0].address_u = address; });
    check_each(chip.addresses,
               [](PipelineState& state, TextureAddress address) { state.stages[0].address_v = address; });
    check_each(std::vector{TextureOp::SelectArg1, TextureOp::Modulate, TextureOp::ModulateColorAddAlpha},
               [](PipelineState& state, TextureOp op) {
                   const TextureArg texel{.source = ArgSource::Texture}, vertex{.source = ArgSource::Diffuse};
                   const bool adds            = op == TextureOp::ModulateColorAddAlpha;
                   state.stages[0].color_op   = op;
                   state.stages[0].alpha_op   = adds ? TextureOp::Add : TextureOp::SelectArg2;
                   state.stages[0].color_arg1 = adds ? vertex : texel;
                   state.stages[0].color_arg2 = adds ? texel : vertex;
               });
    check_each(std::vector{FogMode::None, FogMode::Linear, FogMode::Exp, FogMode::Exp2},
               [](PipelineState& state, FogMode mode) { state.fog = {.mode = mode, .color = {0x00306090}}; });
}

TEST_CASE("Dither, masks and limits, in a dump") {
    Frame dithered                  = busy_frame(TargetFormat::Psmct16, TargetFormat::D16);
    dithered.passes[1].state.dither = {.mode   = DitherMode::GsDimx,
                                       .matrix = {-4, 2, -3, 3, 0, -2, 1, -1, -3, 3, -4, 2, 1, -1, 0, -2}};
    check_replay(dithered);
    for (int channels = 0; channels < 16; ++channels) {
        INFO("channels " << channels);
        for (const auto& [color, depth] : {std::pair{TargetFormat::Psmct32, TargetFormat::D32},
                                           {TargetFormat::Psmct24, TargetFormat::D24},
                                           {TargetFormat::Psmct16, TargetFormat::D16}}) {
            Frame frame                      = busy_frame(color, depth);
            frame.passes[1].state.color_mask = {(channels & 1) != 0, (channels & 2) != 0, (channels & 4) != 0,
                                                (channels & 8) != 0};
            frame.passes[1].state.viewport   = {5, 0, 60, 40};
            frame.passes[1].state.scissor    = {0, 7, 50, 33};
            check_replay(frame);
        }
    }
}

TEST_CASE("Each format as a texture, in a dump") {
    for (const TargetFormat format : find_profile("ps2")->formats.draw) {
        for (const TextureFormat from : all_of<TextureFormat>()) {
            INFO(enum_name(format) << ' ' << enum_name(from));
            Frame frame = gs_frame(90, 60, format);
            frame.targets.push_back({.name = "copy", .format = TargetFormat::Psmct32, .width = 90, .height = 60});
            frame.output = {1};
            Random random(3);
            const TextureId texture = add_random_texture(frame, from, 53, 47, random);
            Pass& pass              = frame.passes[0];
            pass.state.stages[0]    = {.color_op  = TextureOp::SelectArg1,
                                       .alpha_op  = TextureOp::SelectArg1,
                                       .filter    = TextureFilter::Linear,
                                       .address_u = TextureAddress::Clamp,
                                       .address_v = TextureAddress::Clamp};
            DrawRectangle draw{.x1 = 90.0f, .y1 = 60.0f};
            draw.textures[0] = {.texture = texture, .target = {}};
            pass.draws.push_back(draw);
            Pass copy                                          = pass;
            copy.color                                         = {1};
            std::get<DrawRectangle>(copy.draws[0]).textures[0] = {.texture = {}, .target = {0}};
            frame.passes.push_back(copy);
            check_replay(frame);
        }
    }
}

TEST_CASE("Copies of whole pixels and of channels, anywhere, in a dump") {
    for (const CopyChannels channels : all_of<CopyChannels>()) {
        for (const auto& [from, x, y] : {std::tuple{PixelRect{0, 0, 200, 100}, 0, 0},
                                         {PixelRect{3, 5, 150, 90}, 40, 7},
                                         {PixelRect{16, 8, 100, 72}, 0, 24},
                                         {PixelRect{199, 99, 200, 100}, 1, 2}}) {
            INFO(enum_name(channels) << " from " << from.x0 << ' ' << from.y0);
            Frame frame = gs_frame(200, 100);
            frame.targets.push_back({.name = "source", .format = TargetFormat::Psmct32, .width = 200, .height = 100});
            Random random(11);
            const TextureId texture = add_random_texture(frame, TextureFormat::A8R8G8B8, 128, 128, random);
            const auto fill         = [&](std::int32_t target, float v) {
                Pass pass;
                pass.color           = {target};
                pass.state.stages[0] = {.color_op = TextureOp::SelectArg1, .alpha_op = TextureOp::SelectArg1};
                DrawRectangle draw{.x1 = 200.0f, .y1 = 100.0f};
                draw.uv[0]       = {0.0f, v, 1.5625f, v + 0.78125f};
                draw.textures[0] = {.texture = texture, .target = {}};
                pass.draws.push_back(draw);
                return pass;
            };
            frame.passes[0].draws.push_back(
                CopyRectangle{.source = {1}, .from = from, .x = x, .y = y, .channels = channels});
            frame.passes.insert(frame.passes.begin(), {fill(0, 0.0f), fill(1, 0.5f)});
            check_replay(frame);
        }
    }
}

// S and T count powers of two, and are rounded once more.
TEST_CASE("Triangles with textures of any size read at most a sixteenth of a texel away") {
    Frame frame      = gs_frame(120, 90);
    Texture& texture = frame.textures.emplace_back();
    texture = {.name = "ramp", .format = TextureFormat::L8, .width = 100, .height = 60, .levels = 1, .texels = {}};
    for (int i = 0; i < 6000; ++i) texture.texels.push_back(static_cast<std::uint8_t>(2 * (i % 100)));
    Pass& pass           = frame.passes[0];
    pass.state.stages[0] = {.color_op  = TextureOp::SelectArg1,
                            .alpha_op  = TextureOp::SelectArg1,
                            .filter    = TextureFilter::Linear,
                            .address_u = TextureAddress::Clamp,
                            .address_v = TextureAddress::Clamp};
    add_triangle(frame, pass,
                 {WindowVertex{.x = 1.0f, .y = 2.0f, .rhw = 0.7f, .uv0 = {0.1f, 0.0f, 1.0f}},
                  {.x = 118.0f, .y = 30.0f, .rhw = 1.9f, .uv0 = {0.9f, 0.3f, 1.0f}},
                  {.x = 40.0f, .y = 88.0f, .uv0 = {0.3f, 1.0f, 1.0f}}},
                 {.texture = {0}, .target = {}});
    const std::vector<std::uint32_t> got  = replayed(frame);
    const std::vector<std::uint32_t> want = execute(frame).output.pixels;
    int most                              = 0;
    for (std::size_t i = 0; i < got.size(); ++i)
        most = std::max(most, std::abs(static_cast<int>(got[i] & 255) - static_cast<int>(want[i] & 255)));
    CHECK(most <= 1);  // a texel is 2 from the next
    CHECK(got != std::vector<std::uint32_t>(got.size(), got[0]));
}

// Every kind of register matters to some frame: with one of its bits turned, a picture differs.
TEST_CASE("A mistake in any register shows in the picture") {
    struct Mistake {
        GsReg reg;
        std::uint64_t bits;
    };
    const std::vector<Mistake> mistakes{{GsReg::Prim, 1 << 4},
                                        {GsReg::Prim, 1 << 6},
                                        {GsReg::Prim, 1 << 3},
                                        {GsReg::Rgbaq, 0x40},
                                        {GsReg::Rgbaq, 1ull << 30},
                                        {GsReg::Rgbaq, 1ull << 54},
                                        {GsReg::St, 1 << 20},
                                        {GsReg::St, 1ull << 52},
                                        {GsReg::Xyz2, 1 << 4},
                                        {GsReg::Xyz2, 1 << 20},
                                        {GsReg::Xyz2, 1ull << 55},
                                        {GsReg::Tex0, 1 << 1},
                                        {GsReg::Tex0, 1 << 14},
                                        {GsReg::Tex0, 1 << 20},
                                        {GsReg::Tex0, 1ull << 34},
                                        {GsReg::Tex0, 1ull << 35},
                                        {GsReg::Tex0, 1 << 26},
                                        {GsReg::Tex0, 1 << 30},
                                        {GsReg::Clamp, 2},
                                        {GsReg::Tex1, 1 << 5},
                                        {GsReg::XyOffset, 1 << 4},
                                        {GsReg::Scissor, 8},
                                        {GsReg::Scissor, 1ull << 48},
                                        {GsReg::Alpha, 1},
                                        {GsReg::Alpha, 1 << 2},
                                        {GsReg::Alpha, 1 << 4},
                                        {GsReg::Alpha, 1 << 6},
                                        {GsReg::ColClamp, 1},
                                        {GsReg::Test, 1},
                                        {GsReg::Test, 1 << 14},
                                        {GsReg::Test, 1 << 17},
                                        {GsReg::Pabe, 1},
                                        {GsReg::Fba, 1},
                                        {GsReg::Frame, 1},
                                        {GsReg::Frame, 1 << 16},
                                        {GsReg::Frame, 1 << 24},
                                        {GsReg::Frame, 1ull << 45},
                                        {GsReg::Zbuf, 1ull << 32},
                                        {GsReg::BitBltBuf, 1ull << 32},
                                        {GsReg::TrxReg, 1},
                                        {GsReg::TrxPos, 1ull << 32},
                                        {GsReg::DispFb1, 1}};
    Frame frame                           = busy_frame(TargetFormat::Psmct32, TargetFormat::D24);
    PipelineState& state                  = frame.passes[1].state;
    state.gs_blend                        = {.a = GsColor::Cs, .b = GsColor::Cd, .c = GsAlpha::As, .d = GsColor::Cs};
    state.depth                           = {.func = CompareFunc::GreaterEqual, .write = true};
    state.scissor                         = {2, 3, 66, 37};
    state.alpha_test                      = {.func = CompareFunc::Less, .reference = 0x90};
    state.stages[0].address_u             = TextureAddress::Clamp;
    const std::vector<std::uint32_t> want = replayed(frame);
    const GsStream stream                 = emit_gs(legal_gs_frame(frame));
    for (const Mistake& mistake : mistakes) {
        INFO("register " << find_gs_register(static_cast<std::uint32_t>(mistake.reg))->name << " bits "
                         << mistake.bits);
        GsStream wrong   = stream;
        const auto spoil = [&](std::vector<GsWrite>& writes) {
            for (GsWrite& write : writes)
                if (write.reg == mistake.reg) write.value ^= mistake.bits;
        };
        for (GsGroup& group : wrong.groups)
            for (GsStep& step : group.steps) spoil(step.writes);
        spoil(wrong.display);
        bool seen = false;
        try {
            seen = replayed(frame, wrong) != want;
        } catch (const std::runtime_error&) {
            seen = true;
        }
        CHECK(seen);
    }
}

TEST_CASE("A missing TEXFLUSH shows in the picture") {
    Frame frame = gs_frame(64, 32);
    frame.targets.push_back({.name = "copy", .format = TargetFormat::Psmct32, .width = 64, .height = 32});
    frame.output                = {1};
    frame.passes[0].clear.color = Argb{0xff123456};
    Pass& pass                  = frame.passes.emplace_back();
    pass.color                  = {1};
    pass.state.stages[0]        = {.color_op = TextureOp::SelectArg1, .alpha_op = TextureOp::SelectArg1};
    DrawRectangle draw{.x1 = 64.0f, .y1 = 32.0f};
    draw.textures[0] = {.texture = {}, .target = {0}};
    pass.draws.push_back(draw);
    GsStream stream = emit_gs(legal_gs_frame(frame));
    CHECK(difference_of(frame, replayed(frame, stream)) == "");
    std::erase_if(stream.groups.back().steps, [](const GsStep& step) { return step.what == "texture cache"; });
    CHECK(difference_of(frame, replayed(frame, stream)) != "");
}
