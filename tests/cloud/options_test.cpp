// SPDX-License-Identifier: MIT
// What the technique can be drawn with for less time, or for more.
#include "cloud/mega_particles/options.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include "cloud/mega_particles/mega_particles.h"
#include "pipeline/execute/execute.h"
#include "pipeline/frame/frame_text.h"
#include "pipeline/validate/validate.h"
#include "tests/cloud/cumulus.h"
#include "tests/cloud/walled_scene.h"

using namespace cloud;
using namespace pipeline;

namespace {

const View kFront = look(Vec3(0.0f, 58.0f, 170.0f), Vec3(0.0f, 60.0f, 0.0f), 333, 211);

// A sky, and a wall in the left 140 columns that cuts the cloud.
Frame frame_of(const BakedCloud& cloud, const MegaParticleOptions& options, const View& view = kFront) {
    constexpr float kDepth = 0.99728f;  // 165 m away
    Frame frame = walled_scene(view, {0xff203070}, {140.0f, static_cast<float>(view.height), kDepth, {0xff602010}});
    append_mega_particles(frame, kWalledTargets, view, std::span(&cloud, 1), options);
    return frame;
}

Frame frame_of(const Cloud& cloud, const MegaParticleOptions& options, const View& view = kFront) {
    return frame_of(bake(cloud, Daylight{}), options, view);
}

std::vector<std::string> labels(const Frame& frame) {
    std::vector<std::string> all;
    for (const Pass& pass : frame.passes) all.push_back(pass.label);
    return all;
}

const Pass& pass_named(const Frame& frame, const std::string& part) {
    const auto found = std::ranges::find_if(
        frame.passes, [&](const Pass& pass) { return pass.label.find(part) != std::string::npos; });
    if (found == frame.passes.end()) throw std::runtime_error("no pass " + part);
    return *found;
}

std::uint32_t triangles_of(const Frame& frame, const std::string& part) {
    return std::get<DrawTriangles>(pass_named(frame, part).draws.at(0)).index_count / 3;
}

int green(const ColorImage& image, int x, int y) {
    return static_cast<int>(image.pixels[static_cast<std::size_t>(y * image.width + x)] >> 8 & 255);
}

// Of `image` moved by (dx, dy) pixels from `other`.
double squares(const ColorImage& image, const ColorImage& other, int dx, int dy) {
    double sum = 0.0;
    for (int y = 2; y < image.height - 2; ++y)
        for (int x = 2; x < image.width - 2; ++x) {
            const double d = green(image, x + dx, y + dy) - green(other, x, y);
            sum += d * d;
        }
    return sum;
}

}  // namespace

TEST_CASE("choices that there are not are refused", "[cloud]") {
    MegaParticleOptions options;
    CHECK_NOTHROW(check(options));
    SECTION("target scale") {
        options.target_scale = GENERATE(0, 3, 8);
    }
    SECTION("spheres") {
        options.fewer_sphere_levels = GENERATE(-1, 4);
    }
    CHECK_THROWS_AS(frame_of(cumulus(), options), std::invalid_argument);
}

TEST_CASE("frames of all choices are valid, in every mode, detail and order", "[cloud]") {
    Cloud cloud   = cumulus();
    cloud.mode    = GENERATE(Mode::Skirt, Mode::Article, Mode::Premultiplied, Mode::Black);
    cloud.detail  = GENERATE(Detail::Fractal, Detail::Displacement, Detail::None);
    cloud.order   = GENERATE(Order::InOrder, Order::OrderFree);
    cloud.opacity = cloud.order == Order::InOrder ? 1.0f : 0.6f;
    const MegaParticleOptions options{.target_scale = GENERATE(1, 2, 4), .fewer_sphere_levels = 1, .skirt = false};
    const BakedCloud baked = bake(cloud, Daylight{});
    for (const auto& [z, width, height] :
         {std::tuple{170.0f, 160, 90}, std::tuple{24.0f, 7, 5}, std::tuple{3.0f, 33, 20}}) {
        const View view = look(Vec3(0.0f, 60.0f, z), Vec3(2.0f, 60.0f, -300.0f), width, height);
        for (const Finding& finding : validate(frame_of(baked, options, view)))
            FAIL_CHECK(finding.where + ": " + finding.what);
    }
}

