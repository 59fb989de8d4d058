// SPDX-License-Identifier: MIT
// The Graphics Synthesizer's blend and tests, from the frame to the bytes. The answers are worked out by hand from
// pipeline/frame/blend_state.h and test_state.h.
#include "tests/support/small_frame.h"

using namespace pipeline;
using namespace test_support;

namespace {

// One rectangle of `source` over a target cleared to `dest`.
Frame gs_frame(const GsBlend& blend, std::uint32_t source, std::uint32_t dest) {
    Frame frame                    = small_frame(17, 2);
    frame.arithmetic.blend         = BlendRule::GsShift7;
    frame.targets[0].format        = TargetFormat::Psmct32;
    frame.passes[0].clear.color    = Argb{dest};
    frame.passes[0].state.gs_blend = blend;
    frame.passes[0].draws          = {rectangle({0, 0, 17, 2}, source)};
    return frame;
}

std::uint32_t blended(const GsBlend& blend, std::uint32_t source, std::uint32_t dest) {
    return color_on_both(gs_frame(blend, source, dest));
}

constexpr std::uint32_t kSource = 0x60c85010, kDest = 0xa03296f0;

}  // namespace

TEST_CASE("each operand A, B, D and C of the Graphics Synthesizer's blend", "[execute]") {
    struct ColorRow {
        GsColor operand;
        std::uint32_t as_a, as_b, as_d;
    };
    // (A - 0) * 0x60 >> 7; (0 - B) * 0x60 >> 7, floored, and 200; D alone.
    const ColorRow color_rows[] = {
        {GsColor::Cs, 0x60963c0c, 0x60328cbc, 0x60c85010},
        {GsColor::Cd, 0x602570b4, 0x60a25714, 0x603296f0},
        {GsColor::Zero, 0x60000000, 0x60c8c8c8, 0x60000000},
    };
    check_table(color_rows, &ColorRow::operand, &ColorRow::as_a);
    check_table(color_rows, &ColorRow::operand, &ColorRow::as_b);
    check_table(color_rows, &ColorRow::operand, &ColorRow::as_d);
    for (const ColorRow& row : color_rows) {
        INFO(enum_name(row.operand));
        CHECK(blended({.a = row.operand, .b = GsColor::Zero, .d = GsColor::Zero}, kSource, kDest) == row.as_a);
        CHECK(blended({.a = GsColor::Zero, .b = GsColor::Zero, .d = row.operand}, kSource, kDest) == row.as_d);
    }
    // B of the destination with D the source: 200 - (50 * 96 >> 7), where -37.5 floors to -38.
    CHECK(blended({.a = GsColor::Zero, .b = GsColor::Cd, .d = GsColor::Cs}, kSource, 0xa0329600) == 0x60a20010);

    struct AlphaRow {
        GsAlpha operand;
        std::uint32_t expected;
    };
    const AlphaRow alpha_rows[] = {
        {GsAlpha::As, 0x60963c0c},   // 96: 200 * 96 / 128 = 150
        {GsAlpha::Ad, 0x60fa6414},   // 160: 250
        {GsAlpha::Fix, 0x60642808},  // 64: 100, 40, 8
    };
    check_table(alpha_rows, &AlphaRow::operand, &AlphaRow::expected);
    for (const AlphaRow& row : alpha_rows) {
        INFO(enum_name(row.operand));
        const GsBlend blend{.b = GsColor::Zero, .c = row.operand, .d = GsColor::Zero, .fix = 64};
        CHECK(blended(blend, kSource, kDest) == row.expected);
    }
}

