// SPDX-License-Identifier: MIT
// What surrounds a blend, against the formula: the cut of the source, both dithers at all 4 x 4 places, the formats
// of the target, the top bit of alpha, the write mask, and what a fragment that fails the alpha test may still write.
// On all instruction sets, and the scalar reference.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <vector>

#include "raster/fill_state.h"
#include "tests/raster/blend_bench.h"
#include "tests/raster/blend_formula.h"
#include "tests/support/random.h"

namespace {

using namespace raster;
using blend_bench::BlendBench;
using exact::Pixel;
using simd_kernels::kLanes;

constexpr std::array kFormats{
    ColorFormat{},
    ColorFormat{.alpha = 0},
    ColorFormat{.red = 5, .green = 6, .blue = 5, .alpha = 0},
    ColorFormat{.red = 5, .green = 5, .blue = 5, .alpha = 1},
    ColorFormat{.red = 6, .green = 6, .blue = 6, .alpha = 6},
    ColorFormat{.alpha = 0, .zero_fill = true},
    ColorFormat{.red = 5, .green = 5, .blue = 5, .alpha = 1, .zero_fill = true},
};

// Each of -4..3 twice; no two rows, and no two columns, are alike.
constexpr std::array<std::int8_t, 16> kMatrix{-4, 2, -3, 3, 0, -2, 1, -1, -3, 3, -4, 2, 1, -1, 0, -2};

constexpr BlendFactor kSourceColor{BlendFactor::Operand::Source, false, false};
constexpr BlendFactor kSourceAlpha{BlendFactor::Operand::Source, true, false};
constexpr BlendFactor kInvSourceAlpha{BlendFactor::Operand::Source, true, true};

Blend shift7(Shift7Blend::Operand a, Shift7Blend::Operand b, Shift7Blend::Operand d, bool clamp) {
    return {.rule   = BlendRule::Shift7,
            .shift7 = {.a = a, .b = b, .d = d, .c = Shift7Blend::Factor::Constant, .constant = 128, .clamp = clamp}};
}

std::vector<Blend> blends() {
    using enum Shift7Blend::Operand;
    std::vector<Blend> list;
    for (const BlendRule rule : {BlendRule::Nearest255, BlendRule::Trunc256}) {
        list.push_back({.rule = rule});
        list.push_back({.rule = rule, .source = kSourceAlpha, .dest = kInvSourceAlpha});
        list.push_back({.rule = rule, .source = kOne, .dest = kOne});
        list.push_back({.rule = rule, .source = kZero, .dest = kSourceColor});
    }
    list.push_back({.rule = BlendRule::Shift7});
    for (const bool clamp : {false, true}) {
        list.push_back(shift7(Source, Zero, Dest, clamp));
        list.push_back(shift7(Zero, Source, Dest, clamp));
        Blend over              = shift7(Source, Dest, Dest, clamp);
        over.shift7.c           = Shift7Blend::Factor::SourceAlpha;
        over.shift7.set_top_bit = true;
        list.push_back(over);
        over.shift7.only_above_half = true;
        list.push_back(over);
    }
    return list;
}

// In four rounds, all values of a byte come to each column of the dither.
Pixel source_of(int lane, int round) {
    Pixel s;
    for (int channel = 0; channel < 4; ++channel) s.c[channel] = exact::shuffled(channel, lane - lane % 4 + round);
    return s;
}

}  // namespace

TEST_CASE("every value comes to every format by every cut and dither", "[raster][exhaustive]") {
    for (const ColorFormat& format : kFormats)
        for (Blend blend : blends())
            for (const Dither dither : {Dither::None, Dither::Ordered2x2, Dither::Matrix4x4})
                for (const bool cut : {false, true}) {
                    blend.dither        = dither;
                    blend.dither_matrix = kMatrix;
                    blend.cut_source    = cut;
                    BlendBench bench(blend, format);
                    for (const int y : {0, 5, 2, 7})  // y & 3 is 0 to 3
                        for (int round = 0; round < 8; ++round) {
                            for (int lane = 0; lane < kLanes; ++lane) {
                                const Pixel s        = source_of(lane, round % 4);
                                const Pixel d        = {{s.c[3], s.c[0], s.c[1], s.c[2]}};
                                bench.source()[lane] = s.argb();
                                bench.dest()[lane]   = round < 4 ? d.argb() : ~d.argb() + 0x01020304u;
                            }
                            bench.want_formula(y);
                            bench.run(y, {.reference = round % 4 == 1});
                        }
                }
}

