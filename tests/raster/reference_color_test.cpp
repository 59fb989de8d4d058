// SPDX-License-Identifier: MIT
// The oracle's colour arithmetic against fractions of 255, written here anew: each operation is exact and rounded once.
#include <array>
#include <catch2/catch.hpp>
#include <random>

#include "raster/reference.h"
#include "tests/raster/reference_scene.h"

using namespace raster;
using namespace reference_scene;

namespace {

using Operand = BlendFactor::Operand;
using Source  = CombineArg::Source;

constexpr std::array<BlendFactor, 10> kFactors = {{
    {},
    {.invert = true},
    {.operand = Operand::Source},
    {.operand = Operand::Source, .invert = true},
    {.operand = Operand::Source, .alpha = true},
    {.operand = Operand::Source, .alpha = true, .invert = true},
    {.operand = Operand::Dest},
    {.operand = Operand::Dest, .invert = true},
    {.operand = Operand::Dest, .alpha = true},
    {.operand = Operand::Dest, .alpha = true, .invert = true},
}};

// numerator / denominator (positive) to the nearest byte. No result here lies half-way between two.
int nearest_byte(int numerator, int denominator) {
    int best = 0;
    for (int byte = 1; byte <= 255; ++byte)
        if (std::abs(byte * denominator - numerator) < std::abs(best * denominator - numerator)) best = byte;
    return best;
}

// The factor as so many 255ths, by its place in kFactors.
int factor_255ths(int which, std::uint32_t source, std::uint32_t dest, int c) {
    switch (which) {
        case 0:
            return 0;
        case 1:
            return 255;
        case 2:
            return channel(source, c);
        case 3:
            return 255 - channel(source, c);
        case 4:
            return channel(source, 3);
        case 5:
            return 255 - channel(source, 3);
        case 6:
            return channel(dest, c);
        case 7:
            return 255 - channel(dest, c);
        case 8:
            return channel(dest, 3);
        default:
            return 255 - channel(dest, 3);
    }
}

constexpr int kSide = 32;

// A target of random colours, and a texture of others to draw one to one onto it.
struct RandomPixels {
    explicit RandomPixels(unsigned seed)
        : random(seed), texture(kSide, kSide, [this](int, int) { return random_color(random); }) {
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) canvas.color.row(y)[x] = before.row(y)[x] = random_color(random);
    }
    std::uint32_t source(int x, int y) const {
        const TextureLevel& level = texture.sampler.levels[0];
        return level.texels[y * level.stride + x];
    }

    std::mt19937 random;
    Texture texture;
    Image before{kSide, kSide};
    Canvas canvas{kSide, kSide};
};

CombineStage select(Source source) {
    CombineStage stage;
    stage.color.a.source = stage.alpha.a.source = source;
    return stage;
}

}  // namespace

TEST_CASE("Every pair of blend factors is one rounding of the exact sum", "[reference]") {
    for (int s = 0; s < 10; ++s) {
        for (int d = 0; d < 10; ++d) {
            RandomPixels pixels(static_cast<unsigned>(1 + s * 10 + d));
            FillState state    = texture_only(pixels.texture);
            state.blend.source = kFactors[s];
            state.blend.dest   = kFactors[d];
            CHECK(pixels.canvas.draw(state, rectangle(0, 0, kSide, kSide)).depth_passed == kSide * kSide);
            int wrong = 0;
            for (int y = 0; y < kSide; ++y) {
                for (int x = 0; x < kSide; ++x) {
                    const std::uint32_t source = pixels.source(x, y), dest = pixels.before.row(y)[x];
                    for (int c = 0; c < 4; ++c) {
                        const int sum = channel(source, c) * factor_255ths(s, source, dest, c) +
                                        channel(dest, c) * factor_255ths(d, source, dest, c);
                        if (channel(pixels.canvas.at(x, y), c) != nearest_byte(sum, 255)) ++wrong;
                    }
                }
            }
            CAPTURE(s, d);
            CHECK(wrong == 0);
        }
    }
}

TEST_CASE("Blends with known answers", "[reference]") {
    FillState over;
    over.blend.source = kFactors[4];
    over.blend.dest   = kFactors[5];
    CHECK(pixel(over, 0x80ff8040, 0xff008000) == 0xbf808020);
    CHECK(pixel(over, 0x00ffffff, 0x12345678) == 0x12345678);
    CHECK(pixel(over, 0xff123456, 0x9abcdef0) == 0xff123456);
    CHECK(pixel(additive(), 0x80604020, 0x90a0c0e0) == 0xffffffff);
}

