// SPDX-License-Identifier: MIT
// Whole scenes, from scene file to picture: the kernels against the scalar reference, an executor that has drawn other
// frames against a fresh one, a frame read back from its text against the frame itself. Sizes are odd on purpose.
#include <catch2/catch.hpp>
#include <map>

#include "demo/scene.h"
#include "demo/scene_build.h"
#include "demo/scene_file.h"
#include "pipeline/frame/frame_text.h"
#include "tests/support/frame_agreement.h"
#include "tests/support/random_frame.h"

namespace {

using namespace test_support;
using demo::Size;

// Box, mast and cloud reach into each other; quick to load, since there is no terrain and no texture.
const char* const kArticle = R"(
[camera]
position = [0, 12, 70]
target = [0, 14, 0]
[[solid]]
kind = "box"
from = [6, 0, -6]
to = [14, 30, 6]
color = [0.8, 0.5, 0.3]
[[solid]]
kind = "cylinder"
from = [-8, 0, 30]
to = [-8, 20, 30]
radius = 0.7
front = true
[[cloud]]
mode = "article"
cores = [[0, 14, 0, 8], [-9, 13, 2, 6], [9, 15, 4, 6]]
crown = 5
rim = 20
base_y = 9
blur = 0.9
[cloud.fractal]
size = 32
)";

// The near cloud, which the far one shines through, is the one with opacity.
const char* const kTwoClouds = R"(
[camera]
position = [0, 12, 70]
target = [0, 14, 0]
[camera.orbit]
degrees = 30
frames = 12
[[solid]]
kind = "box"
from = [-30, 0, -40]
to = [30, 12, -30]
color = [0.4, 0.6, 0.3]
[[cloud]]
name = "near"
position = [-6, 0, 14]
cores = [[0, 14, 0, 7], [-7, 13, 2, 5], [8, 13, 1, 5]]
crown = 4
rim = 20
blur = 0.8
opacity = 0.6
[cloud.fractal]
size = 32
noise = "billow"
[[cloud]]
name = "far"
position = [8, 4, -10]
cores = [[0, 14, 0, 9], [-9, 12, 2, 6]]
rim = 20
color = [1, 0.8, 0.7]
blur = 1.2
[cloud.fractal]
size = 32
)";

demo::Scene build(const char* text) {
    return demo::build_scene(demo::parse_scene(text, "test.toml", "test"));
}

// Each once in a run of the test program.
const demo::Scene& article() {
    static const demo::Scene scene = build(kArticle);
    return scene;
}
const demo::Scene& two_clouds() {
    static const demo::Scene scene = build(kTwoClouds);
    return scene;
}
const demo::Scene& canyon() {
    static const demo::ScenePtr scene = demo::load_scene("canyon");
    return *scene;
}

std::uint64_t pixels_drawn(const Drawn& drawn) {
    std::uint64_t sum = 0;
    for (const pipeline::PassCounts& counts : drawn.execution.counts) sum += counts.color_written;
    return sum;
}

// How many pixels of the back buffer each cloud changes, by its name, and how many both of two change ("both").
std::map<std::string, int> pixels_of_clouds(const pipeline::Frame& frame, const Drawn& drawn) {
    std::map<std::string, int> counts;
    std::vector<int> changes(drawn.execution.output.pixels.size());
    const pipeline::ColorImage* picture = nullptr;
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        const pipeline::Pass& pass = frame.passes[i];
        if (pass.color != frame.output) continue;
        const std::size_t colon = pass.label.find(": ");
        if (picture != nullptr && colon != std::string::npos)
            for (std::size_t p = 0; p < changes.size(); ++p)
                if (drawn.passes[i].pixels[p] != picture->pixels[p]) {
                    ++counts[pass.label.substr(0, colon)];
                    if (++changes[p] == 2) ++counts["both"];
                }
        picture = &drawn.passes[i];
    }
    return counts;
}

void check_agreement(const demo::Scene& scene, Size size, int index, std::size_t runs) {
    INFO(size.width << "x" << size.height << ", frame " << index);
    const pipeline::Frame frame = demo::scene_frame(scene, size, index);
    const Drawn want            = draw_reference(frame);
    // The sky alone fills the picture once.
    CHECK(pixels_drawn(want) >
          static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height) * 5 / 4);
    check_kernels(frame, want, static_cast<std::uint32_t>(index), runs);
}

// Other frames before, larger and smaller ones, with more targets and textures and with fewer.
void check_history(const demo::Scene& scene, Size size) {
    const pipeline::Frame frame = demo::scene_frame(scene, size, 0);
    const Drawn want            = draw(frame, {.threads = 1});
    pipeline::Executor executor;
    for (const Size& other : {Size{311, 187}, Size{40, 23}, size}) {
        for (const demo::Scene* before : {&two_clouds(), &article()})
            draw(executor, demo::scene_frame(*before, other, 1), {.threads = 2});
        CHECK(difference(draw(executor, frame, {.threads = 1}), want) == "");
        CHECK(difference(draw(executor, frame, {.threads = 3}), want) == "");
    }
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        draw(executor, random_frame(seed), {.threads = 2});
        INFO("after random frame " << seed);
        CHECK(difference(draw(executor, frame, {.threads = 1}), want) == "");
    }
}

void check_text(const demo::Scene& scene, Size size, int index) {
    const pipeline::Frame frame = demo::scene_frame(scene, size, index);
    const pipeline::Frame again = pipeline::parse_frame(pipeline::to_text(frame));
    CHECK(pipeline::diff(frame, again) == std::vector<std::string>{});
    CHECK(difference(draw(again), draw(frame)) == "");
}

}  // namespace

TEST_CASE("kernels and reference agree on the canyon", "[agreement][scene]") {
    check_agreement(canyon(), {201, 113}, 0, kThreadCounts.size());
    check_agreement(canyon(), {95, 131}, 60, 1);
    check_history(canyon(), {201, 113});
    check_text(canyon(), {95, 53}, 60);
}

TEST_CASE("kernels and reference agree on an article cloud", "[agreement][scene]") {
    check_agreement(article(), {201, 113}, 0, kThreadCounts.size());
    check_agreement(article(), {63, 33}, 0, kThreadCounts.size());
    check_history(article(), {201, 113});
    check_text(article(), {201, 113}, 0);
}

TEST_CASE("kernels and reference agree on two clouds, one behind the other", "[agreement][scene]") {
    check_agreement(two_clouds(), {201, 113}, 0, kThreadCounts.size());
    check_agreement(two_clouds(), {129, 97}, 5, kThreadCounts.size());
    check_history(two_clouds(), {201, 113});
    check_text(two_clouds(), {201, 113}, 5);

    const pipeline::Frame frame      = demo::scene_frame(two_clouds(), {201, 113}, 0);
    std::map<std::string, int> count = pixels_of_clouds(frame, draw(frame));
    CHECK(count["near"] > 1000);
    CHECK(count["far"] > 1000);
    CHECK(count["both"] > 500);  // or this scene shows nothing about overlap
}

TEST_CASE("an executor keeps nothing of one random frame in the next", "[agreement]") {
    pipeline::Executor executor;
    for (std::uint32_t seed = 3000; seed < 3300; ++seed) {
        INFO("seed " << seed);
        const pipeline::Frame frame = random_frame(seed);
        const Drawn want            = draw(frame, {.threads = 1});
        const std::string different = difference(draw(executor, frame, {.threads = 2}), want);
        if (!different.empty()) FAIL(different);
    }
}
