// SPDX-License-Identifier: MIT
// The oracle's blends that are not one rounding of the exact sum, its dither, and what its targets keep: numbers worked
// out by hand, and what must be true of every byte.
#include <array>
#include <catch2/catch.hpp>

#include "raster/reference.h"
#include "raster/reference_color.h"
#include "tests/raster/reference_scene.h"

using namespace raster;
using namespace reference_scene;

namespace {

using Operand = BlendFactor::Operand;

constexpr BlendFactor kSourceAlpha{.operand = Operand::Source, .alpha = true};
constexpr BlendFactor kOneMinusSourceAlpha{.operand = Operand::Source, .alpha = true, .invert = true};
constexpr BlendFactor kDestAlpha{.operand = Operand::Dest, .alpha = true};

constexpr ColorFormat kRgba6{6, 6, 6, 6};
constexpr ColorFormat kRgb565{5, 6, 5, 0};
constexpr ColorFormat kArgb1555{5, 5, 5, 1};
constexpr ColorFormat kCt16{5, 5, 5, 1, true};
constexpr ColorFormat kCt24{8, 8, 8, 0, true};
constexpr ColorFormat kRgb8{8, 8, 8, 0};

FillState truncating(BlendFactor source, BlendFactor dest) {
    FillState state;
    state.blend.rule   = BlendRule::Trunc256;
    state.blend.source = source;
    state.blend.dest   = dest;
    return state;
}

// A byte of the GS's register ALPHA: A | B << 2 | C << 4 | D << 6, each 0: source, 1: dest, 2: zero, or, of C, FIX.
FillState gs(int alpha, int fix = 0) {
    using A = Shift7Blend::Operand;
    using C = Shift7Blend::Factor;

    const std::array<A, 3> operands = {A::Source, A::Dest, A::Zero};
    const std::array<C, 3> factors  = {C::SourceAlpha, C::DestAlpha, C::Constant};
    FillState state;
    state.blend.rule            = BlendRule::Shift7;
    state.blend.shift7.a        = operands[alpha & 3];
    state.blend.shift7.b        = operands[(alpha >> 2) & 3];
    state.blend.shift7.c        = factors[(alpha >> 4) & 3];
    state.blend.shift7.d        = operands[alpha >> 6];
    state.blend.shift7.constant = static_cast<std::uint8_t>(fix);
    return state;
}

std::uint32_t with_alpha(int alpha, int rgb) {
    return static_cast<std::uint32_t>(alpha) << 24 | (grey(rgb) & 0xffffff);
}

}  // namespace

TEST_CASE("Blends of rule Trunc256 with known answers", "[reference]") {
    const FillState over = truncating(kSourceAlpha, kOneMinusSourceAlpha);
    // 128 expands to 129, 127 stays: 200 * 129 + 100 * 127 = 38500, of 256 150.4; alpha 128 * 129 + 0 = 16512, 64.5.
    CHECK(pixel(over, with_alpha(128, 200), with_alpha(0, 100)) == with_alpha(64, 150));
    // 64, and 191 expands to 192: 12800 + 19200 = 32000, 125 exactly; alpha 4096, 16 exactly.
    CHECK(pixel(over, with_alpha(64, 200), with_alpha(0, 100)) == with_alpha(16, 125));
    // Multiplying what is there by an alpha: 200 * 100 = 20000, 78.1; 200 * 201 = 40200, 157.03. Its alpha becomes
    // 10 * 100 = 1000, 3.9; 10 * 201 = 2010, 7.9.
    const FillState multiply = truncating(kZero, kSourceAlpha);
    CHECK(pixel(multiply, with_alpha(100, 1), with_alpha(10, 200)) == with_alpha(3, 78));
    CHECK(pixel(multiply, with_alpha(200, 1), with_alpha(10, 200)) == with_alpha(7, 157));
    // 255 - 127 = 128 is taken before it expands to 129: 100 * 129 = 12900, 50.4.
    const FillState inverse = truncating(kZero, {.operand = Operand::Source, .invert = true});
    CHECK(pixel(inverse, grey(127), grey(100)) == grey(50));
    CHECK(pixel(truncating(kOne, kOne), grey(200), with_alpha(1, 100)) == with_alpha(201, 255));
}

