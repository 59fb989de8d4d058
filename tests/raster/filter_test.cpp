// SPDX-License-Identifier: MIT
// Texture filters and mips against exact sums: on all instruction sets, as compiled for any sampler and for the special
// programs', for triangles and for rectangles, and the scalar reference on a part.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <set>
#include <vector>

#include "raster/sampling_rules.h"
#include "tests/raster/exact.h"
#include "tests/raster/filter_formula.h"
#include "tests/raster/sample_bench.h"
#include "tests/raster/special_parts.h"
#include "tests/support/random.h"

namespace {

using namespace raster;
using exact::Pixel;
using fill_steps::kBlocks;
using sample_bench::SampleBench;
using simd_kernels::is_edge;
using simd_kernels::kLanes;

constexpr std::array kRules{FilterRule::Single8, FilterRule::Single4, FilterRule::Single7, FilterRule::Cascade8,
                            FilterRule::Cascade4};

// Two rows of texels in which every choice of four values out of six is somewhere a square, in one of the channels.
class SquareTexture {
  public:
    static constexpr int kSquares      = 324;  // 6^4 in four channels
    static constexpr int kSquareBlocks = (kSquares + kBlockWidth - 1) / kBlockWidth,
                         kWidth        = (kSquareBlocks + 1) * kBlockWidth;

    SquareTexture() {
        // Each pair of columns comes once: the De Bruijn sequence of the words 0, 01, 02, .., 1, 12, ..
        std::vector<int> columns;
        for (int a = 0; a < 36; ++a) {
            columns.push_back(a);
            for (int b = a + 1; b < 36; ++b) columns.insert(columns.end(), {a, b});
        }
        for (int k = 0; k < kWidth; ++k)
            for (int channel = 0; channel < 4; ++channel) {
                const int column      = columns[static_cast<std::size_t>(channel * kSquares + k) % columns.size()];
                rows[0][k].c[channel] = kValues[static_cast<std::size_t>(column / 6)];
                rows[1][k].c[channel] = kValues[static_cast<std::size_t>(column % 6)];
            }
        for (int row = 0; row < 2; ++row)
            for (int k = 0; k < kWidth; ++k) texels_[row][k] = rows[row][k].argb();
    }
    Sampler sampler(FilterRule rule) const {
        return {.levels    = {{texels_[0].data(), kWidth, 2, kWidth}},
                .linear    = true,
                .rule      = rule,
                .address_u = Address::Clamp,
                .address_v = Address::Clamp};
    }

    // Different ones of all channels.
    std::size_t count_squares() const {
        std::set<std::array<int, 4>> squares;
        for (int k = 0; k < kSquares; ++k)
            for (int c = 0; c < 4; ++c)
                squares.insert({rows[0][k].c[c], rows[0][k + 1].c[c], rows[1][k].c[c], rows[1][k + 1].c[c]});
        return squares.size();
    }

    std::array<std::array<Pixel, kWidth>, 2> rows;

