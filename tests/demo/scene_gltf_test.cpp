// SPDX-License-Identifier: MIT
// Scene files that take their clouds and geometry from glTF files.
#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "demo/cloud_motion.h"
#include "demo/gltf_particles.h"
#include "demo/scene.h"
#include "demo/scene_build.h"
#include "demo/scene_file.h"
#include "pipeline/execute/execute.h"
#include "pipeline/validate/validate.h"
#include "tests/support/child_process.h"
#include "tests/support/glb_file.h"

namespace {

using namespace demo;

const std::string kModels = std::string(NIMBUS7_SOURCE_DIR) + "/demo/scenes/";

Scene scene_of(const std::string& text) {
    return build_scene(parse_scene(text, kModels + "x.toml", "x"));
}

}  // namespace

TEST_CASE("a cloud's particles come from a glTF file, placed and moved by it", "[demo][gltf]") {
    const Scene scene = scene_of(
        "[output]\nframes = 90\n[[cloud]]\nparticles = \"models/cloud.glb\"\n"
        "position = [10, 20, 30]\nscale = 2\n");
    REQUIRE(scene.clouds.size() == 1);
    const cloud::Cloud at_start = cloud_at(scene.clouds[0], 0.0), later = cloud_at(scene.clouds[0], 1.5);
    REQUIRE(at_start.particles.size() == 24);
    REQUIRE(later.particles.size() == 24);
    const std::vector<cloud::Particle> raw = scene.clouds[0].file->at(0.0);
    CHECK(glm::length(at_start.particles[0].center - (Vec3(10.0f, 20.0f, 30.0f) + 2.0f * raw[0].center)) < 1e-4f);
    CHECK(at_start.particles[0].radius == 2.0f * raw[0].radius);
    bool moved = false;
    for (std::size_t i = 0; i < later.particles.size(); ++i)
        moved |= later.particles[i].radius != at_start.particles[i].radius;
    CHECK(moved);
    // The box holds the cloud at any time, so that the fractal stays.
    REQUIRE(scene.clouds[0].grown.box);
    for (const cloud::Particle& particle : later.particles) {
        CHECK(particle.center.x + particle.radius <= scene.clouds[0].grown.box->high.x + 1e-3f);
        CHECK(particle.center.y - particle.radius >= scene.clouds[0].grown.box->low.y - 1e-3f);
    }
    const pipeline::Frame frame = scene_frame(scene, {160, 90}, 45);
    CHECK(pipeline::validate(frame).empty());
    CHECK(pipeline::execute(frame).counts.size() == frame.passes.size());
}

TEST_CASE("geometry from a glTF file is placed, scaled, lit, and drawn before or after the clouds", "[demo][gltf]") {
    tests::GlbFile file;
    const int positions = file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int mesh =
        file.add("meshes", {{"primitives", tests::Json::array({{{"attributes", {{"POSITION", positions}}}}})}});
    file.root({{"mesh", mesh}});
    const tests::ScratchDirectory directory;
    tests::write_file(directory / "cliffs.glb", file.glb());
    const bool front = GENERATE(false, true);
    const Scene scene =
        build_scene(parse_scene("[[mesh]]\nfile = \"cliffs.glb\"\nposition = [5, 6, 7]\nscale = 10\nfront = " +
                                    std::string(front ? "true" : "false"),
                                directory / "x.toml", "x"));
    const auto& ranges = front ? scene.geometry.solids_in_front : scene.geometry.solids_behind;
    REQUIRE(ranges.size() == 1);
    CHECK((front ? scene.geometry.solids_behind : scene.geometry.solids_in_front).empty());
    REQUIRE(ranges[0].range.index_count == 3);
    const pipeline::Vertex& second = scene.geometry.vertices[scene.geometry.indices[ranges[0].range.first_index + 1]];
    CHECK(second.position == Vec3(15.0f, 6.0f, 7.0f));
    CHECK(second.diffuse.value != 0xff000000);
}

TEST_CASE("a file that a scene names and that cannot be used is one line with the place", "[demo][gltf]") {
    CHECK_THROWS_WITH(scene_of("[[cloud]]\nparticles = \"models/none.glb\"\n"),
                      Catch::Contains("x.toml:2:13: cloud.particles") && Catch::Contains("none.glb"));
    CHECK_THROWS_WITH(scene_of("[[mesh]]\nfile = \"canyon.toml\"\n"),
                      Catch::Contains("x.toml:2:8: mesh.file") && Catch::Contains("canyon.toml"));
    CHECK_THROWS_WITH(scene_of("[[cloud]]\nparticles = \"models/cloud.glb\"\ncores = [[0, 0, 0, 1]]\n"),
                      Catch::Contains("one of them"));
}