TEST_CASE("at half the scale the passes are the same but for the first steps down and the last up", "[cloud]") {
    Cloud cloud       = cumulus();
    cloud.blur_m      = 2.5f;
    const Frame full  = frame_of(cloud, {});
    const Frame frame = frame_of(cloud, {.target_scale = 2});
    CHECK(labels(full).size() - labels(frame).size() == 1);
    CHECK(labels(frame) ==
          std::vector<std::string>{
              "scene", "scene, depth at 1/2", "cumulus: skirt: inflated particles, alpha 0",
              "cumulus: mega-particles, alpha 1", "cumulus: tent, right and down by half a texel",
              "cumulus: tent, left and up by half a texel", "cumulus: downsample 2:1 (box filter)",
              "cumulus: tent, right and down by half a texel", "cumulus: tent, left and up by half a texel",
              "cumulus: upsample 1:2 (bilinear)", "cumulus: tent, right and down by half a texel",
              "cumulus: tent, left and up by half a texel", "cumulus: fractal box: erode and composite"});
    // In the words of `nimbus7 dump`.
    const std::string text = to_text(frame);
    for (const char* words :
         {"\"mega-particles 1/2\" { width 176 height 112 }", "\"depth 1/2\" { format D24 width 176 height 112 }",
          "\"scene, depth at 1/2\" {\n        depth \"depth 1/2\"\n        clear { depth 1 }"})
        CHECK_THAT(text, Catch::Contains(words));
    CHECK(parse_frame(text) == frame);
    const Pass &depth = frame.passes[1], &spheres = frame.passes[3];
    const auto size_of = [&](TargetId id) {
        const Target& target = frame.targets[static_cast<std::size_t>(id.index)];
        return std::array{target.width, target.height};
    };
    CHECK_FALSE(depth.color);
    CHECK(depth.clear.depth == 1.0f);
    CHECK(spheres.depth == depth.depth);
    CHECK(size_of(spheres.color) == std::array{176, 112});
    CHECK(size_of(depth.depth) == std::array{176, 112});
    CHECK(spheres.camera == frame.passes[2].camera);
    CHECK_FALSE(spheres.camera == pass_named(frame, "fractal box").camera);
    CHECK(triangles_of(frame, "alpha 1") == triangles_of(full, "alpha 1"));
    const Pass& box = pass_named(frame, "fractal box");
    CHECK(box.color == frame.output);
    CHECK(box.state.stages[0].filter == TextureFilter::Linear);
    CHECK(pass_named(full, "fractal box").state.stages[0].filter == TextureFilter::Point);
}

// Where the parabola through three distances has its foot is how far a cloud has moved. Had small pixels other centres
// than they stand for, that would be half a pixel of the picture or more; what is left as a mean of four views is chance,
// by which spheres' edges fall between small pixels: 0.06 pixels at scale 4, in eight views.
TEST_CASE("at a smaller scale the cloud stands where it stood, and the wall hides what it hid", "[cloud]") {
    Cloud cloud  = cumulus();
    cloud.blur_m = 3.0f;
    std::tie(cloud.mode, cloud.detail, cloud.opacity) =
        GENERATE(std::tuple{Mode::Skirt, Detail::Fractal, 1.0f}, std::tuple{Mode::Skirt, Detail::Displacement, 1.0f},
                 std::tuple{Mode::Skirt, Detail::Fractal, 0.6f}, std::tuple{Mode::Article, Detail::Fractal, 1.0f},
                 std::tuple{Mode::Premultiplied, Detail::Fractal, 0.6f}, std::tuple{Mode::Black, Detail::None, 1.0f});
    const int scale = GENERATE(2, 4);
    INFO("mode " << static_cast<int>(cloud.mode) << ", detail " << static_cast<int>(cloud.detail) << ", scale " << scale
                 << ", opacity " << cloud.opacity);
    double moved_x = 0.0, moved_y = 0.0;
    for (const float x : {-21.3f, -4.1f, 5.9f, 17.3f}) {
        const View view          = look(Vec3(x, 58.0f, 170.0f), Vec3(0.1f * x, 60.0f, 0.0f), 333, 211);
        const ColorImage full    = execute(frame_of(cloud, {}, view)).output;
        const ColorImage reduced = execute(frame_of(cloud, {.target_scale = scale}, view)).output;
        const double here        = squares(reduced, full, 0, 0);
        CHECK(std::sqrt(here / (full.width * full.height)) < 3.0);
        const auto foot = [&](int dx, int dy) {
            const double after = squares(reduced, full, dx, dy), before = squares(reduced, full, -dx, -dy);
            return (before - after) / (2.0 * (before - 2.0 * here + after));
        };
        moved_x += foot(1, 0) / 4.0, moved_y += foot(0, 1) / 4.0;
    }
    CHECK(std::abs(moved_x) < 0.25);
    CHECK(std::abs(moved_y) < 0.25);
}

