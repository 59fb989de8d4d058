// SPDX-License-Identifier: MIT
// The metrics of built-in scenes, small: the targets that hold must go on holding, and the command prints them.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "demo/metrics/measures.h"
#include "demo/metrics/scene_metrics.h"
#include "tests/support/child_process.h"

using namespace demo;
using tests::Ended;
using tests::ScratchDirectory;

namespace {

// A puff, with a wall that cuts into it; and another puff before it.
const std::string kPuff       = R"(summary = "A puff in a wall"
[output]
size = [160, 96]
[camera]
position = [0, 10, 60]
target = [0, 10, 0]
[[solid]]
kind = "box"
from = [6, -10, -30]
to = [40, 12, -5]
[[cloud]]
name = "far"
cores = [[4, 10, -14, 10]]
blur = 1
[cloud.fractal]
size = 32
octaves = 3
)";
const std::string kSecondPuff = R"(
[[cloud]]
name = "near"
cores = [[-8, 10, 6, 8]]
blur = 1
[cloud.fractal]
size = 32
octaves = 3
)";

const std::string kWall = R"(summary = "A wall"
[camera]
position = [0, 10, 60]
target = [0, 10, 0]
[[solid]]
kind = "box"
from = [-100, -100, -30]
to = [100, 100, -8]
)";

Ended nimbus7(const ScratchDirectory& directory, const std::vector<std::string>& arguments) {
    return tests::run_program(NIMBUS7_PROGRAM, arguments, directory.path(), {});
}

bool is_one_line(const std::string& text) {
    return !text.empty() && text.find('\n') == text.size() - 1;
}

}  // namespace

TEST_CASE("the canyon's cloud meets its targets, at 320x180", "[metrics]") {
    const ScenePtr scene       = load_scene("canyon");
    const MetricsReport report = scene_metrics(*scene, {.size = {320, 180}});
    const auto value           = [&](const char* key) { return find_metric(report.metrics, key).value; };
    for (const char* key : {"M0.constants",
                            "M0.pass_error",
                            "M0.blur_drift",
                            "M0.blend_drift",
                            "M0.inside",
                            "M0.depth_range",
                            "M2.error",
                            "M2.error_outside",
                            "M3.climb_width",
                            "M3.monotone",
                            "M3.leak",
                            "M3.leak_order_free",
                            "M4.sigma_variation",
                            "M4.anisotropy",
                            "M4.energy_error",
                            "M5.orbit_jump",
                            "M6.turn",
                            "M6.shift",
                            "M7.skirt",
                            "M7.premultiplied",
                            "M8.layers_full",
                            "M8.sphere_slope",
                            "M8.front_to_back",
                            "M8.blur_scissored",
                            "M10.tone",
                            "M10.shadow_saturation",
                            "M10.crease"}) {
        INFO(key << " is " << value_text(find_metric(report.metrics, key)));
        CHECK(find_metric(report.metrics, key).verdict() == Verdict::Ok);
    }
    // The figures tell good from bad.
    CHECK(*value("M3.leak_unordered") > 0.1);
    CHECK(*value("M7.black_light") < -5.0);
    CHECK(*value("M7.black") > 3.0 * *value("M7.skirt"));
    CHECK_FALSE(value("M9.error"));
}

TEST_CASE("sprites and slices show what they cannot do", "[metrics]") {
    const ScenePtr scene = load_scene("canyon");
    Studio sprites(*scene, {.size = {320, 180}, .technique = Technique::Sprites});
    CHECK(*find_metric(measure_numerics(sprites), "M0.inside").value > 5.0);
    CHECK(*find_metric(measure_fill(sprites), "M8.layers_full").value > 5.0);
    CHECK_FALSE(find_metric(measure_kernel(sprites), "M4.sigma").value);
    Studio slices(*scene, {.size = {320, 180}, .technique = Technique::Slices});
    CHECK(*find_metric(measure_fill(slices), "M8.layers_full").value > 5.0);
}

TEST_CASE("clouds in one picture leave each other alone, in any order", "[metrics]") {
    const ScratchDirectory directory;
    tests::write_file(directory / "puff.toml", kPuff + kSecondPuff);
    const ScenePtr scene = load_scene(directory / "puff.toml");
    Studio studio(*scene, {.size = {160, 96}});
    const Metrics metrics = measure_interference(studio);
    CHECK(find_metric(metrics, "M9.error").verdict() == Verdict::Ok);
    CHECK(find_metric(metrics, "M9.shuffled").value == 0.0);
    // Of two clouds the anatomy shows both, cut by the wall.
    const Anatomy& anatomy = studio.anatomy();
    const auto covered     = [](const Plane& plane) {
        return std::count_if(plane.values.begin(), plane.values.end(), [](float v) { return v > 0.5f; });
    };
    CHECK(covered(anatomy.shape) > 500);
    CHECK(covered(anatomy.shape_alone) > covered(anatomy.shape) + 50);
}

