// SPDX-License-Identifier: MIT
#include "cloud/mega_particles/mega_particles.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <random>

#include "cloud/mega_particles/draw_particles.h"
#include "cloud/mega_particles/fractal_box.h"
#include "pipeline/execute/execute.h"
#include "pipeline/validate/validate.h"
#include "tests/cloud/cumulus.h"

using namespace cloud;
using namespace pipeline;

namespace {

// A blue sky, and a red wall that fills the picture up to its middle column at the given depth-buffer value.
Frame scene_frame(const View& view, float wall_depth, SceneTargets& scene) {
    Frame frame;
    frame.targets = {{.name = "back buffer", .width = view.width, .height = view.height},
                     {.name = "depth", .format = TargetFormat::D24, .width = view.width, .height = view.height}};
    frame.cameras = {{.name = "camera", .view = view.view, .projection = view.projection}};
    frame.output = scene.back_buffer = {0};
    scene.depth                      = {1};
    scene.camera                     = {0};
    Pass& pass                       = frame.passes.emplace_back();
    pass.label                       = "scene";
    pass.color                       = scene.back_buffer;
    pass.depth                       = scene.depth;
    pass.clear                       = {.color = Argb{0xff4060ff}, .depth = 1.0f};
    pass.state.depth                 = {.func = CompareFunc::LessEqual, .write = true};
    DrawRectangle wall;
    wall.x1    = static_cast<float>(view.width / 2);
    wall.y1    = static_cast<float>(view.height);
    wall.depth = wall_depth;
    wall.color = {0xffff0000};
    pass.draws = {wall};
    return frame;
}

Frame cloud_frame(const std::vector<Cloud>& clouds, const View& view, float wall_depth = 1.0f) {
    SceneTargets scene;
    Frame frame = scene_frame(view, wall_depth, scene);
    append_mega_particles(frame, scene, view, Daylight{}, clouds);
    return frame;
}

std::vector<std::string> labels(const Frame& frame) {
    std::vector<std::string> all;
    for (const Pass& pass : frame.passes) all.push_back(pass.label);
    return all;
}

const Pass& pass_named(const Frame& frame, const std::string& part) {
    const auto found = std::find_if(frame.passes.begin(), frame.passes.end(),
                                    [&](const Pass& pass) { return pass.label.find(part) != std::string::npos; });
    if (found == frame.passes.end()) throw std::runtime_error("no pass " + part);
    return *found;
}

const Target& target_of(const Frame& frame, TargetId id) {
    return frame.targets[static_cast<std::size_t>(id.index)];
}

const View kFront = look(Vec3(0.0f, 58.0f, 170.0f), Vec3(0.0f, 60.0f, 0.0f));

}  // namespace

TEST_CASE("frames of clouds are valid: both modes, odd sizes, inside, far away, translucent") {
    std::vector<Cloud> clouds{cumulus(), cumulus()};
    clouds[0].mode    = GENERATE(Mode::Skirt, Mode::Article);
    clouds[1].opacity = GENERATE(1.0f, 0.5f);
    for (Particle& p : clouds[1].particles) p.center.z -= 150.0f;
    const float z     = GENERATE(5000.0f, 170.0f, 45.0f, 18.5f, 0.0f);
    const View view   = look(Vec3(0.0f, 60.0f, z), Vec3(2.0f, 60.0f, -300.0f), 333, 211);
    const Frame frame = cloud_frame(clouds, view);
    CHECK(frame.passes.size() > 8);
    for (const Finding& finding : validate(frame)) FAIL_CHECK(finding.where + ": " + finding.what);

    const View largest = look(Vec3(0.0f, 60.0f, z), Vec3(2.0f, 60.0f, -300.0f), kMaxTargetSize, kMaxTargetSize);
    CHECK(validate(cloud_frame(clouds, largest)).empty());
}

TEST_CASE("article mode is the article's passes in their order") {
    Cloud cloud       = cumulus();
    cloud.mode        = Mode::Article;
    cloud.blur_m      = 1.3f;  // 2.2 px: two levels
    cloud.opacity     = 0.5f;
    const Frame frame = cloud_frame({cloud}, kFront);
    CHECK(labels(frame) ==
          std::vector<std::string>{"scene", "cumulus: copy the back buffer, alpha 0",
                                   "cumulus: mega-particles, alpha 1", "cumulus: downsample 2:1 (box filter)",
                                   "cumulus: downsample 2:1 (box filter)", "cumulus: upsample 1:2 (bilinear)",
                                   "cumulus: upsample 1:2 (bilinear)", "cumulus: fractal box: multiply alpha only",
                                   "cumulus: composite (SRCALPHA, INVSRCALPHA)"});
    const Pass& spheres = frame.passes[2];
    CHECK(spheres.depth == TargetId{1});
    CHECK(spheres.state.depth == DepthState{CompareFunc::LessEqual, true});
    CHECK(spheres.state.lighting.enabled);
    CHECK(spheres.state.blend == kReplace);
    CHECK(frame.passes[1].color == spheres.color);
    const Pass& box = frame.passes[7];
    CHECK(box.state.blend == kMultiply);
    CHECK(box.state.color_mask == ColorMask{false, false, false, true});
    CHECK(box.state.depth == DepthState{});
    CHECK(box.draws.size() == 6);
    CHECK(frame.passes[8].color == frame.output);
    CHECK(frame.passes[8].state.blend == kAlphaOver);
    CHECK(frame.passes[8].state.texture_factor.value >> 24 == 128);
}

