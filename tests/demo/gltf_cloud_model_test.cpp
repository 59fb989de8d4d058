// SPDX-License-Identifier: MIT
// The cloud that the demo ships: nimbus7_tests "[write_models]" writes the file anew.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "demo/gltf_particles.h"
#include "tests/support/child_process.h"
#include "tests/support/cloud_model.h"

namespace {

const std::string kPath = NIMBUS7_SOURCE_DIR "/demo/scenes/models/cloud.glb";

}  // namespace

TEST_CASE("the cloud of the demo is written", "[.][write_models]") {
    std::filesystem::create_directories(std::filesystem::path(kPath).parent_path());
    tests::write_file(kPath, tests::cloud_model_glb());
    CHECK(tests::read_file(kPath) == tests::cloud_model_glb());
}

TEST_CASE("the cloud of the demo is as written, and swells", "[demo][gltf]") {
    // Not CHECK(a == b), which would print both.
    const bool is_same = tests::read_file(kPath) == tests::cloud_model_glb();
    CHECK(is_same);
    const demo::ParticleFile file({.path = kPath, .named_at = "here"});
    CHECK(file.duration() == 3.0);
    const std::vector<cloud::Particle> first = file.at(0.0), last = file.at(3.0);
    REQUIRE(first.size() == 24);
    REQUIRE(last.size() == 24);
    for (std::size_t i = 0; i < 24; ++i) {
        CHECK(first[i].radius < 0.85f * last[i].radius);
        CHECK(first[i].center.y == Approx(last[i].center.y - 4.0f));
    }
    // The same bits on every machine, between keys too.
    const cloud::Particle between = file.at(0.7)[20];
    CHECK(between.radius == 0x1.c199c6p+1f);
    CHECK(between.center.y == 0x1.366666p+4f);
    CHECK(between.shape[0][0] == 0x1.effd4ap-1f);
    CHECK(between.shape[1][1] == 0x1.10cb5p+0f);
    // A base particle: 14 m, and 0.7 of that high.
    CHECK(last[0].radius == Approx(14.0 * std::cbrt(0.7)));
}
