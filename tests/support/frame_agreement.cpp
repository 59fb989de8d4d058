// SPDX-License-Identifier: MIT
#include "tests/support/frame_agreement.h"

#include <catch2/catch.hpp>

#include "tests/support/simd_targets.h"

namespace test_support {

using namespace pipeline;

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
            ExecuteOptions without_counts   = options;
            without_counts.counts_fragments = false;
            if (!(execute(frame, without_counts).output == want.execution.output))
                FAIL("the output differs where fragments are not counted");
            ExecuteOptions counts_only = options;
            counts_only.counts_only    = true;
            const Execution counted    = execute(frame, counts_only);
            if (!(counted.counts == want.execution.counts)) FAIL("counts differ where nothing else is asked for");
            if (!(counted.output == ColorImage{})) FAIL("there is an output where only counts are asked for");
        }
    });
}

}  // namespace test_support
