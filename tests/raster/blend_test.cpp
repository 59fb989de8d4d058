// SPDX-License-Identifier: MIT
// The blend kernels against the rule in exact integers, on every instruction set.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <vector>

#include "raster/blend_blocks.h"
#include "tests/support/simd_targets.h"

namespace {

using raster::BlendConstants;
using raster::BlendFactor;

struct Pixel {
    std::array<int, 4> c;  // blue, green, red, alpha
    std::uint32_t argb() const {
        return static_cast<std::uint32_t>(c[0] | c[1] << 8 | c[2] << 16) | static_cast<std::uint32_t>(c[3]) << 24;
    }
};

int factor_value(const BlendFactor& factor, const Pixel& source, const Pixel& dest, int channel) {
    const int from = factor.alpha ? 3 : channel;
    int value      = 0;
    if (factor.operand == BlendFactor::Operand::Source) value = source.c[from];
    if (factor.operand == BlendFactor::Operand::Dest) value = dest.c[from];
    return factor.invert ? 255 - value : value;
}

std::uint32_t expected(const BlendConstants& constants, const Pixel& source, const Pixel& dest) {
    Pixel out{};
    for (int i = 0; i < 4; ++i) {
        const int sum = source.c[i] * factor_value(constants.source, source, dest, i) +
                        dest.c[i] * factor_value(constants.dest, source, dest, i);
        out.c[i] = std::min(255, (2 * sum + 255) / 510);  // nearest; sum / 255 is never half-way between two integers
    }
    return (out.argb() & constants.write_mask) | (dest.argb() & ~constants.write_mask);
}

// Blends batches of pixels and counts those that differ from the rule; remembers the first.
class Checker {
  public:
    Checker(const BlendConstants& constants, bool generic)
        : constants_(constants), kernel_(raster::blend_kernel(constants, generic)), target_(kWidth, 1) {
        for (int block = 0; block < raster::kBatchBlocks; ++block) batch_->at[block] = {block * raster::kBlockWidth, 0};
        std::fill_n(batch_->mask.lanes, kWidth, 0xffffffff);
        batch_->count = raster::kBatchBlocks;
    }
    ~Checker() { flush(); }
    void add(const Pixel& source, const Pixel& dest) {
        batch_->color.lanes[used_] = source.argb();
        target_.row(0)[used_]      = dest.argb();
        wanted_[used_]             = expected(constants_, source, dest);
        if (++used_ == kWidth) flush();
    }
    void flush() {
        kernel_(constants_, target_, *batch_);
        std::size_t different = 0;
        for (int i = 0; i < used_; ++i) different += target_.row(0)[i] != wanted_[i];
        used_ = 0;
        CHECK(different == 0);
    }

  private:
    static constexpr int kWidth = raster::kBatchBlocks * raster::kBlockWidth;
    BlendConstants constants_;
    raster::BlendKernel kernel_;
    raster::Image target_;
    std::unique_ptr<raster::FragmentBatch> batch_ = std::make_unique<raster::FragmentBatch>();
    std::array<std::uint32_t, kWidth> wanted_{};
    int used_ = 0;
};

std::vector<BlendFactor> all_factors() {
    using enum BlendFactor::Operand;
    return {raster::kZero,         raster::kOne,         {Source, false, false}, {Source, false, true},
            {Source, true, false}, {Source, true, true}, {Dest, false, false},   {Dest, false, true},
            {Dest, true, false},   {Dest, true, true}};
}

}  // namespace

TEST_CASE("SRCALPHA, INVSRCALPHA is exact for every source, destination and alpha byte", "[raster][exhaustive]") {
    using enum BlendFactor::Operand;
    const bool generic = GENERATE(false, true);
    test_support::for_each_simd_target([&] {
        Checker checker({{Source, true, false}, {Source, true, true}, 0xffffffff}, generic);
        for (int alpha = 0; alpha < 256; ++alpha)
            for (int dest = 0; dest < 256; ++dest)
                for (int source = 0; source < 256; source += 3)  // three sources in the three channels
                    checker.add({{source, std::min(source + 1, 255), std::min(source + 2, 255), alpha}},
                                {{dest, dest, dest, 255 - dest}});
    });
}

TEST_CASE("ZERO, SRCCOLOR is exact for every pair of bytes in every channel", "[raster][exhaustive]") {
    using enum BlendFactor::Operand;
    const bool generic = GENERATE(false, true);
    test_support::for_each_simd_target([&] {
        Checker checker({raster::kZero, {Source, false, false}, 0xffffffff}, generic);
        for (int dest = 0; dest < 256; ++dest)
            for (int source = 0; source < 256; ++source)
                checker.add({{source, dest, source, dest}}, {{dest, source, dest, source}});
    });
}

TEST_CASE("every pair of factors is exact for every pair of bytes at several alphas", "[raster][exhaustive]") {
    static constexpr std::array<std::array<int, 2>, 4> kAlphas{{{0, 255}, {255, 0}, {101, 254}, {128, 127}}};
    test_support::for_each_simd_target([&] {
        for (const BlendFactor& source_factor : all_factors())
            for (const BlendFactor& dest_factor : all_factors()) {
                Checker checker({source_factor, dest_factor, 0xffffffff}, false);
                for (const auto& [source_alpha, dest_alpha] : kAlphas)
                    for (int dest = 0; dest < 256; dest += 3)
                        for (int source = 0; source < 256; ++source)
                            checker.add({{source, 255 - source, source, source_alpha}},
                                        {{dest, std::min(dest + 1, 255), std::min(dest + 2, 255), dest_alpha}});
            }
    });
}

TEST_CASE("only the channels of the write mask change, and only where the fragment mask is set", "[raster]") {
    test_support::for_each_simd_target([&] {
        for (int bits = 0; bits < 16; ++bits) {
            std::uint32_t mask = 0;
            for (int channel = 0; channel < 4; ++channel)
                if (bits >> channel & 1) mask |= 0xffu << 8 * channel;
            Checker checker({raster::kOne, raster::kOne, mask}, false);
            for (int i = 0; i < 256; ++i) checker.add({{i, 7, 255 - i, i / 2}}, {{3, i, 200, 255 - i}});
        }
        raster::Image target(64, 1);
        auto batch   = std::make_unique<raster::FragmentBatch>();
        batch->count = 1;
        batch->at[0] = {16, 0};
        std::fill_n(batch->color[0], 16, 0x01020304u);
        batch->mask[0][5] = 0xffffffff;
        const BlendConstants replace{raster::kOne, raster::kZero, 0xffffffff};
        raster::blend_kernel(replace)(replace, target, *batch);
        for (int x = 0; x < 64; ++x) CHECK(target.row(0)[x] == (x == 21 ? 0x01020304u : 0u));
    });
}
