// SPDX-License-Identifier: MIT
#include "tests/fuzz/agreement.h"

#include <string>

#include "pipeline/validate/validate.h"
#include "pipeline/validate/work.h"
#include "tests/fuzz/fuzz.h"
#include "tests/support/frame_agreement.h"

namespace fuzz {

using namespace pipeline;
using namespace test_support;

namespace {

// The reference takes some 100 ns for a pixel, more under sanitizers; a second is too long for one input.
constexpr std::uint64_t kMostPixels = 1 << 18, kMostTriangles = 1 << 12, kMostBytes = 1 << 24;

}  // namespace

bool require_agreement(const Frame& frame, std::uint32_t seed) {
    if (!validate(frame).empty()) return false;
    const Work work = work_of(frame);
    if (work.pixels > kMostPixels || work.triangles > kMostTriangles || work.bytes > kMostBytes) return false;

    const Drawn want                              = draw_reference(frame);
    static const std::vector<std::string> targets = simd_targets();
    for (std::size_t i = 0; i < targets.size(); ++i) {
        force_simd_target(targets[i]);
        ExecuteOptions options{.threads = 1 + static_cast<int>((seed + i) % 3), .tile_order_seed = seed};
        const std::string how       = targets[i] + ", seed " + std::to_string(seed) + ": ";
        const std::string different = difference(draw(frame, options), want);
        require(different.empty(), how + different);
        options.threads         = 1 + options.threads % 3;
        const Execution grouped = execute(frame, options);  // not observed, passes are drawn in groups
        require(grouped.counts == want.execution.counts, how + "counts differ in groups of passes");
        require(grouped.output == want.execution.output, how + "the output differs in groups of passes");
        options.threads          = 1 + options.threads % 3;
        options.counts_fragments = false;  // leaves out what is hidden
        require(execute(frame, options).output == want.execution.output, how + "the output differs without counts");
        options.counts_fragments = true;
        options.counts_only      = true;
        require(execute(frame, options).counts == want.execution.counts, how + "counts differ without the output");
    }
    return true;
}

}  // namespace fuzz
