// SPDX-License-Identifier: MIT
// Clouds that share passes give the picture, the depth and the counts that each gives by itself.
#include "cloud/mega_particles/share_passes.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <set>

#include "cloud/mega_particles/mega_particles.h"
#include "pipeline/execute/execute.h"
#include "pipeline/profile/profile.h"
#include "pipeline/validate/validate.h"
#include "tests/cloud/cumulus.h"
#include "tests/cloud/walled_scene.h"

using namespace cloud;
using namespace pipeline;

namespace {

// A sky, a wall of some depth, the clouds; then steps through the depth that is left, each of which adds 4 to what is
// before it, so that the picture shows all of the depth buffer too.
Frame frame_of(const std::vector<BakedCloud>& clouds, const View& view, Passes passes, bool shows_depth = true) {
    const float width = static_cast<float>(view.width), height = static_cast<float>(view.height);
    Frame frame        = walled_scene(view, {0xff305090}, {0.4f * width, 0.8f * height, 0.9978f, {0xffa02000}});
    SceneTargets scene = kWalledTargets;
    scene.fog          = {.mode = FogMode::Linear, .color = {0xff8090a0}, .end = 900.0f};
    append_mega_particles(frame, scene, view, clouds, {.passes = passes});
    if (!shows_depth) return frame;
    Pass steps        = frame.passes.front();
    steps.label       = "depth";
    steps.clear       = {};
    steps.state.depth = {.func = CompareFunc::LessEqual, .write = false};
    steps.state.blend = {.source = BlendFactor::One, .dest = BlendFactor::One};
    steps.draws.clear();
    for (int step = 0; step < 60; ++step) {
        DrawRectangle all;
        all.x1    = width;
        all.y1    = height;
        all.depth = 1.0f - 0.0001f * static_cast<float>(step);
        all.color = {0x00000004};
        steps.draws.push_back(all);
    }
    frame.passes.push_back(steps);
    return frame;
}

struct Drawn {
    ColorImage picture;
    std::uint64_t blended = 0, texels = 0, bytes = 0;
    std::size_t passes = 0;
};
Drawn draw(Frame frame, const Arithmetic& arithmetic = {}) {
    frame.arithmetic = arithmetic;
    for (const Finding& finding : validate(frame)) FAIL_CHECK(finding.where + ": " + finding.what);
    const Execution execution = execute(frame);
    Drawn drawn{.picture = execution.output, .passes = frame.passes.size()};
    for (const PassCounts& counts : execution.counts) {
        drawn.blended += counts.blended;
        drawn.texels += counts.texels;
        drawn.bytes += counts.bytes;
    }
    return drawn;
}

std::vector<std::string> cloud_labels(const Frame& frame) {
    std::vector<std::string> labels;
    for (const Pass& pass : frame.passes)
        if (pass.label.find(": ") != std::string::npos) labels.push_back(pass.label);
    return labels;
}

// Three balls at a place in the world, in a box that ends before they do: all of it is seen within their bounds.
Cloud puff(const std::string& name, Vec3 middle, float size = 1.0f) {
    Cloud cloud;
    cloud.name = name;
    for (const Vec3 offset : {Vec3(0.0f), Vec3(-9.0f, -2.0f, 1.0f), Vec3(8.0f, -1.0f, -2.0f)})
        cloud.particles.push_back({.center = middle + offset * size, .radius = 7.0f * size, .color = Vec3(0.9f)});
    cloud.blur_m            = 0.4f;
    cloud.fractal.face_size = 16;
    cloud.box               = Box{middle - 6.0f * size, middle + 6.0f * size};
    return cloud;
}

std::vector<BakedCloud> baked(const std::vector<Cloud>& clouds) {
    std::vector<BakedCloud> all;
    for (const Cloud& cloud : clouds) all.push_back(bake(cloud, Daylight{}));
    return all;
}

const View kFront = look(Vec3(0.0f, 0.0f, 200.0f), Vec3(0.0f));

std::vector<std::string> labels_of(const std::vector<Cloud>& clouds, const View& view = kFront) {
    return cloud_labels(frame_of(baked(clouds), view, Passes::Shared, false));
}

// Does a pass of that label's beginning exist?
bool any_starts(const std::vector<std::string>& labels, const std::string& with) {
    return std::any_of(labels.begin(), labels.end(), [&](const std::string& l) { return l.rfind(with, 0) == 0; });
}

// U of raster/sampling_rules.h for each pixel of `area`, along x.
std::vector<std::int64_t> columns(const DrawRectangle& rectangle, int width, int center, int x0, int x1) {
    const double w0 = static_cast<double>(rectangle.uv[0].u0) * width,
                 w1 = static_cast<double>(rectangle.uv[0].u1) * width;
    const double X0 = rectangle.x0 * 16.0, X1 = rectangle.x1 * 16.0;
    const double du   = (w1 - w0) * std::ldexp(1.0, 36) / (X1 - X0);
    const auto step   = static_cast<std::int64_t>(std::nearbyint(du));
    const auto origin = static_cast<std::int64_t>(std::nearbyint(w0 * std::ldexp(1.0, 32) + (center - X0) / 16 * du));
    const auto rounded_16 = [](std::int64_t p) { return (p + (1 << 15)) >> 16; };
    std::vector<std::int64_t> u;
    for (int x = x0; x < x1; ++x) {
        const int block = x & -16;
        u.push_back((rounded_16(origin + block * step) + (x - block) * rounded_16(step)) >> 8);
    }
    return u;
}

}  // namespace

