// SPDX-License-Identifier: MIT
#include "cloud/mega_particles/scaled_depth.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "pipeline/execute/execute.h"
#include "pipeline/validate/validate.h"
#include "tests/cloud/cumulus.h"

using namespace cloud;
using namespace pipeline;

namespace {

constexpr int kWidth = 333, kHeight = 211;
const View kView = look(Vec3(0.0f), Vec3(0.3f, 0.1f, -1.0f), kWidth, kHeight);
const std::array<Vec3, 3> kCorners{Vec3(-6.0f, -5.0f, -20.0f), Vec3(12.0f, -3.0f, -30.0f), Vec3(4.0f, 9.0f, -25.0f)};

// An empty scene of one pass, of depth 1.
Frame scene_frame() {
    Frame frame;
    frame.targets    = {{.name = "back buffer", .width = kWidth, .height = kHeight},
                        {.name = "depth", .format = TargetFormat::D24, .width = kWidth, .height = kHeight}};
    frame.cameras    = {{.name = "camera", .view = kView.view, .projection = kView.projection}};
    frame.output     = {0};
    Pass& pass       = frame.passes.emplace_back();
    pass.label       = "scene";
    pass.color       = {0};
    pass.depth       = {1};
    pass.camera      = {0};
    pass.clear       = {.color = Argb{0xff000000}, .depth = 1.0f};
    pass.state.depth = {.func = CompareFunc::LessEqual, .write = true};
    return frame;
}

void add_triangle(Frame& frame) {
    for (const Vec3 corner : kCorners) {
        frame.indices.push_back(static_cast<std::uint32_t>(frame.vertices.size()));
        frame.vertices.push_back({.position = corner});
    }
    frame.passes.back().draws.push_back(DrawTriangles{.index_count = 3});
}

// White where the small depth buffer holds more than `depth`.
ColorImage farther_than(Frame frame, int level, float depth) {
    const SceneTargets scene{.back_buffer = {0}, .depth = {1}, .camera = {0}, .fog = {}};
    const int width = round_up(kWidth, 32) >> level, height = round_up(kHeight, 32) >> level;
    const ScaledDepth scaled = append_scaled_depth(frame, scene, level, width, height, {0, 0, kWidth, kHeight});
    frame.output             = {static_cast<std::int32_t>(frame.targets.size())};
    frame.targets.push_back({.name = "seen", .width = width, .height = height});
    Pass& pass            = frame.passes.emplace_back();
    pass.color            = frame.output;
    pass.depth            = scaled.depth;
    pass.state.depth.func = CompareFunc::Less;
    DrawRectangle all;
    all.x1     = static_cast<float>(width);
    all.y1     = static_cast<float>(height);
    all.depth  = depth;
    pass.draws = {all};
    for (const Finding& finding : validate(frame)) FAIL_CHECK(finding.where + ": " + finding.what);
    return execute(frame).output;
}

// Calls check(x, y, is_nearer) with the point of the picture that each small pixel stands for.
template <class Check>
void for_pixels(const ColorImage& image, int level, Check&& check) {
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double px = (x + 0.5) * (1 << level), py = (y + 0.5) * (1 << level);
            if (px < kWidth && py < kHeight)
                check(px, py, image.pixels[static_cast<std::size_t>(y * image.width + x)] == 0u);
        }
}

// Distance in pixels of a point inside the triangle as `viewport` shows it from its nearest edge; negative outside.
double inside_triangle(double x, double y, const PixelRect& viewport) {
    std::array<std::array<double, 2>, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec4 clip = kView.projection * kView.view * Vec4(kCorners[i], 1.0f);
        p[i] = {viewport.x0 + (1.0 + static_cast<double>(clip.x / clip.w)) / 2.0 * (viewport.x1 - viewport.x0),
                viewport.y0 + (1.0 - static_cast<double>(clip.y / clip.w)) / 2.0 * (viewport.y1 - viewport.y0)};
    }
    double least = 1e9;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto &a = p[i], &b = p[(i + 1) % 3];
        const double ex = b[0] - a[0], ey = b[1] - a[1];
        least = std::min(least, (ey * (x - a[0]) - ex * (y - a[1])) / std::hypot(ex, ey));
    }
    return least;
}

}  // namespace