TEST_CASE("Only channels in the write mask change", "[reference]") {
    FillState state;
    for (std::uint32_t mask : {0u, 0xffu, 0xff00u, 0xff0000u, 0xff000000u, 0xffffffu, 0xff00ff00u, 0xffffffffu}) {
        state.blend.write_mask = mask;
        CHECK(pixel(state, 0x11223344, 0xaabbccdd) == ((0x11223344 & mask) | (0xaabbccdd & ~mask)));
    }
    // Also where the target makes up an alpha, or bits of a channel.
    state.blend.write_mask = 0xff;
    CHECK(pixel(state, 0x11223344, 0xaabbccdd, {5, 6, 5, 0}) == 0xaabbcc42);
}

TEST_CASE("A masked or missing colour target leaves depth and its counts as they are", "[reference]") {
    FillState state;
    state.depth_write      = true;
    state.blend.write_mask = GENERATE(0u, kWhite);
    Image color(8, 8), depth(8, 8);
    PassFill pass;
    pass.color      = state.blend.write_mask == 0 ? &color : nullptr;
    pass.depth      = &depth;
    pass.depth_bits = 16;
    pass.scissor    = depth.bounds();
    pass.draws      = {{.state = state, .rectangles = {rectangle(0, 0, 8, 8, kWhite, 1.0f)}}};
    CHECK(reference_fill_pass(pass) == FillCounts{64, 64, 64, 64, 0});
    CHECK(depth.row(7)[7] == 0xffff);
    CHECK(color.row(7)[7] == 0);
}

TEST_CASE("Combine operations are exact and rounded once", "[reference]") {
    const auto op       = GENERATE(CombineOp::Select, CombineOp::Modulate, CombineOp::Modulate2X, CombineOp::Modulate4X,
                                   CombineOp::Add, CombineOp::AddSigned, CombineOp::AddSigned2X, CombineOp::Subtract,
                                   CombineOp::Lerp, CombineOp::MultiplyAdd);
    // In 255ths of a byte, so that products and sums have one denominator. One half is 127.5 of 255, which only the
    // doubled sum holds; the single one takes 127.
    const auto expected = [op](int a, int b, int c) {
        switch (op) {
            case CombineOp::Select:
                return nearest_byte(255 * a, 255);
            case CombineOp::Modulate:
                return nearest_byte(a * b, 255);
            case CombineOp::Modulate2X:
                return nearest_byte(2 * a * b, 255);
            case CombineOp::Modulate4X:
                return nearest_byte(4 * a * b, 255);
            case CombineOp::Add:
                return nearest_byte(255 * (a + b), 255);
            case CombineOp::AddSigned:
                return nearest_byte(255 * (a + b - 127), 255);
            case CombineOp::AddSigned2X:
                return nearest_byte(255 * (2 * (a + b) - 255), 255);
            case CombineOp::Subtract:
                return nearest_byte(255 * (a - b), 255);
            case CombineOp::Lerp:
                return nearest_byte(a * c + b * (255 - c), 255);
            case CombineOp::MultiplyAdd:
                return nearest_byte(a * b + 255 * c, 255);
        }
        return -1;
    };
    RandomPixels pixels(static_cast<unsigned>(op) + 100);
    for (int variant = 0; variant < 64; ++variant) {
        const CombineArg a{Source::Texel, (variant & 1) != 0, (variant & 2) != 0};
        const CombineArg b{Source::Constant, (variant & 4) != 0, (variant & 8) != 0};
        const CombineArg c{Source::Diffuse, (variant & 16) != 0, (variant & 32) != 0};
        FillState state    = texture_only(pixels.texture);
        state.stages[0]    = {{op, a, b, c}, {op, a, b, c}};
        state.constant     = random_color(pixels.random);
        const auto diffuse = random_color(pixels.random);
        const auto operand = [](std::uint32_t color, const CombineArg& arg, int ch) {
            const int value = arg.alpha_replicate ? channel(color, 3) : channel(color, ch);
            return arg.complement ? 255 - value : value;
        };
        pixels.canvas.draw(state, rectangle(0, 0, kSide, kSide, diffuse));
        int wrong = 0;
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x)
                for (int ch = 0; ch < 4; ++ch)
                    if (channel(pixels.canvas.at(x, y), ch) != expected(operand(pixels.source(x, y), a, ch),
                                                                        operand(state.constant, b, ch),
                                                                        operand(diffuse, c, ch)))
                        ++wrong;
        CAPTURE(static_cast<int>(op), variant);
        CHECK(wrong == 0);
    }
}

