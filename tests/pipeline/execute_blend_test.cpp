// SPDX-License-Identifier: MIT
// How a fragment meets its pixel, from the frame's state to the bytes: blend factors, channel masks, alpha and depth
// test. Expected bytes are worked out by hand from pipeline/frame/blend_state.h and test_state.h.
#include "tests/support/small_frame.h"

using namespace pipeline;
using namespace test_support;

namespace {

std::uint32_t blended(const BlendState& blend, const ColorMask& mask, std::uint32_t source, std::uint32_t dest) {
    Frame frame           = small_frame(19, 2);
    Pass& pass            = frame.passes[0];
    pass.clear.color      = Argb{dest};
    pass.state.blend      = blend;
    pass.state.color_mask = mask;
    pass.draws            = {rectangle({0, 0, 19, 2}, source)};
    return color_on_both(frame);
}

// Which of the three fragments pass that are less than, equal to and greater than what they are compared with.
struct CompareRow {
    CompareFunc func;
    std::string passed;
};
const CompareRow kCompareRows[] = {
    {CompareFunc::Always, "<=>"},       {CompareFunc::LessEqual, "<= "}, {CompareFunc::Less, "<  "},
    {CompareFunc::GreaterEqual, " =>"}, {CompareFunc::Greater, "  >"},   {CompareFunc::Equal, " = "},
    {CompareFunc::NotEqual, "< >"},     {CompareFunc::Never, "   "},
};

// One of "<=>" for each pixel that was drawn to.
std::string passed(const std::vector<std::uint32_t>& pixels) {
    REQUIRE(pixels.size() == 3);
    std::string text = "<=>";
    for (std::size_t i = 0; i < 3; ++i)
        if (pixels[i] == 0) text[i] = ' ';
    return text;
}

}  // namespace

TEST_CASE("each blend factor, for the source and for the destination", "[execute]") {
    constexpr std::uint32_t kSource = 0x60c850a0, kDest = 0xb43296f0;
    // What is left of the source if the destination's factor is ZERO, and the other way around.
    const struct Row {
        BlendFactor factor;
        std::uint32_t source, dest;
    } rows[] = {
        {BlendFactor::Zero, 0x00000000, 0x00000000},        {BlendFactor::One, 0x60c850a0, 0xb43296f0},
        {BlendFactor::SourceColor, 0x249d1964, 0x44272f97}, {BlendFactor::InvSourceColor, 0x3c2b373c, 0x700b6759},
        {BlendFactor::DestColor, 0x44272f97, 0x7f0a58e2},   {BlendFactor::InvDestColor, 0x1ca12109, 0x35283e0e},
        {BlendFactor::SourceAlpha, 0x244b1e3c, 0x4413385a}, {BlendFactor::InvSourceAlpha, 0x3c7d3264, 0x701f5e96},
        {BlendFactor::DestAlpha, 0x448d3871, 0x7f236aa9},   {BlendFactor::InvDestAlpha, 0x1c3b182f, 0x350f2c47},
    };
    check_table(rows, &Row::factor, &Row::source);
    check_table(rows, &Row::factor, &Row::dest);
    for (const Row& row : rows) {
        INFO(enum_name(row.factor));
        CHECK(blended({row.factor, BlendFactor::Zero}, {}, kSource, kDest) == row.source);
        CHECK(blended({BlendFactor::Zero, row.factor}, {}, kSource, kDest) == row.dest);
    }
}

TEST_CASE("both products of a blend add up, are rounded once and end at white", "[execute]") {
    const struct {
        BlendState blend;
        std::uint32_t expected;
    } rows[] = {
        {kReplace, 0x60c850a0},
        {kAlphaOver,
         0x946a7cd2},  // alpha: (96 * 96 + 180 * 159) / 255 = 148.4; red: (200 * 96 + 50 * 159) / 255 = 106.5
        {kMultiply, 0x44272f97},
        {{BlendFactor::One, BlendFactor::One}, 0xfffae6ff},
    };
    for (const auto& row : rows) {
        INFO(enum_name(row.blend.source) << ", " << enum_name(row.blend.dest));
        CHECK(blended(row.blend, {}, 0x60c850a0, 0xb43296f0) == row.expected);
    }
}

TEST_CASE("each channel of the colour mask", "[execute]") {
    constexpr std::uint32_t kSource = 0xaabbccdd, kDest = 0x11223344;
    const struct {
        ColorMask mask;
        std::uint32_t expected;
    } rows[] = {
        {{.red = false, .green = false, .blue = false, .alpha = false}, 0x11223344},
        {{.red = true, .green = false, .blue = false, .alpha = false}, 0x11bb3344},
        {{.red = false, .green = true, .blue = false, .alpha = false}, 0x1122cc44},
        {{.red = false, .green = false, .blue = true, .alpha = false}, 0x112233dd},
        {{.red = false, .green = false, .blue = false, .alpha = true}, 0xaa223344},
        {{.red = true, .green = true, .blue = true, .alpha = false}, 0x11bbccdd},
        {{}, 0xaabbccdd},
    };
    for (const auto& row : rows) {
        INFO(row.mask.red << row.mask.green << row.mask.blue << row.mask.alpha);
        CHECK(blended(kReplace, row.mask, kSource, kDest) == row.expected);
    }
    CHECK(blended({BlendFactor::One, BlendFactor::One}, {.red = false, .alpha = false}, kSource, kDest) == 0x1122ffff);
}