TEST_CASE("a small depth buffer holds the scene at the points its pixels stand for", "[cloud]") {
    const int level = GENERATE(1, 2);
    Frame frame     = scene_frame();
    PixelRect viewport{0, 0, kWidth, kHeight}, held = viewport;
    SECTION("in all of the picture") {}
    SECTION("through a viewport and a scissor") {
        frame.passes.back().state.viewport = viewport = {30, 41, 250, 190};
        frame.passes.back().state.scissor             = {63, 0, 333, 171};
        held                                          = {63, 41, 250, 171};
    }
    add_triangle(frame);
    int seen = 0;
    for_pixels(farther_than(frame, level, 0.9999f), level, [&](double x, double y, bool is_nearer) {
        // A clear, too, stays within the viewport; what nothing was written to is nearer than all.
        const bool is_held  = x >= held.x0 && x < held.x1 && y >= held.y0 && y < held.y1;
        const double inside = inside_triangle(x, y, viewport);
        if (is_held && std::abs(inside) < 0.5) return;  // corners are snapped to 1/16 of a small pixel
        ++seen;
        CHECK(is_nearer == (!is_held || inside > 0.0));
    });
    CHECK(seen > 1000);
}

TEST_CASE("rectangles, window triangles and alpha tests come to a small depth buffer as well", "[cloud]") {
    const int level = GENERATE(1, 2);
    Frame frame     = scene_frame();
    Pass& pass      = frame.passes.back();
    DrawRectangle wall{.x0 = 33.0f, .y0 = 20.5f, .x1 = 101.0f, .y1 = 140.0f, .depth = 0.5f};
    bool is_drawn = true;
    SECTION("rectangle") {
        pass.draws.push_back(wall);
    }
    SECTION("window triangles") {
        for (const std::uint32_t corner : {0u, 1u, 2u, 2u, 1u, 3u}) {
            frame.indices.push_back(static_cast<std::uint32_t>(frame.window_vertices.size()));
            frame.window_vertices.push_back(
                {.x = corner % 2 ? wall.x1 : wall.x0, .y = corner / 2 ? wall.y1 : wall.y0, .z = 0.5f});
        }
        pass.draws.push_back(DrawWindowTriangles{.index_count = 6});
    }
    SECTION("an alpha test that fails") {
        pass.state.alpha_test = {.func = CompareFunc::Greater, .reference = 200};
        wall.color            = {0x80ffffff};
        pass.draws.push_back(wall);
        is_drawn = false;
    }
    SECTION("a pass that writes no depth") {
        Pass overlay              = pass;
        overlay.clear             = {};
        overlay.state.depth.write = false;
        overlay.draws             = {wall};
        frame.passes.push_back(overlay);
        is_drawn = false;
    }
    for_pixels(farther_than(frame, level, 0.75f), level, [&](double x, double y, bool is_nearer) {
        CHECK(is_nearer == (is_drawn && x >= 33.0 && x < 101.0 && y >= 20.5 && y < 140.0));
    });
}

TEST_CASE("depth that hangs on a colour target's alpha cannot be drawn without it", "[cloud]") {
    Frame frame                               = scene_frame();
    frame.passes.back().state.dest_alpha_test = DestAlphaTest::One;
    const SceneTargets scene{.back_buffer = {0}, .depth = {1}, .camera = {0}, .fog = {}};
    CHECK_THROWS_AS(append_scaled_depth(frame, scene, 1, 176, 112, {0, 0, kWidth, kHeight}), std::invalid_argument);
}
