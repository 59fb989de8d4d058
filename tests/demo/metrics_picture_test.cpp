// SPDX-License-Identifier: MIT
// M5 to M10 on pictures whose answer is known.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <set>
#include <variant>

#include "demo/metrics/fill.h"
#include "demo/metrics/halo.h"
#include "demo/metrics/interference.h"
#include "demo/metrics/look.h"
#include "demo/metrics/shimmer.h"
#include "demo/metrics/statistics.h"
#include "demo/metrics/swim.h"
#include "tests/demo/metrics_planes.h"

using namespace demo;

namespace {

// Marks the pixels of a line.
void draw_line(Mask& mask, double x0, double y0, double x1, double y1) {
    const int steps = 1 + static_cast<int>(2.0 * std::hypot(x1 - x0, y1 - y0));
    for (int i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        mask.at(static_cast<int>(x0 + (x1 - x0) * t), static_cast<int>(y0 + (y1 - y0) * t)) = 1;
    }
}

// Each line becomes four of a third; dimension log 4 / log 3 = 1.26.
void draw_koch(Mask& mask, double x0, double y0, double x1, double y1, int depth) {
    if (depth == 0) return draw_line(mask, x0, y0, x1, y1);
    const double dx = (x1 - x0) / 3.0, dy = (y1 - y0) / 3.0, h = std::sqrt(3.0) / 2.0;
    const double ax = x0 + dx, ay = y0 + dy, bx = x0 + 2.0 * dx, by = y0 + 2.0 * dy;
    const double tx = ax + 0.5 * dx + h * dy, ty = ay + 0.5 * dy - h * dx;
    draw_koch(mask, x0, y0, ax, ay, depth - 1);
    draw_koch(mask, ax, ay, tx, ty, depth - 1);
    draw_koch(mask, tx, ty, bx, by, depth - 1);
    draw_koch(mask, bx, by, x1, y1, depth - 1);
}

// Smooth enough to be sampled between pixels.
double pattern(double x, double y) {
    return std::sin(0.5 * x + 0.2 * y) + std::sin(0.31 * x - 0.43 * y) + std::sin(0.13 * y + 0.7 * x);
}

pipeline::Camera camera_at(double x) {
    pipeline::Camera camera;
    camera.view       = glm::translate(glm::mat4(1.0f), glm::vec3(-x, 0.0f, 0.0f));
    camera.projection = glm::perspectiveRH_ZO(0.8f, 2.0f, 0.5f, 1000.0f);
    return camera;
}

ColorPlane colors(int width, int height, Vec3 color) {
    return ColorPlane(width, height, color);
}

}  // namespace

TEST_CASE("the dimension of a line is 1, of an area 2, of Koch's curve 1.26", "[metrics]") {
    Mask line(400, 300);
    draw_line(line, 20.0, 40.0, 380.0, 210.0);
    REQUIRE(box_dimension(line));
    CHECK(*box_dimension(line) == Approx(1.0).margin(0.06));
    CHECK(*box_dimension(Mask(400, 300, 1)) == Approx(2.0).margin(0.15));
    Mask koch(800, 300);
    draw_koch(koch, 10.0, 280.0, 790.0, 280.0, 6);
    CHECK(*box_dimension(koch) == Approx(std::log(4.0) / std::log(3.0)).margin(0.06));
    CHECK_FALSE(box_dimension(Mask(400, 300)));
}

TEST_CASE("a contour is one pixel thick, on the inside", "[metrics]") {
    const Mask contour = contour_of(tests::gaussian_edge(40, 5, 20.0, 3.0), 0.5f);
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 40; ++x) CHECK(contour.at(x, y) == (x == 20));
}

TEST_CASE("tones are the range of light, and the colour of the shadows", "[metrics]") {
    ColorPlane picture = colors(100, 4, Vec3(0.0f));
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 100; ++x) {
            const float light = 0.3f + 0.006f * static_cast<float>(x);
            picture.at(x, y)  = x < 50 ? Vec3(light, light, light * 1.25f) : Vec3(light);
        }
    const auto tones = tones_of(picture, Mask(100, 4, 1));
    REQUIRE(tones);
    CHECK(tones->tone == Approx(0.864 / 0.339).epsilon(0.03));
    CHECK(tones->saturation_dark == Approx(0.2).epsilon(0.01));
    CHECK(tones->saturation_light == Approx(0.0).margin(1e-6));
    CHECK_FALSE(tones_of(picture, Mask(100, 4)));
}

TEST_CASE("a crease is steeper than what is around it", "[metrics]") {
    Mask seams(64, 64);
    for (int y = 0; y < 64; ++y) seams.at(31, y) = seams.at(32, y) = 1;
    const Plane even = tests::plane_of(64, 64, [](int x, int) { return 0.01 * x; });
    const Plane bent = tests::plane_of(64, 64, [](int x, int) { return 0.01 * x + (x > 31 ? 0.05 : 0.0); });
    const Mask all(64, 64, 1);
    REQUIRE(crease_index(even, seams, all));
    CHECK(*crease_index(even, seams, all) == Approx(1.0).margin(0.03));
    CHECK(*crease_index(bent, seams, all) > 2.0);
    CHECK_FALSE(crease_index(even, Mask(64, 64), all));
}