TEST_CASE("A source with alpha 1 adds nothing by Trunc256", "[reference]") {
    const FillState add = truncating(kSourceAlpha, kOne);
    for (int byte = 0; byte < 256; ++byte)
        CHECK(pixel(add, with_alpha(1, byte), with_alpha(77, 255 - byte)) == with_alpha(77, 255 - byte));
    // Nearest255 adds 1 of 255: 255 * 1 + 255 * 9 = 255 * 10.
    FillState nearest;
    nearest.blend.source = kSourceAlpha;
    nearest.blend.dest   = kOne;
    CHECK(pixel(nearest, with_alpha(1, 255), with_alpha(77, 9)) == with_alpha(77, 10));
}

TEST_CASE("One colour over itself stays, whatever the alpha, by Trunc256", "[reference]") {
    const FillState over = truncating(kSourceAlpha, kOneMinusSourceAlpha);
    for (int alpha = 0; alpha < 256; ++alpha)
        for (int byte = alpha & 7; byte < 256; byte += 8)
            CHECK((pixel(over, with_alpha(alpha, byte), grey(byte)) & 0xffffff) == (grey(byte) & 0xffffff));
}

TEST_CASE("Blends of rule Shift7 with known answers", "[reference]") {
    struct Row {
        int alpha, fix;
        std::uint32_t source, dest;
        int clamped, wrapped;
    };
    const std::array<Row, 18> rows = {{
        // (Cs - Cd) As + Cd
        {0x44, 0, with_alpha(0x40, 200), with_alpha(9, 100), 150, 150},
        {0x44, 0, with_alpha(0x40, 100), with_alpha(9, 200), 150, 150},
        {0x44, 0, with_alpha(0x40, 100), with_alpha(9, 201), 150, 150},  // -50.5 is -51
        {0x44, 0, with_alpha(0x80, 37), with_alpha(9, 201), 37, 37},
        {0x44, 0, with_alpha(0xff, 200), with_alpha(9, 100), 255, 43},  // 199.2 + 100
        {0x44, 0, with_alpha(0xff, 0), with_alpha(9, 255), 0, 2},       // -508.01 is -509; -254
        // Cd - Cs As, Cd - Cs FIX
        {0x42, 0, with_alpha(1, 3), with_alpha(9, 100), 99, 99},  // -3/128 is -1
        {0x42, 0, with_alpha(0, 3), with_alpha(9, 100), 100, 100},
        {0x62, 128, with_alpha(1, 255), with_alpha(9, 10), 0, 11},  // -245
        // Cs As + Cd, Cs FIX + Cd
        {0x48, 0, with_alpha(0x20, 100), with_alpha(9, 50), 75, 75},
        {0x48, 0, with_alpha(0x01, 127), with_alpha(9, 50), 50, 50},  // 0.99
        {0x68, 0x20, with_alpha(9, 200), with_alpha(9, 230), 255, 24},
        // Cd As, Cs Ad, (Cs - Cd) Ad + Cd, (Cd - Cs) Ad + Cs
        {0x89, 0, with_alpha(100, 7), with_alpha(9, 200), 156, 156},  // 156.25
        {0x98, 0, with_alpha(7, 200), with_alpha(0x80, 9), 200, 200},
        {0x54, 0, with_alpha(7, 200), with_alpha(0x60, 100), 175, 175},
        {0x11, 0, with_alpha(7, 200), with_alpha(0x60, 100), 125, 125},
        // A = B: Cs, Cd
        {0x00, 0, with_alpha(200, 33), with_alpha(9, 100), 33, 33},
        {0x40, 0, with_alpha(200, 33), with_alpha(9, 100), 100, 100},
    }};
    for (const Row& row : rows) {
        FillState state = gs(row.alpha, row.fix);
        CAPTURE(row.alpha, row.source, row.dest);
        const int alpha = channel(row.source, 3);  // is copied
        CHECK(pixel(state, row.source, row.dest) == with_alpha(alpha, row.clamped));
        state.blend.shift7.clamp = false;
        CHECK(pixel(state, row.source, row.dest) == with_alpha(alpha, row.wrapped));
    }
    // The default writes the source.
    FillState plain;
    plain.blend.rule = BlendRule::Shift7;
    CHECK(pixel(plain, 0x12345678, 0x9abcdef0) == 0x12345678);
    // Each channel by itself: halves of -0x40, -0xff and 0x80 are added to 0x80, 0xff and 0.
    CHECK(pixel(gs(0x44), 0x40400080, 0x0080ff00) == 0x40607f40);
}