TEST_CASE("COLCLAMP, PABE and FBA", "[execute]") {
    const GsBlend add{.a = GsColor::Cs, .b = GsColor::Zero, .c = GsAlpha::Fix, .d = GsColor::Cd, .fix = 0x80};
    GsBlend wrap = add,
            subtract{.a = GsColor::Zero, .b = GsColor::Cs, .c = GsAlpha::Fix, .d = GsColor::Cd, .fix = 0x80};
    wrap.colclamp = false;
    CHECK(blended(add, 0x11c80010, 0x2264fff8) == 0x11ffffff);  // 300, 255, 264
    CHECK(blended(wrap, 0x11c80010, 0x2264fff8) == 0x112cff08);
    CHECK(blended(subtract, 0x11c80010, 0x2264fff8) == 0x1100ffe8);
    subtract.colclamp = false;
    CHECK(blended(subtract, 0x11c80010, 0x2264fff8) == 0x119cffe8);  // -100

    GsBlend per_pixel = add;
    per_pixel.pabe    = true;
    CHECK(blended(per_pixel, 0x7fc80010, 0x2264fff8) == 0x7fc80010);
    CHECK(blended(per_pixel, 0x80c80010, 0x2264fff8) == 0x80ffffff);

    GsBlend alpha = add;
    alpha.fba     = true;
    CHECK(blended(alpha, 0x11c80010, 0x2264fff8) == 0x91ffffff);
    Frame frame                            = gs_frame(alpha, 0x11c80010, 0x2264fff8);
    frame.passes[0].state.color_mask.alpha = false;
    CHECK(color_on_both(frame) == 0x22ffffff);
}

TEST_CASE("destination alpha of 24- and 16-bit frames", "[execute]") {
    const GsBlend multiply{.a = GsColor::Cs, .b = GsColor::Zero, .c = GsAlpha::Ad, .d = GsColor::Zero};
    const struct Row {
        TargetFormat format;
        std::uint32_t dest, expected;
    } rows[] = {
        {TargetFormat::Psmct32, 0x40000000, 0x60642808},  // 200 / 2, 80 / 2, 16 / 2
        {TargetFormat::Psmct24, 0x40000000, 0x80c85010},  // one, and no alpha is kept
        {TargetFormat::Psmct16, 0x40000000, 0x00000000},  // its bit is 0
        {TargetFormat::Psmct16, 0xc0000000, 0x00c85010},  // one; bytes of 5 bits with zeros below
    };
    for (const Row& row : rows) {
        INFO(enum_name(row.format) << ' ' << row.dest);
        Frame frame             = gs_frame(multiply, kSource, row.dest);
        frame.targets[0].format = row.format;
        CHECK(color_on_both(frame) == row.expected);
    }
}

TEST_CASE("what a fragment that fails the alpha test still writes", "[execute]") {
    const struct Row {
        AlphaFail fail;
        std::uint32_t color, narrow_color;  // on PSMCT32 and PSMCT16
        bool depth_written;
    } rows[] = {
        {AlphaFail::Keep, 0x55080808, 0x00080808, false},
        {AlphaFail::FbOnly, 0xaaf0f0f0, 0x80f0f0f0, false},
        {AlphaFail::ZbOnly, 0x55080808, 0x00080808, true},
        {AlphaFail::RgbOnly, 0x55f0f0f0, 0x80f0f0f0, false},
    };
    std::size_t count = 0;
    for (const Row& row : rows) {
        CHECK(row.fail == static_cast<AlphaFail>(count++));
        for (const TargetFormat format : {TargetFormat::Psmct32, TargetFormat::Psmct16}) {
            INFO(enum_name(row.fail) << ' ' << enum_name(format));
            Frame frame             = small_frame(17, 2, TargetFormat::D24);
            frame.targets[0].format = format;
            Pass& pass              = frame.passes[0];
            pass.clear              = {.color = Argb{0x55080808}, .depth = 1.0f};
            pass.state.depth        = {.func = CompareFunc::Less, .write = true};
            pass.state.alpha_test   = {.func = CompareFunc::Never, .reference = 0, .fail = row.fail};
            pass.draws              = {rectangle({0, 0, 17, 2}, 0xaaf0f0f0, 0.5f)};
            const Drawn drawn       = draw_on_both(frame);
            const PassCounts counts = drawn.execution.counts[0];
            const bool is_narrow    = format == TargetFormat::Psmct16;
            CHECK(drawn.execution.output.pixels[0] == (is_narrow ? row.narrow_color : row.color));
            CHECK(counts.depth_written == (row.depth_written ? 34 : 0));
            CHECK(counts.color_written == (row.fail == AlphaFail::FbOnly || row.fail == AlphaFail::RgbOnly ? 34 : 0));

            Pass seen        = pass;  // is the depth there?
            seen.clear       = {};
            seen.state       = {};
            seen.state.depth = {.func = CompareFunc::Equal, .write = false};
            frame.passes.push_back(seen);
            CHECK((draw_on_both(frame).execution.counts[1].depth_passed == 34) == row.depth_written);
        }
    }
    CHECK(count == EnumNames<AlphaFail>::names.size());
}