TEST_CASE("Shift7: sums below 0 and above 255 meet the dither's offsets exactly", "[raster][exhaustive]") {
    using enum Shift7Blend::Operand;
    const bool clamp = GENERATE(false, true);
    for (Blend blend : {shift7(Source, Zero, Dest, clamp), shift7(Zero, Source, Dest, clamp)}) {
        blend.dither        = Dither::Matrix4x4;
        blend.dither_matrix = kMatrix;
        BlendBench bench(blend);
        for (int y = 0; y < 4; ++y)
            for (int d = 0; d < 256; d += 3 * simd_kernels::kStride)
                for (int round = 0; round < 4; ++round) {
                    std::fill_n(bench.dest(), kLanes, Pixel{{d, (d + 1) & 255, (d + 2) & 255, d}}.argb());
                    for (int lane = 0; lane < kLanes; ++lane) bench.source()[lane] = source_of(lane, round).argb();
                    bench.want_formula(y);
                    bench.run(y, {.reference = d % 5 == 0, .fallback = d % 5 == 0});
                }
    }
}

TEST_CASE("only bits of the write mask change, and of those what the alpha test leaves", "[raster]") {
    std::vector<std::uint32_t> masks{0x00f8fcf8, 0x80000000, 0x7fffffff, 0x00ff00f0};
    for (unsigned bits = 0; bits < 16; ++bits) {
        std::uint32_t mask = 0;
        for (int channel = 0; channel < 4; ++channel)
            if (bits >> channel & 1) mask |= 0xffu << 8 * channel;
        masks.push_back(mask);
    }
    // What a fragment may change that has failed.
    struct Fail {
        Compare func;
        AlphaFail fail;
        std::uint32_t bits;
    };
    static constexpr std::array kFails{Fail{Compare::Always, AlphaFail::Keep, 0xffffffff},
                                       Fail{Compare::GreaterEqual, AlphaFail::Keep, 0},
                                       Fail{Compare::GreaterEqual, AlphaFail::ColorOnly, 0xffffffff},
                                       Fail{Compare::GreaterEqual, AlphaFail::DepthOnly, 0},
                                       Fail{Compare::GreaterEqual, AlphaFail::RgbOnly, 0x00ffffff}};
    test_support::Random random(11);
    for (const ColorFormat& format : kFormats)
        for (const Blend& blend : blends())
            for (const std::uint32_t write_mask : masks)
                for (const Fail& fail : kFails) {
                    const int reference = random.from(0, 255);
                    FillState state;
                    state.alpha_func       = fail.func;
                    state.alpha_fail       = fail.fail;
                    state.alpha_reference  = static_cast<std::uint8_t>(reference);
                    state.blend            = blend;
                    state.blend.write_mask = write_mask;
                    BlendBench bench(state, format);
                    for (int lane = 0; lane < kLanes; ++lane) {
                        bench.source()[lane] = random.bits();
                        bench.dest()[lane]   = random.bits();
                        const int alpha      = Pixel::of(bench.source()[lane]).c[3];
                        bench.mask()[lane]   = alpha >= reference ? 0xffffffff : fail.bits;
                        bench.set_live(lane, random.chance(75));
                    }
                    bench.want_formula(1);
                    bench.run(1, {.reference = fail.func == Compare::Always});
                }
}

TEST_CASE("pixels beside a fragment stay as they are", "[raster]") {
    const BlendRule rule     = GENERATE(BlendRule::Nearest255, BlendRule::Trunc256, BlendRule::Shift7);
    const ColorFormat format = GENERATE(ColorFormat{}, ColorFormat{.red = 5, .green = 6, .blue = 5});
    BlendBench bench(Blend{.rule = rule}, format);
    for (int only = 0; only < kLanes; ++only) {
        for (int lane = 0; lane < kLanes; ++lane) {
            bench.set_live(lane, lane == only);
            bench.source()[lane] = 0xffffffff;
            bench.dest()[lane]   = 0;
            bench.want()[lane]   = 0xffffffff;
        }
        bench.run(1, {});
    }
    CHECK(bench.batches() == kLanes);
}
