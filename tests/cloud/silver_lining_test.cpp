// SPDX-License-Identifier: MIT
#include "cloud/silver_lining.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "cloud/bake.h"
#include "cloud/mega_particles/mega_particles.h"
#include "cloud/merge.h"
#include "demo/scene_build.h"
#include "demo/scene_file.h"
#include "pipeline/execute/execute.h"
#include "tests/cloud/cumulus.h"

using namespace cloud;
using namespace pipeline;

namespace {

const View kFront = look(Vec3(0.0f, 60.0f, 170.0f), Vec3(0.0f, 60.0f, 0.0f));

Daylight sun_towards(Vec3 direction) {
    Daylight light;
    light.to_sun = glm::normalize(direction);
    return light;
}
const Vec3 kBehindCloud(0.0f, 0.0f, -1.0f), kBehindCamera(0.2f, 0.3f, 1.0f);

// The cores alone, smooth.
Cloud ball(float strength) {
    Cloud cloud;
    cloud.name              = "ball";
    cloud.particles         = {{.center = Vec3(0.0f, 60.0f, 0.0f), .radius = 30.0f}};
    cloud.lumpiness         = 0.0f;
    cloud.fractal.face_size = 16;
    cloud.silver_lining     = strength;
    return cloud;
}

Frame frame_of(const Cloud& cloud, const Daylight& light) {
    Frame frame;
    frame.targets = {{.name = "back buffer", .width = kFront.width, .height = kFront.height},
                     {.name = "depth", .format = TargetFormat::D24, .width = kFront.width, .height = kFront.height}};
    frame.cameras = {{.name = "camera", .view = kFront.view, .projection = kFront.projection}};
    frame.output  = {0};
    frame.passes.push_back({.label = "scene",
                            .color = {0},
                            .depth = {1},
                            .clear = {.color = Argb{0xff000000}, .depth = 1.0f},
                            .draws = {}});
    append_mega_particles(frame, {.back_buffer = {0}, .depth = {1}, .camera = {0}, .fog = {}}, kFront, light,
                          std::span(&cloud, 1));
    return frame;
}

int green_at(const ColorImage& image, int x, int y) {
    return static_cast<int>(image.pixels[static_cast<std::size_t>(y * image.width + x)] >> 8 & 255);
}

}  // namespace

TEST_CASE("forward scattering: 1 ahead, as Henyey and Greenstein say aside, 0 from a right angle on", "[cloud]") {
    // ((0.09 / (0.09 + 1.4 (1 - cos)))^1.5 - 0.014845) / 0.985155, worked out by hand
    CHECK(forward_scattering(1.0f) == 1.0f);
    CHECK(forward_scattering(0.9659258f) == Approx(0.5208).margin(0.001));  // 15 degrees
    CHECK(forward_scattering(0.8660254f) == Approx(0.1723).margin(0.001));  // 30 degrees
    CHECK(forward_scattering(0.0f) == 0.0f);
    CHECK(forward_scattering(-0.5f) == 0.0f);
    CHECK(forward_scattering(-1.0f) == 0.0f);
    CHECK(forward_scattering(1.0000002f) == 1.0f);  // a cosine that was rounded up
    float last = 0.0f;
    for (int i = 1; i <= 1000; ++i) {
        const float now = forward_scattering(static_cast<float>(i) / 1000.0f);
        CHECK(now >= last);
        last = now;
    }
}

TEST_CASE("without the key, and with the sun behind the camera, there is no silver lining", "[cloud]") {
    Cloud plain = cumulus(), lined = cumulus();
    CHECK(plain.silver_lining == 0.0f);
    lined.silver_lining          = 1.5f;
    const Daylight behind_camera = sun_towards(kBehindCamera), before = sun_towards(kBehindCloud);
    CHECK(frame_of(plain, behind_camera) == frame_of(lined, behind_camera));
    CHECK_FALSE(frame_of(plain, before) == frame_of(lined, before));
    // The article's own lights do not know it.
    plain.mode = lined.mode = Mode::Article;
    CHECK(frame_of(plain, before) == frame_of(lined, before));
}

TEST_CASE("against the sun the rim gains and the middle does not", "[cloud]") {
    const Daylight before  = sun_towards(kBehindCloud);
    const ColorImage dark  = execute(frame_of(ball(0.0f), before)).output;
    const ColorImage lined = execute(frame_of(ball(1.0f), before)).output;
    // The ball is 30 m at 170: its outline 52 px at 579 / 2 px a unit; the middle at (160, 120).
    const auto gain        = [&](int x, int y) { return green_at(lined, x, y) - green_at(dark, x, y); };
    // At 48 px N.V is 0.38 and the chord 23 m: 0.68 (1 - 0.38) exp(-0.82) P(9 degrees), 0.14 of 255.
    CHECK(gain(160, 120) <= 1);
    CHECK(gain(160 + 20, 120) <= 5);
    CHECK(green_at(dark, 160 + 48, 120) < green_at(dark, 160, 120) + 12);
    for (const int reach : {-48, 48}) {
        CHECK(gain(160 + reach, 120) >= 22);
        CHECK(gain(160, 120 + reach) >= 22);
        CHECK(green_at(lined, 160 + reach, 120) > green_at(lined, 160, 120) + 30);
    }
}

