// SPDX-License-Identifier: MIT
// The texture stage, specular and fog kernels against their rules in exact integers, for every pair of bytes, on every
// instruction set.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <memory>

#include "raster/combine_blocks.h"
#include "tests/support/simd_targets.h"

namespace {

using namespace raster;

constexpr int kLanes = kBatchBlocks * kBlockWidth;
static_assert(kLanes == 256, "one batch holds all values of a byte");

int nearest255(int v) {
    return (2 * v + 255) / 510;
}

int expected(CombineOp op, int a, int b) {
    switch (op) {
        case CombineOp::Select:
            return a;
        case CombineOp::Modulate:
            return nearest255(a * b);
        case CombineOp::Modulate2X:
            return std::min(255, nearest255(2 * a * b));
        case CombineOp::Modulate4X:
            return std::min(255, nearest255(4 * a * b));
        case CombineOp::Add:
            return std::min(255, a + b);
        case CombineOp::AddSigned:
            return std::clamp(a + b - 127, 0, 255);
        case CombineOp::AddSigned2X:
            return std::clamp(2 * a + 2 * b - 255, 0, 255);
        case CombineOp::Subtract:
            return std::max(0, a - b);
    }
    return -1;
}

std::uint32_t argb(int a, int r, int g, int b) {
    return static_cast<std::uint32_t>(a) << 24 | static_cast<std::uint32_t>(r << 16 | g << 8 | b);
}

// Lane i: the texel has i in red and alpha, 255 - i in green and blue.
std::unique_ptr<FragmentBatch> batch_of_all_bytes() {
    auto batch   = std::make_unique<FragmentBatch>();
    batch->count = kBatchBlocks;
    for (int i = 0; i < kLanes; ++i) batch->texel[0].lanes[i] = argb(i, i, 255 - i, 255 - i);
    return batch;
}

// How many lanes of `got` are not what `want` says.
template <class Want>
int count_wrong(const BlockRows<std::uint32_t>& got, Want&& want) {
    int wrong = 0;
    for (int i = 0; i < kLanes; ++i) wrong += got.lanes[i] != want(i);
    return wrong;
}

}  // namespace

TEST_CASE("every combine operation is exact for every pair of bytes, in colour and in alpha", "[raster][exhaustive]") {
    const CombineArg texel{.source = CombineArg::Source::Texel}, diffuse{.source = CombineArg::Source::Diffuse};
    test_support::for_each_simd_target([&] {
        const auto batch = batch_of_all_bytes();
        for (int color_op = 0; color_op < 8; ++color_op)
            for (const int alpha_op : {color_op, 7 - color_op}) {  // the same, and another
                const CombineStage stage{.color = {static_cast<CombineOp>(color_op), texel, diffuse},
                                         .alpha = {static_cast<CombineOp>(alpha_op), texel, diffuse}};
                for (int b = 0; b < 256; ++b) {
                    std::fill_n(batch->diffuse.lanes, kLanes, argb(b, b, b, 255 - b));
                    combine_kernels().stage(stage, 0, 0, *batch);
                    const auto color = [&](int x, int y) { return expected(stage.color.op, x, y); };
                    CHECK(count_wrong(batch->color, [&](int i) {
                              return argb(expected(stage.alpha.op, i, b), color(i, b), color(255 - i, b),
                                          color(255 - i, 255 - b));
                          }) == 0);
                }
            }
    });
}

TEST_CASE("complement and alpha replicate change what an operation reads", "[raster]") {
    test_support::for_each_simd_target([&] {
        const auto batch = batch_of_all_bytes();
        std::fill_n(batch->diffuse.lanes, kLanes, argb(10, 20, 30, 40));
        std::fill_n(batch->specular.lanes, kLanes, argb(1, 2, 3, 4));
        const auto read = [&](CombineArg arg) {
            const Combine select{CombineOp::Select, arg, arg};
            combine_kernels().stage({select, select}, 0, 0xa0b0c0d0, *batch);
        };
        using Source = CombineArg::Source;
        read({Source::Texel, true, false});
        CHECK(count_wrong(batch->color, [](int i) { return argb(255 - i, 255 - i, i, i); }) == 0);
        read({Source::Texel, false, true});
        CHECK(count_wrong(batch->color, [](int i) { return argb(i, i, i, i); }) == 0);
        read({Source::Texel, true, true});
        CHECK(count_wrong(batch->color, [](int i) { return argb(255 - i, 255 - i, 255 - i, 255 - i); }) == 0);
        read({Source::Current, false, false});  // diffuse, in stage 0
        CHECK(count_wrong(batch->color, [](int) { return argb(10, 20, 30, 40); }) == 0);
        read({Source::Constant, false, false});
        CHECK(count_wrong(batch->color, [](int) { return 0xa0b0c0d0u; }) == 0);
        read({Source::Specular, false, false});  // its alpha is the fog factor, and reads as 255
        CHECK(count_wrong(batch->color, [](int) { return argb(255, 2, 3, 4); }) == 0);
    });
}

TEST_CASE("specular and fog are exact for every pair of bytes and leave alpha alone", "[raster][exhaustive]") {
    test_support::for_each_simd_target([&] {
        const auto batch = batch_of_all_bytes();
        for (int b = 0; b < 256; ++b) {
            const auto restart = [&] { std::copy_n(batch->texel[0].lanes, kLanes, batch->color.lanes); };
            std::fill_n(batch->specular.lanes, kLanes, argb(b, b, 255 - b, b));
            restart();
            combine_kernels().add_specular(*batch);
            CHECK(count_wrong(batch->color, [&](int i) {
                      return argb(i, std::min(255, i + b), std::min(255, 255 - i + 255 - b),
                                  std::min(255, 255 - i + b));
                  }) == 0);
            restart();
            combine_kernels().fog(argb(99, 200, 0, 255), *batch);
            const auto mix = [&](int color, int fog) { return nearest255(b * color + (255 - b) * fog); };
            CHECK(count_wrong(batch->color,
                              [&](int i) { return argb(i, mix(i, 200), mix(255 - i, 0), mix(255 - i, 255)); }) == 0);
        }
    });
}