  private:
    static constexpr std::array kValues{0, 1, 127, 128, 254, 255};
    std::array<std::array<std::uint32_t, kWidth>, 2> texels_{};
};

// All fractions that a filter tells apart, over all squares. Bits that it drops are set at random.
void sweep_weights(FilterRule rule) {
    const SquareTexture texture;
    REQUIRE(texture.count_squares() == 6 * 6 * 6 * 6);
    SampleBench bench(texture.sampler(rule));
    test_support::Random random(3);
    filter_formula::with_filter(rule, [&](auto filter) {
        constexpr int kUnit = decltype(filter)::kUnit;
        for (const int fv_cut : simd_kernels::swept_bytes())
            for (int fu_cut = 0; fu_cut < 256; fu_cut += kUnit * simd_kernels::kStride) {
                if (fv_cut % kUnit != 0) continue;
                const int fu = fu_cut + random.from(0, kUnit - 1), fv = fv_cut + random.from(0, kUnit - 1);
                const bool slow = (fv_cut / kUnit * 7 + fu_cut / kUnit) % 101 == 0 || (is_edge(fu) && is_edge(fv));
                for (int first = 0; first < SquareTexture::kSquares; first += kLanes) {
                    const int blocks = std::min(kBlocks, SquareTexture::kSquareBlocks - first / kBlockWidth);
                    for (int i = 0; i < blocks * kBlockWidth; ++i) {
                        const auto& [top, bottom] = texture.rows;
                        const int k               = first + i;
                        Pixel want;
                        for (int c = 0; c < 4; ++c)
                            want.c[c] =
                                filter.weigh(top[k].c[c], top[k + 1].c[c], bottom[k].c[c], bottom[k + 1].c[c], fu, fv);
                        bench.want()[i] = want.argb();
                    }
                    for (int block = 0; block < blocks; ++block) {
                        const int u = 256 * (first + block * kBlockWidth) + 128 + fu;
                        bench.set_row(block, 256 * u + random.from(0, 255), 65536, 128 + fv);
                    }
                    bench.run_rows(blocks, slow);
                }
            }
    });
}

}  // namespace

TEST_CASE("Single8: every weight of every square of texels", "[raster][exhaustive]") {
    sweep_weights(FilterRule::Single8);
}

TEST_CASE("Cascade8: every weight of every square of texels", "[raster][exhaustive]") {
    sweep_weights(FilterRule::Cascade8);
}

TEST_CASE("Single4, Single7, Cascade4: every weight of every square of texels", "[raster][exhaustive]") {
    for (const FilterRule rule : {FilterRule::Single4, FilterRule::Single7, FilterRule::Cascade4}) sweep_weights(rule);
}

TEST_CASE("rectangles read texels at any step, border and address", "[raster]") {
    static constexpr int kWidth = 64, kHeight = 4;
    test_support::Random random(5);
    std::vector<std::uint32_t> texels(kWidth * kHeight);
    for (std::uint32_t& texel : texels) texel = random.bits();
    std::size_t batches = 0;
    for (const FilterRule rule : kRules)
        for (const Address address : {Address::Clamp, Address::Wrap, Address::Mirror})
            for (const bool linear : {true, false}) {
                const Sampler sampler{.levels    = {{texels.data(), kWidth, kHeight, kWidth}},
                                      .linear    = linear,
                                      .rule      = rule,
                                      .address_u = address,
                                      .address_v = address};
                SampleBench bench(sampler);
                // 1/64 of 1/256 texel to the pixel: 16384 is one texel.
                for (const int step :
                     {0,     1,     64,    1000,  4096,  5461,  8192,    10000, 12288, 16320,  16384, 16385,
                      16448, 20000, 32704, 32768, 32832, 65536, 1 << 20, -64,   -8192, -16384, -32768})
                    for (int round = 0; round < 6; ++round) {
                        for (int block = 0; block < kBlocks; ++block) {
                            const int grid = random.one_of({1, 64, 128, 256});  // of quarters, halves and wholes
                            const int away = random.chance(50) ? 256 * kWidth * random.from(-3, 3) : 0;
                            const int from = away + grid * random.from(-600 / grid, 256 * kWidth / grid);
                            const int v    = grid * random.from(-600 / grid, 256 * (kHeight + 2) / grid);
                            bench.set_row(block, 256 * from, 4 * step, v);
                            for (int lane = 0; lane < kBlockWidth; ++lane)
                                bench.want()[block * kBlockWidth + lane] =
                                    filter_formula::sampled(sampler, from + exact::floor_quotient(step * lane, 64), v);
                        }
                        bench.run_rows(kBlocks, true);
                    }
                batches += bench.batches();
            }
    CHECK(batches > 0);
}