TEST_CASE("an exact mix has no halo, a darkened one has its own", "[metrics]") {
    const ColorPlane scene = colors(16, 16, Vec3(0.2f, 0.4f, 0.8f)), cloud = colors(16, 16, Vec3(0.9f));
    const Plane coverage = tests::plane_of(16, 16, [](int x, int) { return (x + 0.5) / 16.0; });
    const Mask all(16, 16, 1);
    ColorPlane mix = scene, dark = scene;
    std::vector<double> missing;
    for (std::size_t i = 0; i < mix.values.size(); ++i) {
        const float a  = coverage.values[i];
        mix.values[i]  = a * cloud.values[i] + (1.0f - a) * scene.values[i];
        dark.values[i] = a * a * cloud.values[i] + (1.0f - a) * scene.values[i];  // over black
        missing.push_back(static_cast<double>(-a * (1.0f - a) * 0.9f));
    }
    const Halo none = halo(mix, scene, cloud, coverage, all);
    CHECK(none.distance == Approx(0.0).margin(1e-6));
    CHECK(none.luminance_error == Approx(0.0).margin(1e-6));
    const Halo found = halo(dark, scene, cloud, coverage, all);
    CHECK(found.distance > 0.05);
    CHECK(found.luminance_error == Approx(mean(missing)).epsilon(0.001));
}

TEST_CASE("detail that moves with the cloud is told from detail on the screen", "[metrics]") {
    // Everything 100 m away; the camera goes 3 m to the right.
    const Plane depth(200, 100, 100.0f);
    const Grid<Vec2> flow = camera_flow(depth, camera_at(0.0), camera_at(3.0));
    const double moved    = -3.0 / 100.0 * static_cast<double>(camera_at(0.0).projection[0][0]) * 100.0;
    CHECK(flow.at(17, 60).x == Approx(moved).epsilon(0.001));
    CHECK(flow.at(17, 60).y == Approx(0.0).margin(0.001));

    const auto still   = [](int x, int y) { return pattern(x, y); };
    const auto follow  = [&](int x, int y) { return pattern(x - moved, y); };
    const Plane before = tests::plane_of(200, 100, still);
    const Mask all(200, 100, 1);
    const Swim on_cloud = swim(before, tests::plane_of(200, 100, follow), flow, all);
    CHECK(on_cloud.on_object > 0.98);
    CHECK(on_cloud.on_screen < 0.8);
    const Swim on_screen = swim(before, before, flow, all);
    CHECK(on_screen.on_screen == Approx(1.0));
    CHECK(on_screen.on_object < 0.8);
}

TEST_CASE("holes in a depth picture take the nearest depth", "[metrics]") {
    Plane depth(5, 1, std::numeric_limits<float>::infinity());
    depth.at(0, 0) = 3.0f, depth.at(4, 0) = 7.0f;
    const Plane filled = without_holes(depth);
    CHECK(filled.at(1, 0) == 3.0f);
    CHECK(filled.at(3, 0) == 7.0f);
}

TEST_CASE("a plane that only moved does not shimmer", "[metrics]") {
    const auto value   = [](int x, int y) { return tests::noise_at(x, y); };
    const Plane plane  = tests::plane_of(30, 20, value);
    const Plane moved  = tests::plane_of(30, 20, [&](int x, int y) { return value(x - 3, y - 2); });
    const auto nothing = differences_unmoved(plane, moved, 3, 2, tests::all_of(plane));
    CHECK(nothing.size() == 27u * 18u);
    CHECK(rms(nothing) == 0.0);
    CHECK(rms(differences_unmoved(plane, moved, 2, 2, tests::all_of(plane))) > 0.3);
}

TEST_CASE("layers lie over each other by their coverage", "[metrics]") {
    ColorPlane picture = colors(2, 1, Vec3(0.5f));
    const std::vector<Layer> layers{{colors(2, 1, Vec3(0.2f)), Plane(2, 1, 0.25f)},
                                    {colors(2, 1, Vec3(0.1f)), tests::plane_of(2, 1, [](int x, int) { return x; })}};
    for (const Layer& layer : layers) lay_over(picture, layer);
    CHECK(picture.at(0, 0).x == Approx(0.1f + 0.2f + 0.75f * 0.5f));
    CHECK(picture.at(1, 0).x == Approx(0.1f));
    CHECK(overlaps_of(layers).values == std::vector<std::uint8_t>{0, 1});
    CHECK(color_rms(picture, picture, Mask(2, 1, 1)) == 0.0);
    CHECK(color_rms(colors(2, 1, Vec3(0.1f)), colors(2, 1, Vec3(0.4f)), Mask(2, 1, 1)) == Approx(0.3));
}

TEST_CASE("triangles are drawn in the opposite order, and turn as before", "[metrics]") {
    pipeline::Frame frame;
    frame.indices = {9, 0, 1, 2, 3, 4, 5, 8};
    pipeline::Pass pass;
    pass.draws = {pipeline::DrawTriangles{.first_index = 1, .index_count = 6, .textures = {}}};
    reverse_triangles(frame, pass);
    CHECK(frame.indices == std::vector<std::uint32_t>{9, 3, 4, 5, 0, 1, 2, 8});
}

TEST_CASE("only clouds are counted, and depth only where it is tested", "[metrics]") {
    pipeline::Frame frame;
    pipeline::Execution execution;
    const auto add = [&](const char* label, std::uint64_t tested, std::uint64_t passed, std::uint64_t blended) {
        frame.passes.emplace_back().label = label;
        execution.counts.push_back({.depth_tested = tested, .depth_passed = passed, .blended = blended});
    };
    add("sky", 100, 90, 80);
    add("cumulus: mega-particles, alpha 1", 50, 20, 0);
    add("cumulus: composite", 0, 40, 40);
    const pipeline::PassCounts counts = cloud_counts(frame, execution);
    CHECK(counts.depth_tested == 50);
    CHECK(counts.depth_passed == 20);
    CHECK(counts.blended == 40);
}