TEST_CASE("each step down halves exactly, each step up doubles, and tents cancel their shift") {
    Cloud cloud       = cumulus();
    cloud.blur_m      = GENERATE(0.5f, 1.6f, 5.0f, 12.0f);
    const Frame frame = cloud_frame({cloud}, look(Vec3(0.0f, 58.0f, 170.0f), Vec3(0.0f, 60.0f, 0.0f), 333, 211));
    double shift      = 0.0;
    int downs = 0, ups = 0, tents = 0;
    for (const Pass& pass : frame.passes) {
        const bool down = pass.label.find("downsample") != std::string::npos;
        const bool up   = pass.label.find("upsample") != std::string::npos;
        const bool tent = pass.label.find("tent") != std::string::npos;
        downs += down, ups += up, tents += tent;
        if (!down && !up && !tent) continue;
        const auto& rectangle = std::get<DrawRectangle>(pass.draws.at(0));
        const Target &from = target_of(frame, rectangle.textures[0].target), &to = target_of(frame, pass.color);
        const auto texel_at = [&](double px) {
            return (px - rectangle.x0) * from.width * rectangle.uv[0].u1 / (rectangle.x1 - rectangle.x0);
        };
        for (double x : {0.5, 1.5, to.width - 0.5}) {
            if (down) CHECK(texel_at(x) == 2.0 * x);
            if (up) CHECK(texel_at(x) == 0.5 * x);
            if (tent) CHECK(std::abs(texel_at(x) - x) == 0.5);
        }
        if (tent) shift += texel_at(0.5) - 0.5;
        CHECK(rectangle.x0 <= 0.5f);
        CHECK(rectangle.x1 >= static_cast<float>(to.width));
        CHECK(rectangle.y1 >= static_cast<float>(to.height));
        const Target& coarse = down ? to : from;
        const Target& fine   = down ? from : to;
        if (!tent) CHECK((fine.width == 2 * coarse.width || fine.width == 333));
        CHECK(pass.state.scissor.x1 <= to.width);
    }
    CHECK(downs == ups);
    CHECK(downs >= 1);
    CHECK(tents % 2 == 0);
    CHECK(shift == 0.0);
}

TEST_CASE("clouds are drawn farthest first by their nearest particle, whatever order they come in") {
    std::vector<Cloud> clouds{cumulus(), cumulus(), cumulus()};
    const float z[] = {-40.0f, 60.0f, -200.0f};
    for (std::size_t i = 0; i < 3; ++i) {
        clouds[i].name = std::string(1, static_cast<char>('a' + i));
        for (Particle& p : clouds[i].particles) p.center.z += z[i];
    }
    // The centre of b is the nearest; one particle of c makes c nearer.
    clouds[2].particles.push_back({.center = Vec3(5.0f, 60.0f, 110.0f), .radius = 10.0f});
    std::string order;
    for (const std::string& label : labels(cloud_frame(clouds, kFront)))
        if (label.find("alpha 1") != std::string::npos) order += label[0];
    CHECK(order == "abc");
    const ColorImage picture = execute(cloud_frame(clouds, kFront)).output;
    std::swap(clouds[0], clouds[2]);
    CHECK(execute(cloud_frame(clouds, kFront)).output == picture);
}

TEST_CASE("a baked cloud gives the same frame, and one out of view or fully clear gives none") {
    const Cloud cloud = cumulus();
    SceneTargets scene;
    Frame frame            = scene_frame(kFront, 1.0f, scene);
    const BakedCloud baked = bake(cloud, Daylight{});
    append_mega_particles(frame, scene, kFront, std::span(&baked, 1));
    CHECK(frame == cloud_frame({cloud}, kFront));
    CHECK(cloud_frame({cloud}, look(Vec3(0.0f, 58.0f, 170.0f), Vec3(0.0f, 60.0f, 300.0f))).passes.size() == 1);
    CHECK(cloud_frame({Cloud{}}, kFront).passes.size() == 1);
    Cloud clear   = cloud;
    clear.opacity = 0.0f;
    CHECK(cloud_frame({clear}, kFront).passes.size() == 1);
}