TEST_CASE("a cut blit reads what the whole one reads, wherever it is cut", "[cloud][share]") {
    std::mt19937 random(5);
    const int width   = GENERATE(32, 333, 352, 640, 736, 1088, 1280, 1922, 4999, 8192);
    const float scale = GENERATE(0.5f, 1.0f, 2.0f);
    const float shift = GENERATE(-0.5f, 0.0f, 0.5f);
    const int center  = GENERATE(0, 8, 9);  // of the pixel: Direct3D's, the frame's, the GameCube's
    const int pixels  = static_cast<int>(static_cast<float>(width) * scale);
    const int target  = std::min(pixels, kMaxTargetSize);
    Frame frame;
    frame.targets = {{.name = "source", .width = width, .height = width}};
    DrawRectangle whole;
    whole.x0 = whole.y0 = shift;
    whole.x1 = whole.y1      = shift + std::min(2.0f * scale * static_cast<float>(width), 16000.0f);
    const float times        = (whole.x1 - shift) / (scale * static_cast<float>(width));
    whole.uv[0]              = {.u1 = times, .v1 = times};
    whole.textures[0].target = {0};
    if (times != 2.0f && times != 1.0f) return;  // too large for a blit
    for (int i = 0; i < 40; ++i) {
        int x0 = std::uniform_int_distribution(0, target - 1)(random),
            x1 = std::uniform_int_distribution(x0 + 1, target)(random);
        if (i % 2 == 0) x1 = std::min(x0 + 1 + i % 7, target);  // narrow ones
        const DrawRectangle cut = cut_rectangle(frame, whole, {x0, x0, x1, x1});
        CHECK(cut.x0 == std::max(static_cast<float>(x0), shift));
        CHECK(cut.x1 == static_cast<float>(x1));
        CHECK(cut.uv[0].u0 == cut.uv[0].v0);
        CHECK(cut.uv[0].u1 == cut.uv[0].v1);
        INFO(width << " texels, " << scale << ", " << shift << ", " << center << ": " << x0 << " to " << x1);
        REQUIRE((columns(cut, width, center, x0, x1) == columns(whole, width, center, x0, x1)));
    }
}

TEST_CASE("two clouds side by side share every pass", "[cloud][share]") {
    const std::vector<std::string> labels = labels_of({puff("a", {-40, 0, 0}), puff("b", {40, 0, 0})});
    CHECK(labels == std::vector<std::string>{
                        "a, b: clear, each in its own colour",
                        "a, b: skirt: inflated particles, alpha 0",
                        "a, b: mega-particles, alpha 1",
                        "a, b: downsample 2:1 (box filter)",
                        "a, b: tent, right and down by half a texel",
                        "a, b: tent, left and up by half a texel",
                        "a, b: upsample 1:2 (bilinear)",
                        "a, b: fractal box: erode and composite",
                    });
    const Frame frame = frame_of(baked({puff("a", {-40, 0, 0}), puff("b", {40, 0, 0})}), kFront, Passes::Shared, false);
    CHECK(frame.passes[2].draws.size() == 2);   // the skirts
    CHECK(frame.passes[4].draws.size() == 2);   // rectangles
    CHECK(frame.passes[8].draws.size() == 12);  // sides of two boxes
}

