// SPDX-License-Identifier: MIT
// How each colour format keeps and gives back what is drawn, cleared, copied and dithered. The answers are worked out by
// hand from pipeline/frame/frame.h and blend_state.h.
#include "tests/support/small_frame.h"

using namespace pipeline;
using namespace test_support;

namespace {

const struct FormatRow {
    TargetFormat format;
    std::uint32_t expected, zero;  // of 0x9f8f47ab, and of 0
} kFormats[] = {
    {TargetFormat::A8R8G8B8, 0x9f8f47ab, 0x00000000}, {TargetFormat::X8R8G8B8, 0xff8f47ab, 0xff000000},
    {TargetFormat::R5G6B5, 0xff8c45ad, 0xff000000},    // 17: 10001 100; 17: 010001 01; 21: 10101 101
    {TargetFormat::A1R5G5B5, 0xff8c42ad, 0x00000000},  // green 8: 01000 010
    {TargetFormat::R6G6B6A6, 0x9e8e45aa, 0x00000000},  // 39: 100111 10; 35: 100011 10; 17: 010001 01; 42: 101010 10
    {TargetFormat::Psmct32, 0x9f8f47ab, 0x00000000},  {TargetFormat::Psmct24, 0x808f47ab, 0x80000000},
    {TargetFormat::Psmct16, 0x808840a8, 0x00000000},
};

}  // namespace

TEST_CASE("each colour format keeps its bits and gives back bytes", "[execute]") {
    std::size_t count = 0;
    for (const auto& [format, expected, zero] : kFormats) {
        INFO(enum_name(format));
        CHECK(format == static_cast<TargetFormat>(count++));
        Frame frame             = small_frame(17, 2);
        frame.targets[0].format = format;
        CHECK(color_on_both(frame) == zero);
        frame.passes[0].clear.color = Argb{0x9f8f47ab};
        CHECK(color_on_both(frame) == expected);
        frame.passes[0].clear = {};
        frame.passes[0].draws = {rectangle({0, 0, 17, 2}, 0x9f8f47ab)};
        CHECK(color_on_both(frame) == expected);
        frame.passes[0].state.blend = {BlendFactor::One, BlendFactor::One};  // what is there is no more than zero
        CHECK(color_on_both(frame) == expected);
        frame.passes[0].state.color_mask = {.red = false, .alpha = false};
        CHECK(color_on_both(frame) == ((expected & 0x0000ffff) | (zero & 0xffff0000)));
    }
    CHECK(static_cast<TargetFormat>(count) == TargetFormat::D16);
}

TEST_CASE("each colour format read as a texture gives what it keeps", "[execute]") {
    for (const auto& [format, expected, zero] : kFormats) {
        INFO(enum_name(format));
        Frame frame = small_frame(4, 4);
        frame.targets.push_back({.name = "read", .format = format, .width = 4, .height = 4});
        frame.passes[0].color = {1};
        frame.passes[0].draws = {rectangle({0, 0, 4, 4}, 0x9f8f47ab)};
        Pass pass             = frame.passes[0];
        pass.color            = {0};
        DrawRectangle draw    = rectangle({0, 0, 4, 4}, 0);
        draw.textures[0]      = {.texture = {}, .target = {1}};
        pass.state.stages[0]  = kTextureOnly;
        pass.draws            = {draw};
        frame.passes.push_back(pass);
        CHECK(color_on_both(frame) == expected);

        frame.passes[1].state = {};
        frame.passes[1].draws = {CopyRectangle{.source = {1}, .from = {0, 0, 4, 4}}};
        CHECK(color_on_both(frame) == expected);
    }
}

TEST_CASE("each dither, at each place of its pattern", "[execute]") {
    Frame flipper                      = small_frame(18, 4);
    flipper.targets[0].format          = TargetFormat::R6G6B6A6;
    flipper.passes[0].state.dither     = {.mode = DitherMode::Flipper2x2, .matrix = {}};
    flipper.passes[0].draws            = {rectangle({0, 0, 18, 4}, 0x82828282)};
    const std::vector<std::uint32_t> f = pixels_on_both(flipper);
    // 0x82 - 2 = 0x80; with 0, 2, 3, 1 all of these are 32 in 6 bits. Alpha is not dithered.
    for (const std::uint32_t pixel : f) CHECK(pixel == 0x82828282);
    flipper.passes[0].draws                   = {rectangle({0, 0, 18, 4}, 0x85858585)};  // 0x83: 131, 133; 134, 132
    const std::vector<std::uint32_t> dithered = pixels_on_both(flipper);
    for (std::size_t i = 0; i < dithered.size(); ++i) {
        const bool is_first = (i % 18 & 1) == 0 && (i / 18 & 1) == 0;
        CHECK(dithered[i] == (is_first ? 0x86828282 : 0x86868686));
    }

    Frame gs                                = small_frame(18, 5);
    gs.arithmetic.blend                     = BlendRule::GsShift7;
    gs.targets[0].format                    = TargetFormat::Psmct16;
    DitherState& dither                     = gs.passes[0].state.dither;
    dither.mode                             = DitherMode::GsDimx;
    dither.matrix                           = {-4, 2, -3, 3, 0, -2, 1, -1, -3, 3, -4, 2, 1, -1, 0, -2};
    gs.passes[0].draws                      = {rectangle({0, 0, 18, 5}, 0xff8606ff)};
    const std::vector<std::uint32_t> pixels = pixels_on_both(gs);
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 18; ++x) {
            // Red 134 and green 6 reach the next value of five bits with 2 or more; blue 255 stays in the last.
            const bool up = dither.matrix[static_cast<std::size_t>(4 * (y & 3) + (x & 3))] >= 2;
            INFO(x << ' ' << y);
            CHECK(pixels[static_cast<std::size_t>(18 * y + x)] == (up ? 0x808808f8 : 0x808000f8));
        }
}

