// SPDX-License-Identifier: MIT
#include "tests/support/frame_agreement.h"

#include <catch2/catch.hpp>
#include <cstdio>

#include "tests/support/simd_targets.h"

namespace test_support {

using namespace pipeline;

Drawn draw(Executor& executor, const Frame& frame, const ExecuteOptions& options) {
    Drawn drawn;
    drawn.execution =
        executor.execute(frame, options, [&](const FinishedPass& pass) { drawn.passes.push_back(pass.read_color()); });
    return drawn;
}

Drawn draw(const Frame& frame, const ExecuteOptions& options) {
    Executor executor;
    return draw(executor, frame, options);
}

Drawn draw_reference(const Frame& frame) {
    return draw(frame, {.backend = Backend::Reference, .threads = 1, .tile_order_seed = 0});
}

std::string difference(const Drawn& got, const Drawn& want) {
    if (got.passes.size() != want.passes.size() || got.execution.counts.size() != want.execution.counts.size())
        return "the number of passes differs";
    for (std::size_t i = 0; i < want.passes.size(); ++i) {
        const ColorImage &a = got.passes[i], &b = want.passes[i];
        if (a.width != b.width || a.height != b.height) return "pass " + std::to_string(i) + ": sizes differ";
        for (std::size_t p = 0; p < b.pixels.size(); ++p)
            if (a.pixels[p] != b.pixels[p]) {
                char text[160];
                std::snprintf(text, sizeof text, "pass %zu, pixel (%zu, %zu): %08x instead of %08x", i,
                              p % static_cast<std::size_t>(b.width), p / static_cast<std::size_t>(b.width), a.pixels[p],
                              b.pixels[p]);
                return text;
            }
        if (!(got.execution.counts[i] == want.execution.counts[i]))
            return "pass " + std::to_string(i) + ": counts differ";
    }
    return got.execution.output == want.execution.output ? "" : "the output differs";
}

void check_kernels(const Frame& frame, const Drawn& want, std::uint32_t seed, std::size_t runs) {
    std::size_t turn = seed;
    for_each_simd_target([&] {
        for (std::size_t run = 0; run < runs; ++run) {
            const ExecuteOptions options{.threads         = kThreadCounts[turn++ % kThreadCounts.size()],
                                         .tile_order_seed = seed + static_cast<std::uint32_t>(run) + 1};
            const std::string different = difference(draw(frame, options), want);
            INFO(options.threads << " threads, tiles in order " << options.tile_order_seed);
            if (!different.empty()) FAIL(different);
            // Without an observer passes are drawn in groups.
            const Execution grouped = execute(frame, options);
            if (!(grouped.counts == want.execution.counts)) FAIL("counts differ in groups of passes");
            if (!(grouped.output == want.execution.output)) FAIL("the output differs in groups of passes");
        }
    });
}

}  // namespace test_support