TEST_CASE("a cloud alone has the passes that it always had", "[cloud][share]") {
    const std::vector<BakedCloud> one = baked({puff("a", {0, 0, 0})});
    CHECK(frame_of(one, kFront, Passes::Shared) == frame_of(one, kFront, Passes::OneByOne));
    // Two that meet in the picture have nothing in common either.
    const std::vector<BakedCloud> two = baked({puff("a", {-4, 0, 0}), puff("b", {4, 0, 40})});
    CHECK(frame_of(two, kFront, Passes::Shared) == frame_of(two, kFront, Passes::OneByOne));
}

TEST_CASE("long lists of names are cut", "[cloud][share]") {
    const auto row = [](int count) {
        std::vector<Cloud> clouds;
        for (int i = 0; i < count; ++i)  // nearer ones last
            clouds.push_back(puff(std::string(1, static_cast<char>('a' + i)), Vec3(-60 + 40 * i, 0, i), 0.5f));
        return clouds;
    };
    CHECK(any_starts(labels_of(row(3)), "a, b, c: mega-particles"));
    const auto ends = [](const std::string& l) { return l.ends_with(" and 2 more: mega-particles, alpha 1"); };
    const std::vector<std::string> four = labels_of(row(4));
    CHECK(std::count_if(four.begin(), four.end(), ends) == 1);
}

TEST_CASE("a cloud goes with the first clouds past those that it meets", "[cloud][share]") {
    // Far to near: b lies across a, c beside both.
    const std::vector<Cloud> clouds{puff("a", {-30, 0, -60}), puff("b", {-24, 0, -20}), puff("c", {40, 0, 20})};
    const std::vector<std::string> labels = labels_of(clouds);
    CHECK(any_starts(labels, "a, c: "));
    CHECK_FALSE(any_starts(labels, "b, c: "));
    CHECK(labels.back().rfind("b: ", 0) == 0);
    // Across a and b, it comes after both.
    const std::vector<std::string> chain =
        labels_of({puff("a", {-30, 0, -60}), puff("b", {-24, 0, -20}), puff("c", {-18, 0, 20})});
    CHECK_FALSE(std::any_of(chain.begin(), chain.end(), [](const std::string& l) { return l.find(", ") < 3; }));
}

TEST_CASE("what differs between clouds keeps passes apart, and no more than those", "[cloud][share]") {
    const auto beside = [](auto&& change) {
        Cloud other = puff("b", {40, 0, 1});
        change(other);
        return labels_of({puff("a", {-40, 0, 0}), other});
    };
    const auto all = beside([](Cloud&) {});
    const auto has = [](const std::vector<std::string>& labels, const char* label) {
        return std::find(labels.begin(), labels.end(), label) != labels.end();
    };
    CHECK(all.size() == 8);

    // Around the particles, the box is seen beyond the bounds, and needs its own scissor.
    const auto boxed = beside([](Cloud& c) { c.box.reset(); });
    CHECK(boxed.size() == 9);
    CHECK(has(boxed, "a: fractal box: erode and composite"));
    CHECK(has(boxed, "b: fractal box: erode and composite"));

    const auto wider = beside([](Cloud& c) { c.blur_m = 2.5f; });  // a level more, or tents
    CHECK(wider.size() > 8);
    CHECK(has(wider, "a, b: downsample 2:1 (box filter)"));
    CHECK(has(wider, "a, b: upsample 1:2 (bilinear)"));
    CHECK(has(wider, "b: tent, left and up by half a texel"));

    const auto tinted = beside([](Cloud& c) { c.tint = Vec3(1.0f, 0.5f, 0.5f); });  // another texture factor
    CHECK(has(tinted, "a, b: mega-particles, alpha 1"));
    CHECK(has(tinted, "a: fractal box: erode and composite"));
    CHECK(has(tinted, "b: fractal box: erode and composite"));

    const auto article = beside([](Cloud& c) { c.mode = Mode::Article; });  // lit by the pipeline
    CHECK(has(article, "a: mega-particles, alpha 1"));
    CHECK(has(article, "b: mega-particles, alpha 1"));
    CHECK(has(article, "a: skirt: inflated particles, alpha 0"));
    CHECK_FALSE(any_starts(article, "a: clear"));  // which goes back to the skirt

    const auto displaced = beside([](Cloud& c) { c.detail = Detail::Displacement; });  // it reads beyond its halo
    CHECK_FALSE(any_starts(displaced, "a, b"));
    const auto translucent = beside([](Cloud& c) { c.opacity = 0.5f; });
    CHECK(has(translucent, "a, b: skirt: inflated particles, alpha 0"));
    CHECK(has(translucent, "b: composite (SRCALPHA, INVSRCALPHA)"));
}