TEST_CASE("dither comes before clamping or wrapping", "[execute]") {
    Frame frame                  = small_frame(4, 1);
    frame.arithmetic.blend       = BlendRule::GsShift7;
    frame.targets[0].format      = TargetFormat::Psmct16;
    frame.passes[0].state.dither = {.mode = DitherMode::GsDimx, .matrix = {3, -4, 0, 0}};
    frame.passes[0].draws        = {rectangle({0, 0, 4, 1}, 0x10fe0102)};
    // Red 0x101, 0xfa, 0xfe; green 4, -3, 1; blue 5, -2, 2.
    CHECK(pixels_on_both(frame) == std::vector<std::uint32_t>{0xf80000, 0xf80000, 0xf80000, 0xf80000});
    frame.passes[0].state.gs_blend.colclamp = false;
    CHECK(pixels_on_both(frame) == std::vector<std::uint32_t>{0, 0xf8f8f8, 0xf80000, 0xf80000});
}

TEST_CASE("counts and bytes follow what a format keeps", "[execute]") {
    const auto counts = [](TargetFormat format, void (*change)(PipelineState&)) {
        Frame frame             = small_frame(4, 2);
        frame.targets[0].format = format;
        frame.passes[0].draws   = {rectangle({0, 0, 4, 2}, 0x00ffffff)};
        change(frame.passes[0].state);
        const PassCounts all = draw_on_both(frame).execution.counts[0];
        return std::pair(all.color_written, all.bytes);
    };
    using Pair            = std::pair<std::uint64_t, std::uint64_t>;
    const auto nothing    = [](PipelineState&) {};
    const auto alpha_only = [](PipelineState& state) { state.color_mask = {false, false, false, true}; };
    const auto rgb_only   = [](PipelineState& state) {
        state.alpha_test = {.func = CompareFunc::Never, .reference = 0, .fail = AlphaFail::RgbOnly};
    };
    const auto tested = [](PipelineState& state) { state.dest_alpha_test = DestAlphaTest::One; };
    CHECK(counts(TargetFormat::A8R8G8B8, nothing) == Pair{8, 32});
    CHECK(counts(TargetFormat::R5G6B5, nothing) == Pair{8, 16});
    CHECK(counts(TargetFormat::R6G6B6A6, nothing) == Pair{8, 24});
    CHECK(counts(TargetFormat::A8R8G8B8, alpha_only) == Pair{8, 64});  // read, and written
    CHECK(counts(TargetFormat::X8R8G8B8, alpha_only) == Pair{0, 0});
    CHECK(counts(TargetFormat::A8R8G8B8, rgb_only) == Pair{8, 64});
    CHECK(counts(TargetFormat::A8R8G8B8, tested) == Pair{0, 32});  // read alone
}

TEST_CASE("a copy moves pixels, or halves them by the source's format", "[execute]") {
    const auto copied = [](TargetFormat format, bool halve) {
        Frame frame = small_frame(5, 4);
        frame.targets.push_back({.name = "from", .format = format, .width = 6, .height = 4});
        frame.passes[0].color = {1};
        frame.passes[0].draws = {rectangle({2, 2, 3, 3}, 0xff400004), rectangle({3, 2, 4, 3}, 0xfe400004),
                                 rectangle({2, 3, 3, 4}, 0xfc430008), rectangle({3, 3, 4, 4}, 0xff43000c)};
        Pass& pass            = frame.passes.emplace_back();
        pass.color            = {0};
        pass.clear.color      = Argb{0x01020304};
        pass.draws            = {CopyRectangle{.source = {1}, .from = {2, 2, 4, 4}, .x = 3, .y = 1, .halve = halve}};
        const Drawn drawn     = draw_on_both(frame);
        CHECK(drawn.execution.counts[1].copies == 1);
        CHECK(drawn.execution.counts[1].texels == 4);
        CHECK(drawn.execution.counts[1].color_written == (halve ? 1 : 4));
        return drawn.execution.output.pixels;
    };
    const std::vector<std::uint32_t> whole = copied(TargetFormat::A8R8G8B8, false);
    CHECK(whole[8] == 0xff400004);
    CHECK(whole[9] == 0xfe400004);
    CHECK(whole[13] == 0xfc430008);
    CHECK(whole[14] == 0xff43000c);
    CHECK(std::count(whole.begin(), whole.end(), 0x01020304u) == 16);
    CHECK(copied(TargetFormat::X8R8G8B8, false)[9] == 0xff400004);

    // Sums of alpha 0x3f8, red 0x106, blue 0x1c: floored quarters.
    const std::vector<std::uint32_t> halved = copied(TargetFormat::A8R8G8B8, true);
    CHECK(halved[8] == 0xfe410007);
    CHECK(std::count(halved.begin(), halved.end(), 0x01020304u) == 19);
    // In six bits alpha 63 each: 252 + 3; red 16 each: 64 + 1; blue 1 + 1 + 2 + 3.
    CHECK(copied(TargetFormat::R6G6B6A6, true)[8] == 0xff410007);
}
