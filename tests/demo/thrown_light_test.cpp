// SPDX-License-Identifier: MIT
#include "demo/thrown_light.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "demo/scene_build.h"
#include "demo/scene_file.h"
#include "pipeline/execute/execute.h"

namespace {

using namespace demo;
using pipeline::ColorImage;
using pipeline::Frame;

// A grey floor of 100 m from 40 m above, 0.518 m a pixel; its cloud is above the camera.
constexpr int kSize        = 64;
constexpr double kPixel_m  = 40.0 * 0.41421356 / (kSize / 2);
const std::string kDimFire = "[[cloud.light]]\ncolor = [1, 0.5, 0.25]\nscene_range = 10\n";

SceneDescription floor_under(const std::string& light) {
    return parse_scene(
        "[camera]\nposition = [0, 40, 1]\ntarget = [0, 0, 0]\n"
        "[[solid]]\nkind = \"box\"\nfrom = [-50, -1, -50]\nto = [50, 0, 50]\ncolor = [0.4, 0.4, 0.4]\n"
        "[[cloud]]\nname = \"fire\"\ncores = [[0, 90, 0, 1]]\n" +
            light,
        "x.toml", "x");
}

Frame frame_of(const std::string& light, int index = 0) {
    return scene_frame(build_scene(floor_under(light)), {kSize, kSize}, index);
}

ColorImage picture_of(const std::string& light) {
    return pipeline::execute(frame_of(light)).output;
}

std::uint32_t right_of_middle(const ColorImage& picture, int pixels) {
    return picture.pixels[static_cast<std::size_t>(kSize / 2 * kSize + kSize / 2 + pixels)];
}

bool throws_light(const Frame& frame) {
    return std::any_of(frame.passes.begin(), frame.passes.end(),
                       [](const pipeline::Pass& pass) { return pass.label == "light of fire"; });
}

}  // namespace

TEST_CASE("thrown light multiplies what is drawn by 1 + its colour, less with distance", "[demo]") {
    const ColorImage dark = picture_of(""), lit = picture_of(kDimFire);
    for (const int pixels : {0, 4, 9, 14, 18}) {
        CAPTURE(pixels);
        const double x = (pixels + 0.5) * kPixel_m / 10.0, z = 0.5 * kPixel_m / 10.0;
        const double share         = std::pow(1.0 - x * x - z * z, 3.0);
        const std::uint32_t before = right_of_middle(dark, pixels), after = right_of_middle(lit, pixels);
        CHECK(after >> 24 == before >> 24);
        for (const auto& [shift, color] : {std::pair{16, 1.0}, std::pair{8, 0.5}, std::pair{0, 0.25}}) {
            const double ground = before >> shift & 255;
            CHECK(std::abs((after >> shift & 255) - ground * (1.0 + color * share)) <= 2.0);
        }
    }
    CHECK(right_of_middle(lit, 20) == right_of_middle(dark, 20));
    CHECK(right_of_middle(lit, -22) == right_of_middle(dark, -22));
}

TEST_CASE("light that is higher up than its range does not reach the ground", "[demo]") {
    CHECK(picture_of(kDimFire + "position = [0, 10, 0]\n") == picture_of(""));
    CHECK_FALSE(picture_of(kDimFire + "position = [0, 5, 0]\n") == picture_of(""));
}

TEST_CASE("light is drawn only where and when it is thrown", "[demo]") {
    CHECK_FALSE(throws_light(frame_of("[[cloud.light]]\ncolor = [1, 1, 1]\nrange = 10\n")));
    CHECK_FALSE(throws_light(frame_of("[[cloud.light]]\ncolor = [0, 0, 0]\nscene_range = 10\n")));
    // 30 frames a second.
    const std::string flash = kDimFire + "flashes = [[1, 0.5]]\n";
    CHECK_FALSE(throws_light(frame_of(flash, 20)));
    CHECK(throws_light(frame_of(flash, 33)));
    CHECK_FALSE(throws_light(frame_of(flash, 50)));
}

TEST_CASE("lights go where their cloud goes, and are no brighter than a texture can say", "[demo]") {
    const SceneDescription description = floor_under(
        "position = [1, 2, 3]\nscale = 2\n[[cloud.key]]\nat = 0\noffset = [0, 5, 0]\n"
        "[[cloud.light]]\nposition = [1, 0, 0]\ncolor = [4, 2, 0]\nscene_range = 7\n");
    const std::vector<ThrownLight> lights = thrown_lights(description.clouds.at(0), 0.0);
    REQUIRE(lights.size() == 1);
    CHECK(lights[0].center == Vec3(3.0f, 7.0f, 3.0f));
    CHECK(lights[0].color == Vec3(1.0f, 0.5f, 0.0f));
    CHECK(lights[0].range == 14.0f);
}