TEST_CASE("inside a cloud, whose whiteout lies over all, none shares with it", "[cloud][share]") {
    const View inside = look(Vec3(-40.0f, 0.0f, 7.5f), Vec3(-40.0f, 0.0f, -300.0f));
    CHECK_FALSE(any_starts(labels_of({puff("a", {-40, 0, 0}), puff("b", {60, 0, -300})}, inside), "b, a"));
}

TEST_CASE("a whiteout lies over what is behind its cloud alone, though that is beside it", "[cloud][share]") {
    // One to the right and, a little nearer, one to the left, both close by; the eye is about to enter the first.
    const auto close = [](const std::string& name, float side, float distance, float blur_m) {
        Cloud cloud = puff(name, Vec3(side * distance * 0.7314f, 0.0f, -distance * 0.6820f));  // 47 degrees
        cloud.particles.resize(1);
        cloud.particles[0].color = Vec3(side > 0.0f ? 1.0f : 0.2f, 0.5f, 0.5f);
        cloud.lumpiness          = 0.0f;
        cloud.blur_m             = blur_m;
        return cloud;
    };
    const View view                   = look(Vec3(0.0f), Vec3(0.0f, 0.0f, -1.0f));
    const std::vector<BakedCloud> two = baked({close("a", 1.0f, 10.95f, 0.7f), close("b", -1.0f, 10.9f, 0.01f)});
    const Frame shared                = frame_of(two, view, Passes::Shared);
    CHECK(any_starts(cloud_labels(shared), "a: whiteout"));
    CHECK_FALSE(any_starts(cloud_labels(shared), "b: whiteout"));
    CHECK((draw(shared).picture.pixels == draw(frame_of(two, view, Passes::OneByOne)).picture.pixels));
}

TEST_CASE("clouds close to each other share as soon as neither reads what the other writes", "[cloud][share]") {
    const float blur_m = GENERATE(0.4f, 3.0f);
    int sharing        = 0;
    for (int step = 0; step < 24; ++step) {
        std::vector<Cloud> clouds{puff("a", {-20, 0, 0}), puff("b", {20.0f + 1.4f * static_cast<float>(step), 0, 1})};
        for (std::size_t i = 0; i < 2; ++i) {
            clouds[i].blur_m = blur_m;
            for (Particle& particle : clouds[i].particles) particle.color = i == 0 ? Vec3(1, 0, 0) : Vec3(0, 0, 1);
        }
        const std::vector<BakedCloud> two = baked(clouds);
        const Frame shared = frame_of(two, kFront, Passes::Shared), apart = frame_of(two, kFront, Passes::OneByOne);
        INFO("step " << step);
        CHECK((draw(shared).picture.pixels == draw(apart).picture.pixels));
        sharing += shared.passes.size() < apart.passes.size();
    }
    CHECK(sharing > 3);
    CHECK(sharing < 24);
}

