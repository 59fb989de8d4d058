// SPDX-License-Identifier: MIT
// The field's clouds share passes, and are the same clouds.
#include <catch2/catch.hpp>

#include "demo/scene.h"
#include "pipeline/execute/execute.h"

namespace {

struct Drawn {
    pipeline::ColorImage picture;
    std::uint64_t blended = 0, texels = 0, bytes = 0;
    std::size_t passes = 0;
};
Drawn draw(const demo::Scene& scene, int index, bool shares_passes) {
    demo::FrameOptions options;
    options.mega_particles.passes       = shares_passes ? cloud::Passes::Shared : cloud::Passes::OneByOne;
    const pipeline::Frame frame         = demo::scene_frame(scene, {400, 225}, index, options);
    const pipeline::Execution execution = pipeline::execute(frame);
    Drawn drawn{.picture = execution.output, .passes = frame.passes.size()};
    for (const pipeline::PassCounts& counts : execution.counts) {
        drawn.blended += counts.blended;
        drawn.texels += counts.texels;
        drawn.bytes += counts.bytes;
    }
    return drawn;
}

}  // namespace

TEST_CASE("the field is the same with shared passes, all along its flight, in fewer passes", "[scene][share]") {
    const demo::ScenePtr scene = demo::load_scene("field");
    for (const int index : {0, 13, 29, 44, 60, 75, 89}) {
        const Drawn one_by_one = draw(*scene, index, false), shared = draw(*scene, index, true);
        INFO("frame " << index << ": " << one_by_one.passes << " passes, shared " << shared.passes);
        CHECK((shared.picture.pixels == one_by_one.picture.pixels));
        CHECK(shared.blended == one_by_one.blended);
        CHECK(shared.texels == one_by_one.texels);
        CHECK(shared.bytes == one_by_one.bytes);
        CHECK(shared.passes < one_by_one.passes);
        if (index == 0) CHECK(2 * shared.passes <= one_by_one.passes);
    }
}

TEST_CASE("a scene of one cloud is drawn in the passes it had", "[scene][share]") {
    demo::FrameOptions one_by_one;
    one_by_one.mega_particles.passes = cloud::Passes::OneByOne;
    const demo::ScenePtr scene       = demo::load_scene("canyon");
    CHECK(demo::scene_frame(*scene, {160, 90}, 0) == demo::scene_frame(*scene, {160, 90}, 0, one_by_one));
}
