// SPDX-License-Identifier: MIT
// Which passes are filled together, as text; and that drawing them so changes nothing, which frame_agreement.h compares
// for random frames.
#include "pipeline/execute/schedule.h"

#include <catch2/catch.hpp>

#include "pipeline/execute/execute.h"
#include "tests/support/random_frame.h"

using namespace pipeline;

namespace {

constexpr TargetId kScene{0}, kDepth{1}, kCloud{2}, kSmall{3}, kOtherDepth{4};

struct Passes {
    Frame frame;

    Passes() {
        frame.targets = {{"scene", TargetFormat::A8R8G8B8, 64, 32},
                         {"depth", TargetFormat::D24, 64, 32},
                         {"cloud", TargetFormat::A8R8G8B8, 64, 32},
                         {"small", TargetFormat::A8R8G8B8, 32, 16},
                         {"other depth", TargetFormat::D16, 32, 16}};
    }
    Pass& add(TargetId color, TargetId depth = {}) {
        Pass& pass = frame.passes.emplace_back();
        pass.color = color;
        pass.depth = depth;
        return pass;
    }
    void add_reader(TargetId color, TargetId read, TargetId depth = {}) {
        DrawRectangle blit;
        blit.textures[1].target = read;
        add(color, depth).draws = {blit};
    }
    void add_copy(TargetId color, TargetId source) {
        add(color).draws = {CopyRectangle{.source = source, .from = {0, 0, 8, 8}}};
    }
    std::string scheduled(bool one_by_one = false) const { return to_text(schedule_passes(frame, one_by_one)); }
};

}  // namespace

TEST_CASE("passes to the same targets are one group", "[schedule]") {
    Passes passes;
    CHECK(passes.scheduled() == "");
    for (int i = 0; i < 3; ++i) passes.add(kScene, kDepth);
    CHECK(passes.scheduled() == "0-2: color 0 depth 1\n");
    CHECK(passes.scheduled(true) == "0: color 0 depth 1\n1: color 0 depth 1\n2: color 0 depth 1\n");
}

TEST_CASE("another colour or depth target begins a group", "[schedule]") {
    Passes passes;
    passes.add(kScene, kDepth);
    passes.add(kCloud, kDepth);
    passes.add(kSmall, kOtherDepth);
    passes.add(kSmall, kOtherDepth);
    passes.add(kScene, kDepth);
    CHECK(passes.scheduled() == "0: color 0 depth 1\n1: color 2 depth 1\n2-3: color 3 depth 4\n4: color 0 depth 1\n");
}

TEST_CASE("a pass without one of the targets joins, if sizes fit", "[schedule]") {
    Passes passes;
    passes.add(kScene);
    passes.add({}, kDepth);
    passes.add(kScene, kDepth);
    passes.add({}, kOtherDepth);
    passes.add(kSmall);
    passes.add({}, kDepth);
    CHECK(passes.scheduled() == "0-2: color 0 depth 1\n3-4: color 3 depth 4\n5: depth 1\n");
}

TEST_CASE("what is read as a texture must be finished", "[schedule]") {
    Passes passes;
    passes.add(kScene, kDepth);
    passes.add_reader(kScene, kCloud);              // not drawn to here
    passes.add_reader(TargetId{}, kScene, kDepth);  // drawn to by the group
    passes.add_reader(kCloud, kScene);
    CHECK(passes.scheduled() == "0-1: color 0 depth 1\n2-3: color 2 depth 1\n");
}

TEST_CASE("copies stand alone", "[schedule]") {
    Passes passes;
    passes.add(kScene);
    passes.add_copy(kScene, kCloud);
    passes.add_copy(kScene, kCloud);
    passes.add(kScene);
    CHECK(passes.scheduled() == "0: color 0\n1: copies to color 0\n2: copies to color 0\n3: color 0\n");
}

TEST_CASE("an executor that has drawn other frames draws as a new one", "[schedule][execute]") {
    Executor executor;
    Execution reused;
    std::size_t groups = 0, passes = 0;
    for (std::uint32_t seed = 5000; seed < 5200; ++seed) {
        INFO("seed " << seed);
        const Frame frame = test_support::random_frame(seed);
        groups += schedule_passes(frame).size();
        passes += frame.passes.size();
        const ExecuteOptions options{.threads = static_cast<int>(seed % 3) + 1};
        const Execution fresh = execute(frame, options);
        executor.execute(frame, reused, options);
        CHECK(reused.output == fresh.output);
        CHECK(reused.counts == fresh.counts);
        // The same once more: textures and targets are as the last frame left them.
        executor.execute(frame, reused, options);
        CHECK(reused.output == fresh.output);
        if (seed % 4 == 0) CHECK(execute(frame, {.backend = Backend::Reference}).output == fresh.output);
    }
    CHECK(groups < passes);  // some do share
}