TEST_CASE("Only fragments above half alpha are blended, if so asked", "[reference]") {
    FillState state                    = gs(0x64, 0x40);
    state.blend.shift7.only_above_half = true;
    CHECK(pixel(state, with_alpha(0x7f, 200), with_alpha(9, 100)) == with_alpha(0x7f, 200));
    CHECK(pixel(state, with_alpha(0x80, 200), with_alpha(9, 100)) == with_alpha(0x80, 150));
}

TEST_CASE("The top bit of alpha is set after it was looked at", "[reference]") {
    FillState state                = gs(0x44);
    state.blend.shift7.set_top_bit = true;
    CHECK(pixel(state, with_alpha(0x40, 200), with_alpha(9, 100)) == with_alpha(0xc0, 150));
    CHECK(pixel(state, with_alpha(0xc0, 0), with_alpha(9, 0)) == with_alpha(0xc0, 0));
    state.blend.shift7.only_above_half = true;
    CHECK(pixel(state, with_alpha(0x40, 200), with_alpha(9, 100)) == with_alpha(0xc0, 200));
    state.blend.write_mask = 0x00ffffff;
    CHECK(pixel(state, with_alpha(0x40, 200), with_alpha(9, 100)) == with_alpha(9, 200));
    state.blend.write_mask = 0xffffffff;
    CHECK(pixel(state, with_alpha(0x00, 200), 0, kCt16) == 0x80c8c8c8);
}

TEST_CASE("A matrix of the rule Shift7 is added to its colours before they are clamped", "[reference]") {
    FillState state            = gs(0x44);
    state.blend.dither         = Dither::Matrix4x4;
    state.blend.dither_matrix  = {-4, 2, -3, 3, 0, -2, 1, -1, -3, 3, -4, 2, 1, -1, 0, -2};
    const auto& matrix         = state.blend.dither_matrix;
    state.blend.shift7.clamp   = GENERATE(true, false);
    const auto [source, plain] = GENERATE(table<std::uint32_t, int>(
        {{with_alpha(0x40, 200), 100}, {with_alpha(0, 77), 0}, {with_alpha(0x80, 254), 254}}));
    Canvas canvas(9, 6);
    canvas.draw(state, rectangle(0, 0, 9, 6, source));
    for (int y = 0; y < 6; ++y) {
        for (int x = 0; x < 9; ++x) {
            const int sum      = plain + matrix[y % 4 * 4 + x % 4];
            const int expected = sum < 0     ? (state.blend.shift7.clamp ? 0 : sum + 256)
                                 : sum > 255 ? (state.blend.shift7.clamp ? 255 : sum - 256)
                                             : sum;
            CHECK(canvas.at(x, y) == with_alpha(channel(source, 3), expected));
        }
    }
    // Also where the source is not blended, and by no other rule.
    state.blend.shift7.only_above_half = true;
    canvas.draw(state, rectangle(0, 0, 9, 6, with_alpha(0x7f, 100)));
    CHECK(canvas.at(5, 0) == with_alpha(0x7f, 102));
    CHECK(canvas.at(8, 4) == with_alpha(0x7f, 96));
    state.blend.rule = BlendRule::Nearest255;
    canvas.draw(state, rectangle(0, 0, 9, 6, with_alpha(0x7f, 100)));
    CHECK(canvas.at(5, 0) == with_alpha(0x7f, 100));
}