TEST_CASE("Combine operations of each rule, with known answers", "[reference]") {
    struct Row {
        CombineOp op;
        int a, b, c, nearest255, expanded256, shift7;
    };
    constexpr int kNot             = -1;  // not to be asked of Shift7
    // To nearest255 one is 255, to expanded256 255 as well, but by way of 256ths, and to shift7 it is 128.
    const std::array<Row, 23> rows = {{
        {CombineOp::Select, 200, 1, 2, 200, 200, 200},
        {CombineOp::Modulate, 77, 128, 0, 39, 39, 77},      // 38.65; 77 * 129 = 9933, of 256 38.80
        {CombineOp::Modulate, 100, 200, 0, 78, 79, 156},    // 78.43; 100 * 201 = 20100, 78.52; 156.25
        {CombineOp::Modulate, 200, 127, 0, 100, 99, 198},   // 99.61; 200 * 127 = 25400, 99.22; 198.44
        {CombineOp::Modulate, 255, 255, 0, 255, 255, 255},  // 508
        {CombineOp::Modulate, 3, 127, 0, 1, 1, 2},          // 2.98
        {CombineOp::Modulate2X, 100, 200, 0, 157, 157, kNot},
        {CombineOp::Modulate2X, 60, 100, 0, 47, 47, kNot},
        {CombineOp::Modulate2X, 200, 200, 0, 255, 255, kNot},
        {CombineOp::Modulate4X, 50, 80, 0, 63, 63, kNot},  // 62.75; 62.5, half up
        {CombineOp::Add, 200, 50, 0, 250, 250, 250},
        {CombineOp::Add, 200, 100, 0, 255, 255, 255},
        {CombineOp::AddSigned, 200, 100, 0, 173, 172, kNot},
        {CombineOp::AddSigned, 10, 20, 0, 0, 0, kNot},
        {CombineOp::AddSigned2X, 100, 100, 0, 145, 144, kNot},
        {CombineOp::Subtract, 200, 77, 0, 123, 123, kNot},
        {CombineOp::Lerp, 100, 0, 200, 78, 79, kNot},
        {CombineOp::Lerp, 200, 100, 64, 125, 125, kNot},
        {CombineOp::Lerp, 200, 100, 0, 100, 100, kNot},
        {CombineOp::Lerp, 200, 100, 255, 200, 200, kNot},
        {CombineOp::MultiplyAdd, 100, 200, 30, 108, 109, 186},
        {CombineOp::MultiplyAdd, 100, 101, 30, 70, 69, 108},  // 39.6; 10100, 39.45; 78.9
        {CombineOp::MultiplyAdd, 255, 255, 30, 255, 255, 255},
    }};
    for (const Row& row : rows) {
        const Texture texture(1, 1, [&](int, int) { return grey(row.a); });
        FillState state  = texture_only(texture);
        const Combine of = {row.op, {Source::Texel}, {Source::Constant}, {Source::Diffuse}};
        state.stages[0]  = {of, of};
        state.constant   = grey(row.b);
        CAPTURE(static_cast<int>(row.op), row.a, row.b, row.c);
        state.combine_rule = CombineRule::Nearest255;
        CHECK(pixel(state, grey(row.c)) == grey(row.nearest255));
        state.combine_rule = CombineRule::Expanded256;
        CHECK(pixel(state, grey(row.c)) == grey(row.expanded256));
        state.combine_rule = CombineRule::Shift7;
        if (row.shift7 != kNot) CHECK(pixel(state, grey(row.c)) == grey(row.shift7));
    }
}

TEST_CASE("Fog of each rule, with known answers", "[reference]") {
    struct Row {
        int fog, color, fog_color, nearest255, floor256, two_floors, expanded256;
    };
    const std::array<Row, 5> rows = {{
        {128, 201, 100, 151, 150, 149, 150},  // 150.7; 38528 of 256, 150.5; 100.5 and 49.6; 38629, 150.9
        {255, 200, 100, 200, 199, 199, 200},  // 200; 51100, 199.6; 199.2; 200
        {255, 128, 128, 128, 128, 127, 128},  // 128; 128; 127.5; 128
        {0, 200, 100, 100, 100, 99, 100},     // 100; 100; 99.6; 100
        {64, 255, 0, 64, 63, 63, 63},         // 64; 63.75
    }};
    for (const Row& row : rows) {
        const auto drawn = [&](FogRule rule) {
            FillState state;
            state.fog       = true;
            state.fog_rule  = rule;
            state.fog_color = grey(row.fog_color);
            Triangle t      = {vertex(-1, -1, grey(row.color)), vertex(9, -1, grey(row.color)),
                               vertex(-1, 9, grey(row.color))};
            for (Vertex& v : t) v.specular = static_cast<std::uint32_t>(row.fog) << 24;
            Canvas canvas(1, 1);
            canvas.draw(state, {t});
            CHECK(channel(canvas.at(0, 0), 3) == row.color);
            return canvas.at(0, 0) & 0xffffff;
        };
        CAPTURE(row.fog, row.color, row.fog_color);
        CHECK(drawn(FogRule::Nearest255) == (grey(row.nearest255) & 0xffffff));
        CHECK(drawn(FogRule::Floor256) == (grey(row.floor256) & 0xffffff));
        CHECK(drawn(FogRule::TwoFloors) == (grey(row.two_floors) & 0xffffff));
        CHECK(drawn(FogRule::Expanded256) == (grey(row.expanded256) & 0xffffff));
    }
}