TEST_CASE("the middle of a ball before the sun gets what its diameter lets through", "[cloud]") {
    // N.V = -1 where the view meets the ball: nothing. At 45 degrees on it, from afar: chord 30 sqrt 2, T = exp(-2.14 *
    // 30 sqrt 2 / 60) = 0.2203, edge 1 - cos 45 = 0.2929.
    const Daylight before = sun_towards(kBehindCloud);
    const Cloud cloud     = ball(2.0f);
    const LitVertex vertex{.position = Vec3(0.0f), .normal = Vec3(0.70710678f, 0.0f, 0.70710678f), .sun = 0.2203f};
    const Vec3 light = silver_lining(cloud, before, vertex, Vec3(0.0f, 0.0f, 1000.0f));
    CHECK(light.x == Approx(2.0f * 0.70f * 0.2203f * 0.29289f).margin(1e-5));
    CHECK(light.y == Approx(2.0f * 0.679f * 0.2203f * 0.29289f).margin(1e-5));
    CHECK(silver_lining(cloud, before, {.normal = Vec3(0.0f, 0.0f, 1.0f)}, Vec3(0.0f, 0.0f, 9.0f)) == Vec3(0.0f));
    CHECK(silver_lining(cloud, before, {.normal = Vec3(1.0f, 0.0f, 0.0f)}, Vec3(0.0f)) == Vec3(0.0f));  // at the eye

    const BakedCloud baked = bake(cloud, before);
    float greatest = 0.0f, nearest = 1.0f;
    for (const LitVertex& v : baked.lit.vertices.all()) {
        CHECK((v.sun >= 0.0f && v.sun <= 1.0f));
        if (std::abs(v.normal.z - 0.70710678f) < nearest) {
            nearest  = std::abs(v.normal.z - 0.70710678f);
            greatest = v.sun;
        }
    }
    CHECK(greatest == Approx(0.2203f).epsilon(0.06));
}

TEST_CASE("silver linings are finite and bounded, wherever the eye is", "[cloud]") {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> anywhere(-120.0f, 120.0f), sign(-1.0f, 1.0f);
    Cloud cloud         = cumulus();
    cloud.silver_lining = 4.0f;
    bool any            = false;
    for (int i = 0; i < 6; ++i) {
        const Daylight light   = sun_towards(Vec3(sign(random), sign(random), sign(random)));
        const BakedCloud baked = bake(cloud, light);
        const Vec3 eye = i == 0 ? baked.lit.vertices[7].position : Vec3(anywhere(random), 60.0f, anywhere(random));
        bool bounded   = true;
        for (const LitVertex& vertex : baked.lit.vertices.all()) {
            const Vec3 added = silver_lining(cloud, light, vertex, eye);
            for (int c = 0; c < 3; ++c) bounded &= added[c] >= 0.0f && added[c] <= 4.0f * light.sun[c];
            any |= added.x > 0.0f;
        }
        CHECK(bounded);  // NaN is not
    }
    CHECK(any);
}

TEST_CASE("linings do not depend on the order in which particles are lit", "[cloud]") {
    const Daylight before = sun_towards(Vec3(0.2f, 0.1f, -1.0f));
    Cloud cloud           = cumulus();
    cloud.silver_lining   = 1.0f;
    const BakedCloud a = bake(cloud, before), b = bake(cloud, before, [](std::size_t count, const auto&work) {
                                                  for (std::size_t i = count; i-- > 0;) work(i);
                                              });
    for (std::size_t i = 0; i < a.lit.vertices.size(); ++i)
        REQUIRE(silver_lining(cloud, before, a.lit.vertices[i], kFront.eye) ==
                silver_lining(cloud, before, b.lit.vertices[i], kFront.eye));
}

TEST_CASE("clouds of different silver linings stay apart, and nonsense is refused", "[cloud]") {
    Cloud other         = ball(0.0f);
    other.silver_lining = 0.5f;
    const Daylight day;
    CHECK(merge_touching({bake(ball(0.0f), day), bake(ball(0.0f), day)}).size() == 1);
    CHECK(merge_touching({bake(ball(0.0f), day), bake(other, day)}).size() == 2);
    CHECK_NOTHROW(bake(ball(4.0f), day));
    CHECK_THROWS_AS(bake(ball(4.01f), day), std::invalid_argument);
    CHECK_THROWS_AS(bake(ball(-0.01f), day), std::invalid_argument);
    CHECK_THROWS_AS(bake(ball(NAN), day), std::invalid_argument);
}

TEST_CASE("a scene file's silver_lining arrives", "[demo][scene_file]") {
    const auto strength = [](const std::string& key) {
        return demo::parse_scene("[[cloud]]\ncores = [[0, 0, 0, 1]]\n" + key, "x.toml", "x")
            .clouds[0]
            .settings.silver_lining;
    };
    CHECK(strength("") == 0.0f);
    CHECK(strength("silver_lining = 0.75") == 0.75f);
    CHECK_THROWS_WITH(strength("silver_lining = 5"), Catch::Contains("silver_lining must be <= 4"));
}