TEST_CASE("The two by two dither, with known answers", "[reference]") {
    FillState state;
    state.blend.dither = Dither::Ordered2x2;
    Canvas canvas(3, 3);
    canvas.format = kRgba6;
    // 100 becomes 99 and 99, 101, 102, 100 with the matrix; 24 and 25 are kept, which read as 97 and 101. Alpha is not
    // dithered: 100 is 25.
    canvas.draw(state, rectangle(0, 0, 3, 3, grey(100)));
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x) CHECK(canvas.at(x, y) == with_alpha(101, x % 2 == 0 && y % 2 == 0 ? 97 : 101));
    // 255 becomes 252 and at most 255; 0 at most 3.
    canvas.draw(state, rectangle(0, 0, 3, 3, grey(255)));
    for (int i = 0; i < 9; ++i) CHECK(canvas.at(i % 3, i / 3) == kWhite);
    canvas.draw(state, rectangle(0, 0, 3, 3, 0));
    for (int i = 0; i < 9; ++i) CHECK(canvas.at(i % 3, i / 3) == 0);

    SECTION("a cell of four pixels keeps six bits of each, and the sum of them is the byte") {
        for (int byte = 0; byte < 256; ++byte) {
            canvas.draw(state, rectangle(0, 0, 3, 3, grey(byte)));
            const int sum = (channel(canvas.at(1, 1), 0) >> 2) + (channel(canvas.at(2, 1), 0) >> 2) +
                            (channel(canvas.at(1, 2), 0) >> 2) + (channel(canvas.at(2, 2), 0) >> 2);
            CHECK(sum == byte - byte / 64);
        }
    }
    SECTION("it is added to what was blended") {
        state.blend.dest = kOne;
        canvas.format    = {};
        canvas.draw({}, rectangle(0, 0, 3, 3, grey(50)));
        canvas.draw(state, rectangle(0, 0, 3, 3, grey(50)));
        CHECK(canvas.at(0, 1) == with_alpha(100, 102));
        CHECK(canvas.at(1, 0) == with_alpha(100, 101));
    }
}

TEST_CASE("What a target keeps of a colour, with known answers", "[reference]") {
    struct Row {
        ColorFormat format;
        std::uint32_t written, read;
    };
    const std::array<Row, 13> rows = {{
        {{}, 0x12345678, 0x12345678},
        {kRgba6, 0xff8103fc, 0xff8200ff},     // 129 keeps 32, which reads as 128 + 2
        {kRgba6, 0x040757fb, 0x040455fb},     // 1 as 4; 1 as 4; 21 as 84 + 1; 62 as 248 + 3
        {kRgb565, 0x12ff8709, 0xffff8608},    // 31; 33 as 132 + 2; 1 as 8
        {kRgb565, 0x12b70000, 0xffb50000},    // 10110 as 10110101
        {kArgb1555, 0x80ff0000, 0xffff0000},  // a bit of alpha as 255
        {kArgb1555, 0x7f0000ff, 0x000000ff},
        {kCt16, 0x80ff870f, 0x80f88008},  // zeros below
        {kCt16, 0x7fb7ff07, 0x00b0f800},
        {kCt24, 0x12345678, 0x80345678},  // no alpha is one, which is 128 there
        {kRgb8, 0x12345678, 0xff345678},
        {{6, 6, 6, 6, true}, 0xff8103fc, 0xfc8000fc},
        {{1, 1, 1, 1, true}, 0xff807f00, 0x80800000},
    }};
    for (const Row& row : rows) {
        CAPTURE(row.written);
        CHECK(reference::stored_color(row.format, row.written) == row.read);
        CHECK(reference::stored_color(row.format, row.read) == row.read);
        CHECK(pixel({}, row.written, 0, row.format) == row.read);
    }
}

