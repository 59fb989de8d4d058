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
            FillState state     = texture_only(pixels.texture);
            state.source_factor = kFactors[s];
            state.dest_factor   = kFactors[d];
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
    over.source_factor = kFactors[4];
    over.dest_factor   = kFactors[5];
    CHECK(pixel(over, 0x80ff8040, 0xff008000) == 0xbf808020);
    CHECK(pixel(over, 0x00ffffff, 0x12345678) == 0x12345678);
    CHECK(pixel(over, 0xff123456, 0x9abcdef0) == 0xff123456);
    CHECK(pixel(additive(), 0x80604020, 0x90a0c0e0) == 0xffffffff);
}

TEST_CASE("Only channels in the write mask change", "[reference]") {
    FillState state;
    for (std::uint32_t mask : {0u, 0xffu, 0xff00u, 0xff0000u, 0xff000000u, 0xffffffu, 0xff00ff00u, 0xffffffffu}) {
        state.write_mask = mask;
        CHECK(pixel(state, 0x11223344, 0xaabbccdd) == ((0x11223344 & mask) | (0xaabbccdd & ~mask)));
    }
}

TEST_CASE("A masked or missing colour target leaves depth and counts as they are", "[reference]") {
    FillState state;
    state.depth_write = true;
    state.write_mask  = GENERATE(0u, kWhite);
    Image color(8, 8), depth(8, 8);
    const bool has_color = state.write_mask == 0;
    const Draw all{state, {}, {rectangle(0, 0, 8, 8, kWhite, 1.0f)}};
    const FillCounts counts = reference_fill_pass({has_color ? &color : nullptr, &depth, 16, depth.bounds(), {all}});
    CHECK(counts == FillCounts{64, 64, 64, 0});
    CHECK(depth.row(7)[7] == 0xffff);
    CHECK(color.row(7)[7] == 0);
}

TEST_CASE("Combine operations are exact and rounded once", "[reference]") {
    const auto op       = GENERATE(CombineOp::Select, CombineOp::Modulate, CombineOp::Modulate2X, CombineOp::Modulate4X,
                                   CombineOp::Add, CombineOp::AddSigned, CombineOp::AddSigned2X, CombineOp::Subtract);
    // In 255ths of a byte, so that products and sums have one denominator. One half is 127.5 of 255, which only the
    // doubled sum holds; the single one takes 127.
    const auto expected = [op](int a, int b) {
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
        }
        return -1;
    };
    RandomPixels pixels(static_cast<unsigned>(op) + 100);
    for (int variant = 0; variant < 16; ++variant) {
        const CombineArg a{Source::Texel, (variant & 1) != 0, (variant & 2) != 0};
        const CombineArg b{Source::Constant, (variant & 4) != 0, (variant & 8) != 0};
        FillState state    = texture_only(pixels.texture);
        state.stages[0]    = {{op, a, b}, {op, a, b}};
        state.constant     = random_color(pixels.random);
        const auto operand = [](std::uint32_t color, const CombineArg& arg, int c) {
            const int value = arg.alpha_replicate ? channel(color, 3) : channel(color, c);
            return arg.complement ? 255 - value : value;
        };
        pixels.canvas.draw(state, rectangle(0, 0, kSide, kSide));
        int wrong = 0;
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x)
                for (int c = 0; c < 4; ++c)
                    if (channel(pixels.canvas.at(x, y), c) !=
                        expected(operand(pixels.source(x, y), a, c), operand(state.constant, b, c)))
                        ++wrong;
        CAPTURE(static_cast<int>(op), variant);
        CHECK(wrong == 0);
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

TEST_CASE("Alpha and depth tests keep a fragment if it compares so to the reference", "[reference]") {
    struct Row {
        Compare func;
        bool below, same, above;
    };
    const Row row = GENERATE(Row{Compare::Always, true, true, true}, Row{Compare::LessEqual, true, true, false},
                             Row{Compare::Less, true, false, false}, Row{Compare::GreaterEqual, false, true, true},
                             Row{Compare::Greater, false, false, true}, Row{Compare::Equal, false, true, false});
    const std::array<bool, 3> passes = {row.below, row.same, row.above};
    for (int i = 0; i < 3; ++i) {
        FillState alpha;
        alpha.alpha_func      = row.func;
        alpha.alpha_reference = 100;
        alpha.depth_write     = true;
        Canvas canvas(2, 1);
        const auto color  = static_cast<std::uint32_t>(99 + i) << 24 | 0x123456;
        FillCounts counts = canvas.draw(alpha, rectangle(0, 0, 2, 1, color, 1.0f));
        CHECK(counts == (passes[i] ? FillCounts{2, 2, 2, 0} : FillCounts{2, 0, 0, 0}));
        CHECK(canvas.at(1, 0) == (passes[i] ? color : 0));
        CHECK(canvas.depth.row(0)[1] == (passes[i] ? 0xffffff : 0));

        FillState depth;
        depth.depth_func                    = row.func;
        canvas.color.row(0)[0]              = 0;
        const std::array<float, 3> fragment = {0.25f, 0.5f, 0.75f};
        for (bool write : {false, true}) {
            depth.depth_write      = write;
            canvas.depth.row(0)[0] = 1 << 23;  // what 0.5 is in 24 bits
            counts                 = canvas.draw(depth, rectangle(0, 0, 1, 1, color, fragment[i]));
            CHECK(counts == (passes[i] ? FillCounts{1, 1, 1, 0} : FillCounts{1, 1, 0, 0}));
            CHECK(canvas.at(0, 0) == (passes[i] ? color : 0));
            const std::array<std::uint32_t, 3> written = {1 << 22, 1 << 23, 3 << 22};
            const bool wrote                           = write && passes[i];
            CHECK(std::abs(static_cast<int>(canvas.depth.row(0)[0]) -
                           static_cast<int>(wrote ? written[i] : 1u << 23)) <= (wrote ? 1 : 0));
        }
    }
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
}
