// SPDX-License-Identifier: MIT
// No pass of a built-in scene, in either mode of its clouds, may fall back to the kernel for all states.
#include <catch2/catch.hpp>
#include <string>

#include "demo/embedded_texts.h"
#include "demo/scene.h"
#include "demo/scene_build.h"
#include "demo/scene_file.h"
#include "pipeline/execute/execute.h"

namespace {

void check_kernels(const demo::Scene& scene) {
    const pipeline::Frame frame         = demo::scene_frame(scene, {320, 180}, 0);
    const pipeline::Execution execution = pipeline::execute(frame);
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        INFO(frame.passes[i].label);
        CHECK(execution.kernels[i].special == execution.counts[i].covered);
        CHECK(execution.kernels[i].general == 0);
    }
}

}  // namespace

TEST_CASE("every pass of the built-in scenes has a kernel of its own", "[scene]") {
    const std::string best = pipeline::simd_targets().front();
    if (best == "SCALAR") return;  // which has none, see raster/special_triangles.cpp
    for (const demo::EmbeddedText& text : demo::embedded_scenes()) {
        const std::string name(text.name);
        INFO(name);
        for (const cloud::Mode mode : {cloud::Mode::Skirt, cloud::Mode::Article}) {
            demo::SceneDescription description = demo::parse_scene(text.text, name, name);
            for (demo::CloudPlan& plan : description.clouds) plan.settings.mode = mode;
            check_kernels(demo::build_scene(std::move(description)));
        }
    }
}