TEST_CASE("two mip levels are mixed exactly: every pair of bytes at every fraction", "[raster][exhaustive]") {
    const FilterRule rule = GENERATE(from_range(kRules));
    std::uint32_t near = 0, far = 0;
    SampleBench bench({.levels = {{&near, 1, 1, 1}, {&far, 1, 1, 1}},
                       .linear = GENERATE(false, true),
                       .rule   = rule,
                       .mip    = MipFilter::Linear});
    for (int lane = 0; lane < kLanes; ++lane) bench.points().lod[lane] = lane;
    int counter = 0;
    for (const int a : simd_kernels::swept_bytes())
        for (int b = 0; b < 256; b += 4 * simd_kernels::kStride) {  // four values in the four channels
            const Pixel first{{a, (a + 64) & 255, (a + 128) & 255, (a + 192) & 255}}, second{{b, b + 1, b + 2, b + 3}};
            near = first.argb();
            far  = second.argb();
            for (int f = 0; f < kLanes; ++f) {
                Pixel want;
                for (int c = 0; c < 4; ++c) want.c[c] = filter_formula::mixed_levels(rule, first.c[c], second.c[c], f);
                bench.want()[f] = want.argb();
            }
            bench.run_points(kBlocks, ++counter % 29 == 0 || is_edge(a));
        }
    CHECK(bench.batches() > 0);
}

TEST_CASE("a level of detail chooses its levels, up to the last", "[raster][exhaustive]") {
    const FilterRule rule = GENERATE(from_range(kRules));
    const MipFilter mip   = GENERATE(MipFilter::None, MipFilter::Point, MipFilter::Linear);
    // Levels of 8 to 1 texels, of one colour each.
    static constexpr std::array<std::uint32_t, 4> kColors{0x00ff1080, 0xff007f11, 0x1280fe00, 0xfe01ff77};
    std::array<std::array<std::uint32_t, 64>, 4> texels{};
    const Address address = GENERATE(Address::Wrap, Address::Clamp);
    Sampler sampler{
        .linear = GENERATE(false, true), .rule = rule, .mip = mip, .address_u = address, .address_v = address};
    for (int i = 0; i < 4; ++i) {
        texels[i].fill(kColors[i]);
        sampler.levels.push_back({texels[i].data(), 8 >> i, 8 >> i, 8 >> i});
    }
    SampleBench bench(sampler);
    test_support::Random random(9);
    for (int first = 0; first <= 768; first += 64)
        for (const bool ordered : {true, false}) {
            for (int lane = 0; lane < kLanes; ++lane) {
                const int lod            = std::min(768, ordered ? first + lane : random.from(0, 768));
                bench.points().u[lane]   = random.from(-5000, 5000);
                bench.points().v[lane]   = random.from(-5000, 5000);
                bench.points().lod[lane] = lod;
                const int near           = mip == MipFilter::None    ? 0
                                           : mip == MipFilter::Point ? exact::floor_quotient(lod + 128, 256)
                                                                     : exact::floor_quotient(lod, 256);
                const Pixel a = Pixel::of(kColors[near]), b = Pixel::of(kColors[std::min(near + 1, 3)]);
                Pixel want = a;
                if (mip == MipFilter::Linear)
                    for (int c = 0; c < 4; ++c)
                        want.c[c] = filter_formula::mixed_levels(rule, a.c[c], b.c[c], lod - 256 * near);
                bench.want()[lane] = want.argb();
            }
            bench.run_points(kBlocks, true);
        }
}

TEST_CASE("samplers of the special programs are among those read", "[raster]") {
    const std::uint32_t texel = 0;
    for (const FillProgram& program : special_parts::kPrograms)
        for (const TextureProgram& texture : program.textures) {
            if (!texture.has_texels) continue;
            const TextureLevel level{&texel, 1, 1, 1};
            const std::vector<TextureLevel> levels{level, level};
            CHECK(SampleBench({.levels      = levels,
                               .alpha_quads = texture.alpha_quads ? levels : std::vector<TextureLevel>(),
                               .linear      = texture.linear,
                               .rule        = texture.rule,
                               .mip         = texture.mip,
                               .address_u   = texture.address_u,
                               .address_v   = texture.address_v})
                      .has_special_kernels());
        }
}