TEST_CASE("fragments that pass the alpha test are not limited by what those that fail may write", "[execute]") {
    for (const AlphaFail fail : {AlphaFail::FbOnly, AlphaFail::ZbOnly, AlphaFail::RgbOnly}) {
        INFO(enum_name(fail));
        Frame frame           = small_frame(2, 1, TargetFormat::D24);
        Pass& pass            = frame.passes[0];
        pass.clear            = {.color = Argb{0x55080808}, .depth = 1.0f};
        pass.state.depth      = {.func = CompareFunc::Less, .write = true};
        pass.state.alpha_test = {.func = CompareFunc::GreaterEqual, .reference = 128, .fail = fail};
        // Fails if pixel 0; passes if pixel 1.
        pass.draws            = {rectangle({0, 0, 1, 1}, 0x7ff0f0f0, 0.5f), rectangle({1, 0, 2, 1}, 0x80f0f0f0, 0.5f)};
        const Drawn drawn     = draw_on_both(frame);
        CHECK(drawn.execution.output.pixels[1] == 0x80f0f0f0);
        CHECK(drawn.execution.counts[0].depth_written == (fail == AlphaFail::ZbOnly ? 2 : 1));
        CHECK(drawn.execution.counts[0].color_written == (fail == AlphaFail::ZbOnly ? 1 : 2));
    }
}

TEST_CASE("the destination alpha test, on each format", "[execute]") {
    struct Row {
        DestAlphaTest test;
        std::string drawn;  // where alpha is 0x7f, and where it is 0x80
    };
    const Row rows[] = {{DestAlphaTest::Off, "##"}, {DestAlphaTest::Zero, "#."}, {DestAlphaTest::One, ".#"}};
    check_table(rows, &Row::test, &Row::drawn);
    for (const Row& row : rows)
        for (const TargetFormat format : {TargetFormat::A8R8G8B8, TargetFormat::A1R5G5B5, TargetFormat::Psmct32,
                                          TargetFormat::Psmct16, TargetFormat::Psmct24, TargetFormat::X8R8G8B8}) {
            INFO(enum_name(row.test) << ' ' << enum_name(format));
            Frame frame                  = small_frame(2, 1);
            frame.targets[0].format      = format;
            frame.passes[0].draws        = {rectangle({0, 0, 1, 1}, 0x7f000000), rectangle({1, 0, 2, 1}, 0x80000000)};
            Pass tested                  = frame.passes[0];
            tested.state.dest_alpha_test = row.test;
            tested.draws                 = {rectangle({0, 0, 2, 1}, 0x00ffffff)};
            frame.passes.push_back(tested);
            std::string drawn;
            for (const std::uint32_t pixel : pixels_on_both(frame)) drawn += (pixel & 0xff) != 0 ? '#' : '.';
            const bool has_alpha = format != TargetFormat::Psmct24 && format != TargetFormat::X8R8G8B8;
            CHECK(drawn == (has_alpha || row.test == DestAlphaTest::Off ? row.drawn : ".."));
        }
}