TEST_CASE("each function of the alpha test", "[execute]") {
    check_table(kCompareRows, &CompareRow::func, &CompareRow::passed);
    for (const CompareRow& row : kCompareRows) {
        for (const std::uint32_t reference : {1u, 100u, 128u, 254u}) {
            INFO(enum_name(row.func) << ' ' << reference);
            Frame frame           = small_frame(3, 1);
            Pass& pass            = frame.passes[0];
            pass.state.alpha_test = {.func = row.func, .reference = static_cast<std::uint8_t>(reference)};
            for (int x = 0; x < 3; ++x) {
                const std::uint32_t alpha = reference - 1 + static_cast<std::uint32_t>(x);
                pass.draws.push_back(rectangle({x, 0, x + 1, 1}, alpha << 24 | 0x00ffffff));
            }
            CHECK(passed(pixels_on_both(frame)) == row.passed);
        }
    }
}

TEST_CASE("the alpha test sees what the texture stages made", "[execute]") {
    Frame frame               = small_frame(2, 1);
    Pass& pass                = frame.passes[0];
    pass.state.alpha_test     = {.func = CompareFunc::Equal, .reference = 0x50};
    pass.state.texture_factor = {0x50000000};
    pass.state.stages[0]      = {.color_op   = TextureOp::SelectArg2,
                                 .alpha_op   = TextureOp::SelectArg1,
                                 .alpha_arg1 = {.source = ArgSource::TFactor}};
    pass.draws                = {rectangle({0, 0, 1, 1}, 0x99112233)};
    CHECK(pixels_on_both(frame) == std::vector<std::uint32_t>{0x50112233, 0});
}

TEST_CASE("each function of the depth test, in each format", "[execute]") {
    const struct {
        TargetFormat format;
        float least_step;  // a unit or two of the format, or of a float near 0.5
    } formats[] = {{TargetFormat::D16, 0x1p-15f}, {TargetFormat::D24, 0x1p-23f}, {TargetFormat::D32, 0x1p-24f}};
    check_table(kCompareRows, &CompareRow::func, &CompareRow::passed);
    for (const CompareRow& row : kCompareRows) {
        for (const auto& [format, least_step] : formats) {
            for (const float step : {least_step, 0.25f, 0.5f}) {
                INFO(enum_name(row.func) << ' ' << enum_name(format) << ' ' << step);
                Frame frame                       = small_frame(3, 1, format);
                frame.passes[0].state.depth.write = true;
                frame.passes[0].state.color_mask  = {false, false, false, false};
                frame.passes[0].draws             = {rectangle({0, 0, 3, 1}, 0, 0.5f)};
                Pass tested                       = frame.passes[0];
                tested.state                      = {};
                tested.state.depth.func           = row.func;
                tested.draws                      = {rectangle({0, 0, 1, 1}, 0xffffffff, 0.5f - step),
                                                     rectangle({1, 0, 2, 1}, 0xffffffff, 0.5f),
                                                     rectangle({2, 0, 3, 1}, 0xffffffff, 0.5f + step)};
                frame.passes.push_back(tested);
                CHECK(passed(pixels_on_both(frame)) == row.passed);
            }
        }
    }
}

TEST_CASE("depth is written if the state says so and both tests pass", "[execute]") {
    const struct Row {
        const char* name;
        DepthState depth;
        AlphaTestState alpha_test;
        bool has_color_mask;
        bool written;
    } rows[] = {
        {"write", {CompareFunc::Less, true}, {}, true, true},
        {"write without a test", {CompareFunc::Always, true}, {}, true, true},
        {"write without a colour", {CompareFunc::Less, true}, {}, false, true},
        {"no write", {CompareFunc::Less, false}, {}, true, false},
        {"depth test fails", {CompareFunc::Greater, true}, {}, true, false},
        {"alpha test fails", {CompareFunc::Less, true}, {CompareFunc::Less, 0x80}, true, false},
    };
    for (const Row& row : rows) {
        INFO(row.name);
        Frame frame           = small_frame(2, 1, TargetFormat::D24);
        Pass& pass            = frame.passes[0];
        pass.clear.depth      = 0.75f;
        pass.state.depth      = row.depth;
        pass.state.alpha_test = row.alpha_test;
        if (!row.has_color_mask) pass.state.color_mask = {false, false, false, false};
        pass.draws = {rectangle({0, 0, 2, 1}, 0xff0000ff, 0.25f)};

        Pass shown             = frame.passes[0];
        shown.clear            = {.color = Argb{0}, .depth = {}};
        shown.state            = {};
        shown.state.depth.func = CompareFunc::Equal;
        shown.draws = {rectangle({0, 0, 1, 1}, 0xffffffff, 0.25f), rectangle({1, 0, 2, 1}, 0xffffffff, 0.75f)};
        frame.passes.push_back(shown);
        const std::vector<std::uint32_t> old = {0, 0xffffffff}, updated = {0xffffffff, 0};
        CHECK(pixels_on_both(frame) == (row.written ? updated : old));
    }
}
