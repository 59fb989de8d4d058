// SPDX-License-Identifier: MIT
// The kernels against the scalar reference, on random frames: every instruction set, several thread counts, shuffled
// tiles.
#include <catch2/catch.hpp>

#include "tests/support/frame_agreement.h"
#include "tests/support/random_frame.h"

namespace {

using namespace test_support;

void compare_seeds(std::uint32_t first, std::uint32_t end) {
    std::uint64_t covered = 0;
    for (std::uint32_t seed = first; seed < end; ++seed) {
        INFO("seed " << seed);
        const pipeline::Frame frame = random_frame(seed);
        const Drawn want            = draw_reference(frame);
        for (const pipeline::PassCounts& counts : want.execution.counts) covered += counts.covered;
        check_kernels(frame, want, seed, 1);
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