TEST_CASE("numbers that make no sense are refused") {
    Cloud cloud = cumulus();
    SECTION("radius") {
        cloud.particles[3].radius = 0.0f;
    }
    SECTION("centre") {
        cloud.particles[3].center.y = std::numeric_limits<float>::quiet_NaN();
    }
    SECTION("blur") {
        cloud.blur_m = std::numeric_limits<float>::infinity();
    }
    SECTION("face size") {
        cloud.fractal.face_size = 96;
    }
    SECTION("opacity") {
        cloud.opacity = 1.5f;
    }
    CHECK_THROWS_AS(bake(cloud, {}), std::invalid_argument);
    CHECK_THROWS_AS(bake({}, {.sky = Vec3(std::nanf(""))}), std::invalid_argument);
    CHECK_THROWS_AS(bake({}, {.to_sun = Vec3(1.0f)}), std::invalid_argument);
}

TEST_CASE("the box is drawn in one layer, from outside and from inside") {
    Cloud cloud     = cumulus();
    const auto cull = [&](float z) {
        const View view = look(Vec3(0.0f, 60.0f, z), Vec3(2.0f, 60.0f, -300.0f));
        return pass_named(cloud_frame({cloud}, view), "fractal box").state.cull;
    };
    CHECK(cull(170.0f) == CullMode::Clockwise);
    CHECK(cull(0.0f) == CullMode::CounterClockwise);
    cloud.mode = Mode::Article;
    CHECK(cull(170.0f) == CullMode::Clockwise);
    CHECK(cull(0.0f) == CullMode::None);
}

TEST_CASE("projected coordinates are those of the pixel") {
    std::mt19937 random(3);
    const Mat4 texture = screen_coordinates(kFront.projection);
    for (int i = 0; i < 200; ++i) {
        const Vec4 camera(static_cast<float>(random() % 200) - 100.0f, static_cast<float>(random() % 200) - 100.0f,
                          -1.0f - static_cast<float>(random() % 500), 1.0f);
        const Vec4 clip = kFront.projection * camera, uv = texture * camera;
        CHECK(uv.x / uv.z == Approx((1.0f + clip.x / clip.w) / 2.0f).margin(1e-5));
        CHECK(uv.y / uv.z == Approx((1.0f - clip.y / clip.w) / 2.0f).margin(1e-5));
    }
}

TEST_CASE("the pipeline's lights add up to wrapped sun and a hemisphere of sky and bounce") {
    const Daylight day;
    const LightingState state = daylight_state(day);
    CHECK(state.lights.size() == 4);
    for (const Vec3 direction :
         {Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(1, 0.3f, -2), Vec3(-0.5f, -0.7f, -0.5f), Vec3(0.1f, 0, 1)}) {
        const Vec3 n = glm::normalize(direction);
        Vec3 light   = state.ambient;
        for (const Light& each : state.lights) light += each.diffuse * std::max(glm::dot(n, -each.direction), 0.0f);
        const Vec3 expected = day.sun * (0.5f + 0.5f * glm::dot(n, day.to_sun)) + day.sky * (0.5f + 0.5f * n.y) +
                              day.bounce * (0.5f - 0.5f * n.y);
        for (int channel = 0; channel < 3; ++channel) CHECK(light[channel] == Approx(expected[channel]).margin(1e-5));
    }
}

TEST_CASE("the picture: cloud in the middle, scene around it, opaque where it is thick, hidden by what is nearer") {
    Cloud cloud   = cumulus();
    cloud.mode    = GENERATE(Mode::Skirt, Mode::Article);
    const auto at = [](const ColorImage& image, int x, int y) {
        return image.pixels[static_cast<std::size_t>(y * image.width + x)];
    };
    const ColorImage behind = execute(cloud_frame({cloud}, kFront, 1.0f)).output;
    CHECK(at(behind, 5, 5) == 0xffff0000u);
    CHECK(at(behind, 310, 230) == 0xff4060ffu);
    const bool article = cloud.mode == Mode::Article;
    for (int x : {130, 150, 155, 165, 190}) {
        const std::uint32_t pixel = at(behind, x, 120);
        const int red = static_cast<int>(pixel >> 16 & 255), green = static_cast<int>(pixel >> 8 & 255),
                  blue = static_cast<int>(pixel & 255);
        INFO("column " << x << ": " << red << ", " << green << ", " << blue);
        // The article's multiplication lets up to 0.4 of the scene through.
        if (!article) CHECK(std::max({red, green, blue}) - std::min({red, green, blue}) < 60);
        CHECK(green > 60);
    }
    const ColorImage in_front = execute(cloud_frame({cloud}, kFront, 0.9f)).output;
    CHECK(at(in_front, 100, 120) == 0xffff0000u);
    CHECK(at(in_front, 200, 120) == at(behind, 200, 120));
    // From inside there is cloud everywhere.
    const ColorImage inside =
        execute(cloud_frame({cloud}, look(Vec3(0.0f, 60.0f, 0.0f), Vec3(1.0f, 60.0f, -3.0f)))).output;
    if (!article)
        for (std::uint32_t pixel : inside.pixels) REQUIRE((pixel >> 8 & 255) > 30);
}
