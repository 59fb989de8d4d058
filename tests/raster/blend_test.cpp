// SPDX-License-Identifier: MIT
// Every blend state against its formula: on all instruction sets, as compiled for any state and for the special
// programs, and the scalar reference. A colour channel depends on bytes s, d (source and destination) and on alphas.
// Where it depends on both colours and one alpha, all 2^24 are tried; on both colours and both alphas, all 2^16 colours
// at 16 x 16 pairs of alphas; on two bytes or fewer, all of them. Alpha sees all 2^16 pairs; Shift7 copies it. The slow
// ones see a part: of the pairs with an alpha every 16th and those at kEdges; of the colours every 97th batch of 256
// pixels (the reference) or 13th (the fallback without vectors), and at kEdges every 5th.
#include <array>
#include <catch2/catch.hpp>
#include <vector>

#include "raster/fill_state.h"
#include "tests/raster/blend_bench.h"
#include "tests/raster/blend_formula.h"
#include "tests/raster/simd_kernels.h"
#include "tests/raster/special_parts.h"

namespace {

using namespace raster;
using blend_bench::BlendBench;
using exact::Pixel;
using exact::shuffled;
using simd_kernels::is_edge;
using simd_kernels::kLanes;

// What a colour channel depends on.
struct Inputs {
    bool source, dest, source_alpha, dest_alpha;
};

Inputs inputs_of(const Blend& blend) {
    const auto either = [&](BlendFactor::Operand operand, bool alpha) {
        const auto is = [&](const BlendFactor& f) { return f.operand == operand && f.alpha == alpha; };
        return is(blend.source) || is(blend.dest);
    };
    using enum BlendFactor::Operand;
    if (blend.rule != BlendRule::Shift7)
        return {blend.source != kZero || either(Source, false), blend.dest != kZero || either(Dest, false),
                either(Source, true), either(Dest, true)};
    const Shift7Blend& s = blend.shift7;
    const auto reads     = [&](Shift7Blend::Operand operand) {
        return s.d == operand || (s.a != s.b && (s.a == operand || s.b == operand));
    };
    return {s.only_above_half || reads(Shift7Blend::Operand::Source), reads(Shift7Blend::Operand::Dest),
            s.only_above_half || (s.a != s.b && s.c == Shift7Blend::Factor::SourceAlpha),
            s.a != s.b && s.c == Shift7Blend::Factor::DestAlpha};
}

class Sweep {
  public:
    explicit Sweep(const Blend& blend) : bench_(blend), inputs_(inputs_of(blend)) {}

    std::size_t everything() {
        const bool copies_alpha = bench_.blend().rule == BlendRule::Shift7;
        if (!copies_alpha || inputs_.source_alpha || inputs_.dest_alpha) pairs();
        const bool colors = inputs_.source && inputs_.dest;
        if (inputs_.source_alpha && inputs_.dest_alpha) {
            for (const int source_alpha : kAlphas)
                for (const int dest_alpha : kAlphas) all_colors(source_alpha, dest_alpha);
        } else if (colors && (inputs_.source_alpha || inputs_.dest_alpha)) {
            for (const int alpha : simd_kernels::swept_bytes()) all_colors(alpha, alpha);
        } else {
            all_colors(101, 202);
        }
        return bench_.batches();
    }

  private:
    static constexpr std::array kAlphas{0, 1, 2, 31, 64, 85, 100, 126, 127, 128, 129, 192, 200, 253, 254, 255};

    // All pairs of an alpha with any other byte of the pixels.
    void pairs() {
        for (const bool source_varies : {false, true})
            for (const int i : simd_kernels::swept_bytes()) {
                for (int lane = 0; lane < kLanes; ++lane) {
                    Pixel s, d;
                    for (int channel = 0; channel < 3; ++channel) {
                        s.c[channel] = shuffled(channel, lane);
                        d.c[channel] = shuffled((channel + 1) % 3, lane);
                    }
                    s.c[3]                = source_varies ? lane : i;
                    d.c[3]                = source_varies ? i : lane;
                    bench_.source()[lane] = s.argb();
                    bench_.dest()[lane]   = d.argb();
                }
                bench_.want_formula(0);
                const bool slow = i % 16 == 0 || is_edge(i);
                bench_.run(0, {.reference = slow, .fallback = slow});
            }
    }

    // All pairs of a source's and a destination's byte: three of the latter in one batch. An alpha that is not read is
    // another in each lane.
    void all_colors(int source_alpha, int dest_alpha) {
        std::array<std::uint32_t, kLanes> source{}, dest_alphas{}, want_alpha{};
        for (int lane = 0; lane < kLanes; ++lane) {
            const int sa      = inputs_.source_alpha ? source_alpha : lane ^ source_alpha;
            const int da      = inputs_.dest_alpha ? dest_alpha : lane ^ dest_alpha;
            source[lane]      = Pixel{{shuffled(0, lane), shuffled(1, lane), shuffled(2, lane), sa}}.argb();
            dest_alphas[lane] = static_cast<std::uint32_t>(da) << 24;
            want_alpha[lane]  = static_cast<std::uint32_t>(blend_formula::blended_alpha(bench_.blend(), sa, da)) << 24;
        }
        std::copy_n(source.data(), kLanes, bench_.source());
        const bool edge = is_edge(source_alpha) && is_edge(dest_alpha);
        for (int d = 0; d < 256; d += 3 * simd_kernels::kStride) {
            const Pixel dest{{d, (d + 1) & 255, (d + 2) & 255, 0}};
            std::array<std::array<std::uint8_t, 256>, 3> rows;
            for (int channel = 0; channel < 3; ++channel)
                blend_formula::with_channel(bench_.blend(), {dest.c[channel], source_alpha, dest_alpha}, [&](auto f) {
                    for (int s = 0; s < 256; ++s) rows[channel][s] = static_cast<std::uint8_t>(f(s));
                });
            const std::uint32_t dest_rgb = dest.argb();
            for (int lane = 0; lane < kLanes; ++lane) {
                bench_.dest()[lane] = dest_rgb | dest_alphas[lane];
                bench_.want()[lane] =
                    static_cast<std::uint32_t>(rows[0][shuffled(0, lane)] | rows[1][shuffled(1, lane)] << 8 |
                                               rows[2][shuffled(2, lane)] << 16) |
                    want_alpha[lane];
            }
            ++counter_;
            const bool at_edge = edge && counter_ % 5 == 0;
            bench_.run(0, {.reference = at_edge || counter_ % 97 == 0, .fallback = at_edge || counter_ % 13 == 0});
        }
    }