TEST_CASE("depth is read back within a step", "[metrics]") {
    const ScratchDirectory directory;
    tests::write_file(directory / "wall.toml", kWall);
    const ScenePtr scene = load_scene(directory / "wall.toml");
    Studio studio(*scene, {.size = {64, 64}});
    const Plane depth = depth_of(studio, studio.frame(), 50.0f, 90.0f);
    for (const float meters : depth.values) REQUIRE(meters == Approx(68.0f).margin(40.0f / 1023.0f));
    CHECK(depth_of(studio, studio.frame(), 70.0f, 90.0f).at(3, 3) == 70.0f);
    CHECK(std::isinf(depth_of(studio, studio.frame(), 50.0f, 60.0f).at(3, 3)));
    CHECK_FALSE(studio.has_cloud());
    for (const Metric& metric : scene_metrics(*scene, {.size = {64, 64}}).metrics)
        CHECK((!metric.value || metric.key.starts_with("M0.")));
}

TEST_CASE("metrics are printed as a table and as JSON", "[metrics][cli]") {
    const ScratchDirectory directory;
    tests::write_file(directory / "puff.toml", kPuff);
    tests::write_file(directory / "wall.toml", kWall);
    const Ended table = nimbus7(directory, {"metrics", "puff.toml", "--size", "96x64"});
    CHECK(table.error == "");
    REQUIRE(table.status == 0);
    CHECK_THAT(table.out,
               Catch::StartsWith("metric") && Catch::Contains("M0.constants") && Catch::Contains("M10.crease"));
    const Ended json =
        nimbus7(directory, {"metrics", "puff.toml", "--size", "96x64", "--json", "--technique", "sprites"});
    REQUIRE(json.status == 0);
    const auto report = nlohmann::json::parse(json.out);
    CHECK(report["scene"] == "puff.toml");
    CHECK(report["technique"] == "sprites");
    CHECK(report["metrics"].size() > 40);
    CHECK(report["metrics"][0]["metric"] == "M0.constants");
    CHECK(report["metrics"][0]["verdict"] == "ok");
    const Ended claims = nimbus7(directory, {"metrics", "wall.toml", "--size", "64x64", "--claims"});
    REQUIRE(claims.status == 0);
    CHECK_THAT(claims.out, Catch::StartsWith("| claim | measure | mega-particles | sprites | slices |\n| --- |"));
    for (std::size_t at = 0; (at = claims.out.find('\n', at)) + 1 < claims.out.size(); ++at)
        CHECK(claims.out[at + 1] == '|');
}

TEST_CASE("what draws a scene's clouds can be chosen", "[metrics][cli]") {
    const ScratchDirectory directory;
    tests::write_file(directory / "puff.toml", kPuff);
    const auto picture = [&](const std::vector<std::string>& options) {
        std::vector<std::string> arguments{"render", "puff.toml", "-o", "out.png"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Ended ended = nimbus7(directory, arguments);
        CHECK(ended.error == "");
        REQUIRE(ended.status == 0);
        return tests::read_file(directory / "out.png");
    };
    const std::string plain = picture({});
    CHECK(picture({"--technique", "mega"}) == plain);
    CHECK(picture({"--mode", "skirt"}) == plain);
    for (const char* technique : {"sprites", "slices"}) CHECK(picture({"--technique", technique}) != plain);
    for (const char* mode : {"article", "premultiplied", "black"}) CHECK(picture({"--mode", mode}) != plain);
    CHECK(picture({"--order-free"}) != "");
}

TEST_CASE("bad usage of metrics and of a scene's options is one line", "[metrics][cli]") {
    const ScratchDirectory directory;
    tests::write_file(directory / "puff.toml", kPuff);
    REQUIRE(nimbus7(directory, {"dump", "puff.toml", "-o", "puff.txt"}).status == 0);
    const auto arguments =
        GENERATE(std::vector<std::string>{"metrics"}, std::vector<std::string>{"metrics", "nowhere.toml"},
                 std::vector<std::string>{"metrics", "puff.toml", "--size", "32x32"},
                 std::vector<std::string>{"metrics", "puff.toml", "--technique", "magic"},
                 std::vector<std::string>{"metrics", "puff.toml", "--json", "--claims"},
                 std::vector<std::string>{"metrics", "puff.toml", "--frame", "-1"},
                 std::vector<std::string>{"metrics", "puff.txt"},
                 std::vector<std::string>{"render", "puff.toml", "--mode", "plain"},
                 std::vector<std::string>{"render", "puff.toml", "--technique", "x"},
                 std::vector<std::string>{"render", "puff.txt", "--technique", "sprites"},
                 std::vector<std::string>{"render", "puff.txt", "--mode", "skirt"},
                 std::vector<std::string>{"render", "puff.txt", "--order-free"});
    const Ended ended = nimbus7(directory, arguments);
    INFO(ended.error);
    CHECK(ended.status == 2);
    CHECK(is_one_line(ended.error));
    CHECK(ended.out == "");
}