TEST_CASE("A target keeps as many values as its bits hold, in order, and each of them for good", "[reference]") {
    for (int bits : {1, 5, 6, 8}) {
        for (bool zero_fill : {false, true}) {
            const ColorFormat format{bits, bits, bits, bits, zero_fill};
            int values         = 1;
            std::uint32_t last = 0;
            for (int byte = 0; byte < 256; ++byte) {
                const std::uint32_t read = reference::stored_color(format, grey(byte));
                CHECK(reference::stored_color(format, read) == read);
                CHECK(read >= last);
                CHECK(read == grey(static_cast<int>(read & 255)));
                if (read != last) ++values;
                last = read;
            }
            CHECK(values == 1 << bits);
            CHECK(last == grey(zero_fill ? 256 - (256 >> bits) : 255));
        }
    }
}

TEST_CASE("A source is cut to the bits of the target before it is blended", "[reference]") {
    FillState state;
    state.blend.source = kSourceAlpha;
    state.blend.dest   = kOneMinusSourceAlpha;
    const ColorFormat format{5, 6, 5, 8};
    // 255 * 128 / 255 = 128 keeps 16, 32 and 16, which read as 132, 130, 132. Alpha: 64.25.
    CHECK(pixel(state, with_alpha(128, 255), 0, format) == 0x40848284);
    // Cut, it is 248, 252, 248: 124.5, 126.5, 124.5, of which 124, 126, 124 keep 15, 31, 15.
    state.blend.cut_source = true;
    CHECK(pixel(state, with_alpha(128, 255), 0, format) == 0x407b7d7b);
    // Alpha has all its bits: 0x7b is a factor of 123, of which 5 bits would be 120. 248 * 123 / 255 = 119.6 keeps 15.
    const ColorFormat no_alpha{5, 5, 5, 0};
    CHECK(pixel(state, with_alpha(0x7b, 255), 0, no_alpha) == 0xff7b7b7b);
    // 248 * 137 / 255 = 133.2 keeps 16; whole bytes are 137, which keep 17.
    CHECK(pixel(state, with_alpha(137, 255), 0, no_alpha) == 0xff848484);
    state.blend.cut_source = false;
    CHECK(pixel(state, with_alpha(137, 255), 0, no_alpha) == 0xff8c8c8c);
    // As a factor, too: 200 * 252 / 255 = 197.6 keeps 49, which reads as 196 + 3.
    FillState product;
    product.blend.source     = kZero;
    product.blend.dest       = {.operand = Operand::Source};
    product.blend.cut_source = true;
    CHECK(channel(pixel(product, 0xffffffff, 0xff00c800, {8, 6, 8, 8}), 1) == 199);
}

TEST_CASE("A destination without alpha has an alpha of one", "[reference]") {
    FillState state = truncating(kDestAlpha, kZero);
    Canvas rgb(1, 1);
    rgb.format = kRgb8;
    rgb.draw({}, rectangle(0, 0, 1, 1, 0x11000000));
    rgb.draw(state, rectangle(0, 0, 1, 1, 0x22345678));
    CHECK(rgb.at(0, 0) == 0xff345678);
    Canvas gs24(1, 1);
    gs24.format = kCt24;
    gs24.draw({}, rectangle(0, 0, 1, 1, 0x11000000));
    gs24.draw(gs(0x98), rectangle(0, 0, 1, 1, 0x22345678));
    CHECK(gs24.at(0, 0) == 0x80345678);
}