TEST_CASE("Colour and alpha of a stage both read what the stage before left", "[reference]") {
    FillState state;
    state.constant          = 0x80402010;
    state.stage_count       = 2;
    state.stages[0]         = select(Source::Constant);
    // Colour becomes the alpha before; alpha becomes its complement.
    state.stages[1].color.a = {Source::Current, false, true};
    state.stages[1].alpha.a = {Source::Current, true, false};
    CHECK(pixel(state, 0x01020304) == 0x7f808080);

    state.stage_count = 1;
    CHECK(pixel(state, 0x01020304) == 0x80402010);
    state.stage_count = 0;
    CHECK(pixel(state, 0x01020304) == 0x01020304);
}

TEST_CASE("Each source is read", "[reference]") {
    const Texture texture(1, 1, [](int, int) { return 0x11121314u; });
    FillState state   = texture_only(texture);
    state.constant    = 0x21222324;
    state.stage_count = 2;
    state.stages[1]   = select(Source::Current);
    Triangle t        = {vertex(-1, -1, 0x31323334), vertex(9, -1, 0x31323334), vertex(-1, 9, 0x31323334)};
    for (Vertex& v : t) v.specular = 0x41424344;
    const auto first_stage = [&](Source source) {
        state.stages[0] = select(source);
        Canvas canvas(1, 1);
        canvas.draw(state, {t});
        return canvas.at(0, 0);
    };
    CHECK(first_stage(Source::Texel) == 0x11121314);
    CHECK(first_stage(Source::Constant) == 0x21222324);
    CHECK(first_stage(Source::Diffuse) == 0x31323334);
    CHECK(first_stage(Source::Current) == 0x31323334);
    CHECK(first_stage(Source::Specular) == 0xff424344);
}

TEST_CASE("Specular is added, then fog mixed in, and neither touches alpha", "[reference]") {
    Triangle t = {vertex(-1, -1, 0x40c08000), vertex(9, -1, 0x40c08000), vertex(-1, 9, 0x40c08000)};
    for (Vertex& v : t) v.specular = 0x60505050;
    const auto drawn = [&](bool specular, bool fog) {
        FillState state;
        state.add_specular = specular;
        state.fog          = fog;
        state.fog_color    = 0xff0064ff;
        Canvas canvas(1, 1);
        canvas.draw(state, {t});
        return canvas.at(0, 0);
    };
    CHECK(drawn(false, false) == 0x40c08000);
    CHECK(drawn(true, false) == 0x40ffd050);
    for (bool specular : {false, true}) {
        const std::uint32_t plain = drawn(specular, false), fogged = drawn(specular, true);
        CHECK(channel(fogged, 3) == 0x40);
        for (int c = 0; c < 3; ++c)
            CHECK(channel(fogged, c) == nearest_byte(0x60 * channel(plain, c) + 159 * channel(0x0064ff, c), 255));
    }

    FillState both;  // a rectangle has neither
    both.fog = both.add_specular = true;
    CHECK(pixel(both, 0x12345678) == 0x12345678);
}

TEST_CASE("A texel is read only where an operation looks at it", "[reference]") {
    FillState state;
    CHECK_FALSE(reads(state, 0, CombineArg::Source::Texel));
    state.stages[0].color.a.source = Source::Texel;
    CHECK_FALSE(reads(state, 0, CombineArg::Source::Texel));
    state.stage_count = 1;
    CHECK(reads(state, 0, CombineArg::Source::Texel));
    CHECK_FALSE(reads(state, 1, CombineArg::Source::Texel));
    state.stages[0].color = {CombineOp::Select, {Source::Diffuse}, {Source::Texel}};
    CHECK_FALSE(reads(state, 0, CombineArg::Source::Texel));
    state.stages[0].color.op = CombineOp::Add;
    CHECK(reads(state, 0, CombineArg::Source::Texel));
    state.stages[0].color          = {};
    state.stages[0].alpha.a.source = Source::Texel;
    CHECK(reads(state, 0, CombineArg::Source::Texel));
    CHECK_FALSE(reads(state, 2, CombineArg::Source::Texel));

    state.stages[0].alpha = {CombineOp::Modulate, {Source::Diffuse}, {Source::Current}, {Source::Texel}};
    CHECK_FALSE(reads(state, 0, CombineArg::Source::Texel));
    for (CombineOp op : {CombineOp::Lerp, CombineOp::MultiplyAdd}) {
        state.stages[0].alpha.op = op;
        CHECK(reads(state, 0, CombineArg::Source::Texel));
    }
}
