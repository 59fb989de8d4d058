// SPDX-License-Identifier: MIT
// What does not need a test to run in: the fuzzers have none.
#include <cstdio>

#include "tests/support/frame_agreement.h"

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

}  // namespace test_support
