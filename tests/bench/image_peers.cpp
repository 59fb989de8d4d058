// SPDX-License-Identifier: MIT
// Libraries of pixel loops on one thread, at what they share with a frame's passes: the mean of 2x2 pixels, and
// layering one picture over another. libyuv's and pixman's layers have colours that are multiplied by alpha already,
// ours have not, which is a product more for each channel. Pictures are small enough for the L2 cache. limit/*: what
// copying and setting such buffers takes.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <cstring>
#include <vector>

#ifdef NIMBUS7_BENCH_LIBYUV
#include <libyuv.h>
#endif
#ifdef NIMBUS7_BENCH_PIXMAN
#include <pixman.h>
#endif

#include "tests/bench/benchmarks.h"
#include "tests/bench/frames.h"

namespace bench {

namespace {

constexpr int kWidth = kImageWidth, kHeight = kImageHeight, kRowBytes = 4 * kWidth;
constexpr double kPixels = double{kImageRounds} * kWidth * kHeight;

struct Pictures {
    std::vector<std::uint32_t> source, target;

    // Half of the source's pixels are translucent, the rest clear or opaque; colours are at most alpha.
    Pictures() : source(static_cast<std::size_t>(kWidth) * kHeight), target(source.size(), 0xff406080) {
        for (std::size_t i = 0; i < source.size(); ++i) {
            const auto random         = static_cast<std::uint32_t>(i) * 2654435761u;
            const std::uint32_t alpha = (random >> 24 & 1) == 0 ? random >> 16 & 255 : (random >> 25 & 1) * 255;
            source[i]                 = alpha << 24 | (alpha / 2) << 16 | (alpha / 3) << 8 | alpha;
        }
    }
};

template <class Work>
void add(const char* name, Work&& work) {
    benchmark::RegisterBenchmark(name,
                                 [work](benchmark::State& state) {
                                     Pictures pictures;
                                     for ([[maybe_unused]] auto _ : state) {
                                         for (int round = 0; round < kImageRounds; ++round) work(pictures);
                                         benchmark::ClobberMemory();
                                     }
                                     state.counters["pixels_per_second"] =
                                         benchmark::Counter(kPixels, benchmark::Counter::kIsIterationInvariantRate);
                                 })
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
}

[[maybe_unused]] void add_missing(const char* name, const char* why) {
    benchmark::RegisterBenchmark(name, [why](benchmark::State& state) { state.SkipWithError(why); });
}

#ifdef NIMBUS7_BENCH_LIBYUV
std::uint8_t* bytes(std::vector<std::uint32_t>& pixels) {
    return reinterpret_cast<std::uint8_t*>(pixels.data());
}

void halve_with_libyuv(Pictures& p) {
    libyuv::ARGBScale(bytes(p.source), kRowBytes, kWidth, kHeight, bytes(p.target), kRowBytes / 2, kWidth / 2,
                      kHeight / 2, libyuv::kFilterBox);
}

void blend_with_libyuv(Pictures& p) {
    libyuv::ARGBBlend(bytes(p.source), kRowBytes, bytes(p.target), kRowBytes, bytes(p.target), kRowBytes, kWidth,
                      kHeight);
}
#endif

#ifdef NIMBUS7_BENCH_PIXMAN
void blend_with_pixman(Pictures& p) {
    pixman_image_t* source = pixman_image_create_bits(PIXMAN_a8r8g8b8, kWidth, kHeight, p.source.data(), kRowBytes);
    pixman_image_t* target = pixman_image_create_bits(PIXMAN_a8r8g8b8, kWidth, kHeight, p.target.data(), kRowBytes);
    pixman_image_composite32(PIXMAN_OP_OVER, source, nullptr, target, 0, 0, 0, 0, 0, 0, kWidth, kHeight);
    pixman_image_unref(source);
    pixman_image_unref(target);
}
#endif

}  // namespace

void register_image_peers() {
#ifdef NIMBUS7_BENCH_LIBYUV
    add("downsample/box2/libyuv", &halve_with_libyuv);
    add("blend/srcalpha_rows/libyuv", &blend_with_libyuv);
#else
    add_missing("downsample/box2/libyuv", "built without libyuv");
    add_missing("blend/srcalpha_rows/libyuv", "built without libyuv");
#endif
#ifdef NIMBUS7_BENCH_PIXMAN
    add("blend/srcalpha_rows/pixman", &blend_with_pixman);
#else
    add_missing("blend/srcalpha_rows/pixman", "built without pixman");
#endif
    add("limit/memcpy", [](Pictures& p) { std::memcpy(p.target.data(), p.source.data(), 4 * p.source.size()); });
    add("limit/memset", [](Pictures& p) { std::memset(p.target.data(), 0x55, 4 * p.target.size()); });
}

}  // namespace bench
