// SPDX-License-Identifier: MIT
// The kernels against the scalar reference, on random frames: every instruction set, several thread counts, shuffled tiles.
#include <array>
#include <catch2/catch.hpp>
#include <utility>

#include "pipeline/execute/execute.h"
#include "pipeline/frame/frame_text.h"
#include "tests/support/random_frame.h"
#include "tests/support/simd_targets.h"

namespace {

using namespace pipeline;

struct Drawn {
    Execution execution;
    std::vector<ColorImage> passes;  // the colour target after each pass
};

Drawn draw(const Frame& frame, const ExecuteOptions& options) {
    Drawn drawn;
    drawn.execution =
        execute(frame, options, [&](const FinishedPass& pass) { drawn.passes.push_back(pass.read_color()); });
    return drawn;
}

// The first thing that differs, or nothing.
std::string difference(const Drawn& got, const Drawn& want) {
    for (std::size_t i = 0; i < want.passes.size(); ++i) {
        const ColorImage &a = got.passes[i], &b = want.passes[i];
        for (std::size_t p = 0; p < b.pixels.size(); ++p)
            if (a.pixels[p] != b.pixels[p]) {
                char text[160];
                std::snprintf(text, sizeof text, "pass %zu, pixel (%zu, %zu): %08x, the reference has %08x", i,
                              p % static_cast<std::size_t>(b.width), p / static_cast<std::size_t>(b.width), a.pixels[p],
                              b.pixels[p]);
                return text;
            }
        if (!(got.execution.counts[i] == want.execution.counts[i]))
            return "pass " + std::to_string(i) + ": counts differ";
    }
    return got.execution.output == want.execution.output ? "" : "the output differs";
}

void compare_seeds(std::uint32_t first, std::uint32_t end) {
    static constexpr std::array<int, 4> kThreads{1, 2, 3, 7};
    std::uint64_t covered = 0;
    for (std::uint32_t seed = first; seed < end; ++seed) {
        const Frame frame = test_support::random_frame(seed);
        const Drawn want  = draw(frame, {.backend = Backend::Reference, .threads = 1, .tile_order_seed = 0});
        for (const PassCounts& counts : want.execution.counts) covered += counts.covered;
        std::size_t run = seed;
        test_support::for_each_simd_target([&] {
            const ExecuteOptions options{.threads = kThreads[run++ % kThreads.size()], .tile_order_seed = seed + 1};
            const std::string different = difference(draw(frame, options), want);
            INFO("seed " << seed << ", " << options.threads << " threads");
            if (!different.empty()) FAIL(different);
        });
    }
    CHECK(covered > 500 * (end - first));  // the frames do draw something
}

}  // namespace

// Four cases, so that they can run side by side.
TEST_CASE("kernels and reference agree on random frames, 0 to 499", "[agreement]") {
    compare_seeds(0, 500);
}
TEST_CASE("kernels and reference agree on random frames, 500 to 999", "[agreement]") {
    compare_seeds(500, 1000);
}
TEST_CASE("kernels and reference agree on random frames, 1000 to 1499", "[agreement]") {
    compare_seeds(1000, 1500);
}
TEST_CASE("kernels and reference agree on random frames, 1500 to 1999", "[agreement]") {
    compare_seeds(1500, 2000);
}
