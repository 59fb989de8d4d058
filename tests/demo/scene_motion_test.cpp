// SPDX-License-Identifier: MIT
// Animations of the built-in scenes have no jumps: the mean of the picture changes little from frame to frame.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "demo/scene.h"
#include "pipeline/execute/execute.h"

namespace {

double mean_luminance(const pipeline::ColorImage& image) {
    double sum = 0.0;
    for (std::uint32_t pixel : image.pixels)
        sum += 0.299 * (pixel >> 16 & 255) + 0.587 * (pixel >> 8 & 255) + 0.114 * (pixel & 255);
    return sum / static_cast<double>(image.pixels.size());
}

// The greatest change between neighbours among the frames, in steps of 1/255.
double greatest_jump(const std::string& name, int first, int last) {
    const demo::ScenePtr scene = demo::load_scene(name);
    pipeline::Executor executor;
    pipeline::Execution execution;
    double before = 0.0, jump = 0.0;
    for (int index = first; index <= last; ++index) {
        executor.execute(demo::scene_frame(*scene, {64, 36}, index), execution);
        const double now = mean_luminance(execution.output);
        if (index > first) jump = std::max(jump, std::abs(now - before));
        before = now;
    }
    return jump;
}

}  // namespace

TEST_CASE("a flight through a cloud has no jump, in at the front and out at the side", "[scene]") {
    const double jump = greatest_jump("inside", 0, 120);
    CHECK(jump <= 8.0);
    CHECK(jump > 1.0);  // there is something to see
}

TEST_CASE("a walk through smoke has no jump, in and out", "[scene]") {
    CHECK(greatest_jump("smoke", 120, 155) <= 10.0);
    CHECK(greatest_jump("smoke", 250, 300) <= 10.0);
}

TEST_CASE("the nebula turns without a flicker", "[scene]") {
    CHECK(greatest_jump("nebula", 20, 35) <= 2.0);
}

TEST_CASE("clouds in the distance move smoothly", "[scene]") {
    CHECK(greatest_jump("field", 0, 30) <= 2.0);
    CHECK(greatest_jump("plume", 0, 20) <= 3.0);
}