TEST_CASE("shared passes give the same picture, depth, blends, texels and bytes", "[cloud][share]") {
    const auto seed = static_cast<std::uint32_t>(GENERATE(range(1, 13)));
    std::mt19937 random(seed);
    const auto between = [&](float low, float high) { return std::uniform_real_distribution(low, high)(random); };
    const auto one_of  = [&](int count) { return std::uniform_int_distribution(0, count - 1)(random); };
    const bool mixed   = seed % 3 == 0;  // of all kinds, or of one
    std::vector<Cloud> clouds;
    for (int i = 0; i < 8; ++i) {
        Cloud cloud = puff("cloud " + std::to_string(i), {between(-150, 150), between(-70, 70), between(-250, 60)},
                           between(0.5f, 1.4f));
        for (Particle& particle : cloud.particles) particle.color = Vec3(between(0, 1), between(0, 1), 1);
        cloud.blur_m = between(0.5f, 2.5f);
        if (one_of(2) == 0) cloud.box.reset();
        if (mixed || seed % 3 == 1) {
            const int kind = mixed ? one_of(9) : static_cast<int>(seed) % 9;
            if (kind == 1) cloud.mode = Mode::Article;
            if (kind == 2) cloud.mode = Mode::Premultiplied;
            if (kind == 3) cloud.mode = Mode::Black;
            if (kind == 4) cloud.order = Order::OrderFree;
            if (kind == 5) cloud.opacity = 0.6f;
            if (kind == 6) cloud.second_box_turn = Turn(0.8f, 0.6f);
            if (kind == 7) cloud.detail = Detail::Displacement, cloud.displacement = 6.0f;
            if (kind == 8) cloud.detail = Detail::None, cloud.tint = Vec3(0.8f, 1.0f, 0.6f);
        }
        clouds.push_back(cloud);
    }
    const std::vector<BakedCloud> all = baked(clouds);
    bool shared                       = false;  // never if all read beyond their halos
    const bool only_displaced         = std::all_of(clouds.begin(), clouds.end(),
                                                    [](const Cloud& cloud) { return cloud.detail == Detail::Displacement; });
    for (const float along : {0.0f, 0.35f, 0.7f, 1.0f}) {
        const View view        = look(Vec3(30.0f * along, 5.0f, 240.0f - 200.0f * along),
                                      Vec3(60.0f * along - 20.0f, 0.0f, -150.0f), 317, 203);
        const Drawn one_by_one = draw(frame_of(all, view, Passes::OneByOne)),
                    drawn      = draw(frame_of(all, view, Passes::Shared));
        INFO("seed " << seed << ", " << along << " of the way: " << one_by_one.passes << " and " << drawn.passes);
        CHECK((drawn.picture.pixels == one_by_one.picture.pixels));
        CHECK(drawn.passes <= one_by_one.passes);
        CHECK(drawn.blended == one_by_one.blended);
        CHECK(drawn.texels == one_by_one.texels);
        CHECK(drawn.bytes == one_by_one.bytes);
        shared |= drawn.passes < one_by_one.passes;
    }
    CHECK(shared != only_displaced);
}

TEST_CASE("they do wherever chips sample pixels and however they filter", "[cloud][share]") {
    std::vector<Cloud> clouds;
    for (int i = 0; i < 6; ++i)
        clouds.push_back(puff("cloud " + std::to_string(i), {-75 + 30 * i, 20 * (i % 3), -40 * i}, 0.8f));
    const std::vector<BakedCloud> all = baked(clouds);
    for (const Profile& profile : profiles()) {
        INFO(profile.name);
        Arithmetic arithmetic;
        arithmetic.snap         = profile.arithmetic.snap;
        arithmetic.pixel_center = profile.arithmetic.pixel_center;
        arithmetic.gouraud      = profile.arithmetic.gouraud;
        arithmetic.filter       = profile.arithmetic.filter;
        const Drawn one_by_one  = draw(frame_of(all, kFront, Passes::OneByOne), arithmetic);
        const Drawn shared      = draw(frame_of(all, kFront, Passes::Shared), arithmetic);
        CHECK(shared.passes < one_by_one.passes);
        CHECK((shared.picture.pixels == one_by_one.picture.pixels));
    }
}