    BlendBench bench_;
    Inputs inputs_;
    int counter_ = 0;
};

enum class Alphas { SourceOnly, Others };  // which of the factor pairs

void sweep_factor_pairs(BlendRule rule, Alphas which) {
    using enum BlendFactor::Operand;
    static constexpr std::array<BlendFactor, 10> kFactors{{kZero,
                                                           kOne,
                                                           {Source, false, false},
                                                           {Source, false, true},
                                                           {Source, true, false},
                                                           {Source, true, true},
                                                           {Dest, false, false},
                                                           {Dest, false, true},
                                                           {Dest, true, false},
                                                           {Dest, true, true}}};
    std::size_t batches = 0;
    for (const BlendFactor& source : kFactors)
        for (const BlendFactor& dest : kFactors) {
            const Blend blend{.rule = rule, .source = source, .dest = dest};
            const Inputs inputs   = inputs_of(blend);
            const bool has_source = inputs.source_alpha && !inputs.dest_alpha;
            if (has_source == (which == Alphas::SourceOnly)) batches += Sweep(blend).everything();
        }
    CHECK(batches > 0);
}

void sweep_shift7(bool clamp) {
    static constexpr std::array<std::uint8_t, 16> kConstants{0,   1,   2,   31,  64,  85,  100, 126,
                                                             127, 128, 129, 192, 200, 253, 254, 255};
    using enum Shift7Blend::Operand;
    using enum Shift7Blend::Factor;
    std::size_t batches = 0;
    for (const auto a : {Source, Dest, Zero})
        for (const auto b : {Source, Dest, Zero})
            for (const auto d : {Source, Dest, Zero}) {
                Blend blend{.rule = BlendRule::Shift7, .shift7 = {.a = a, .b = b, .d = d, .clamp = clamp}};
                for (const auto c : {SourceAlpha, DestAlpha}) {
                    blend.shift7.c = c;
                    batches += Sweep(blend).everything();
                }
                blend.shift7.c = Constant;
                for (const std::uint8_t constant : kConstants) {
                    blend.shift7.constant = constant;
                    batches += Sweep(blend).everything();
                }
            }
    CHECK(batches > 0);
}

}  // namespace

TEST_CASE("Nearest255: every factor pair with source alpha is exact", "[raster][exhaustive]") {
    sweep_factor_pairs(BlendRule::Nearest255, Alphas::SourceOnly);
}

TEST_CASE("Nearest255: every other factor pair is exact", "[raster][exhaustive]") {
    sweep_factor_pairs(BlendRule::Nearest255, Alphas::Others);
}

TEST_CASE("Trunc256: every factor pair with source alpha is exact", "[raster][exhaustive]") {
    sweep_factor_pairs(BlendRule::Trunc256, Alphas::SourceOnly);
}

TEST_CASE("Trunc256: every other factor pair is exact", "[raster][exhaustive]") {
    sweep_factor_pairs(BlendRule::Trunc256, Alphas::Others);
}

TEST_CASE("Shift7: every choice of operands is exact, clamped", "[raster][exhaustive]") {
    sweep_shift7(true);
}

TEST_CASE("Shift7: every choice of operands is exact, modulo 256", "[raster][exhaustive]") {
    sweep_shift7(false);
}

TEST_CASE("Shift7: below half, alpha turns the blend off", "[raster][exhaustive]") {
    using enum Shift7Blend::Operand;
    const bool clamp = GENERATE(true, false);
    Blend blend{.rule   = BlendRule::Shift7,
                .shift7 = {.a = Source, .b = Dest, .d = Dest, .only_above_half = true, .clamp = clamp}};
    for (const auto c :
         {Shift7Blend::Factor::SourceAlpha, Shift7Blend::Factor::DestAlpha, Shift7Blend::Factor::Constant}) {
        blend.shift7.c        = c;
        blend.shift7.constant = 77;
        CHECK(Sweep(blend).everything() > 0);
    }
}

TEST_CASE("blends of the special programs are among those swept", "[raster]") {
    for (const FillProgram& program : special_parts::kPrograms) {
        REQUIRE(program.blend == BlendRule::Nearest255);
        CAPTURE(blend_formula::name_of(program.source), blend_formula::name_of(program.dest));
        const Blend blend{.source     = program.source,
                          .dest       = program.dest,
                          .write_mask = program.writes == Writes::Alpha ? 0xff000000u : 0xffffffffu};
        CHECK(BlendBench(blend).special_kernels() == pipeline::simd_targets().size());
    }
}