TEST_CASE("the article's scene copy is reduced as the target is", "[cloud]") {
    Cloud cloud       = cumulus();
    cloud.mode        = Mode::Article;
    const int scale   = GENERATE(1, 2, 4);
    const Frame frame = frame_of(cloud, {.target_scale = scale});
    const Pass& pass  = pass_named(frame, "copy the back buffer");
    const auto& copy  = std::get<DrawRectangle>(pass.draws.at(0));
    CHECK(copy.x0 == 0.0f);
    CHECK(copy.y0 == 0.0f);
    CHECK(copy.uv[0].u1 * 333.0f / copy.x1 == Approx(scale));
    CHECK(copy.uv[0].v1 * 211.0f / copy.y1 == Approx(scale));
    CHECK(copy.x1 * static_cast<float>(scale) >= 333.0f);
    CHECK(pass.state.stages[0].filter == (scale == 1 ? TextureFilter::Point : TextureFilter::Linear));
}

// 208 rows are whole texels of the coarsest level, but the pyramid has 224. Below the picture a full target repeats its
// last row and a smaller one goes on, which is 5 steps here; were it empty there, it would be 75.
TEST_CASE("at a smaller scale a cloud that fills the picture does so up to its edges", "[cloud]") {
    Cloud cloud              = cumulus();
    cloud.detail             = Detail::None;
    cloud.blur_m             = 3.0f;
    const View view          = look(Vec3(0.0f, 62.0f, 40.0f), Vec3(0.0f, 62.0f, 0.0f), 320, 208);
    const int scale          = GENERATE(2, 4);
    const ColorImage full    = execute(frame_of(cloud, {}, view)).output;
    const ColorImage reduced = execute(frame_of(cloud, {.target_scale = scale}, view)).output;
    int sum                  = 0;  // what is chance goes either way
    for (int x = 0; x < 320; ++x) sum += green(full, x, 207) - green(reduced, x, 207);
    CHECK(std::abs(sum) < 10 * 320);
}

TEST_CASE("without a skirt only its clear is left", "[cloud]") {
    const Frame with = frame_of(cumulus(), {}), without = frame_of(cumulus(), {.skirt = false});
    CHECK(with.passes.size() == without.passes.size());
    const Pass& clear = pass_named(without, "clear to the mean colour, alpha 0");
    CHECK(clear.draws.empty());
    CHECK(clear.clear == pass_named(with, "skirt").clear);
    CHECK(clear.color == pass_named(with, "skirt").color);
    CHECK(clear.state.scissor == pass_named(with, "skirt").state.scissor);
    CHECK(pass_named(with, "alpha 1").draws.size() == pass_named(without, "alpha 1").draws.size());
}

TEST_CASE("spheres are subdivided less, as far as there are levels", "[cloud]") {
    Cloud cloud        = cumulus();
    cloud.particles    = {{.center = Vec3(0.0f, 60.0f, 0.0f), .radius = 18.0f}};
    cloud.blur_m       = 3.0f;
    const auto spheres = [&](int fewer) {
        return triangles_of(frame_of(cloud, {.fewer_sphere_levels = fewer}), "alpha 1");
    };
    const std::uint32_t chosen = spheres(0);
    CHECK(chosen > 20);
    CHECK(chosen < 1280);
    CHECK(4 * spheres(1) == chosen);
    CHECK(spheres(3) == 20);
}
