// SPDX-License-Identifier: MIT
// Where the truth draws, and what it gives to a pixel there, against areas and formulas.
#include <catch2/catch.hpp>
#include <cmath>

#include "pipeline/truth/truth.h"
#include "tests/support/random.h"
#include "tests/support/small_frame.h"

namespace {

using namespace pipeline;
using namespace test_support;
using Point = std::array<double, 2>;

const std::array<double, 4>& pixel(const TruthPicture& picture, int x, int y) {
    return picture.pixels.at(static_cast<std::size_t>(y * picture.width + x));
}

DrawWindowTriangles add_window_triangles(Frame& frame, const std::vector<WindowVertex>& vertices) {
    DrawWindowTriangles draw{.first_index = static_cast<std::uint32_t>(frame.indices.size()),
                             .index_count = static_cast<std::uint32_t>(vertices.size()),
                             .textures    = {}};
    for (const WindowVertex& vertex : vertices) {
        frame.indices.push_back(static_cast<std::uint32_t>(frame.window_vertices.size()));
        frame.window_vertices.push_back(vertex);
    }
    return draw;
}

WindowVertex at(double x, double y) {
    return {.x = static_cast<float>(x), .y = static_cast<float>(y)};
}

// Of what lies in the half-plane a*x + b*y <= c.
std::vector<Point> cut(const std::vector<Point>& polygon, double a, double b, double c) {
    std::vector<Point> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double dp = c - a * p[0] - b * p[1], dq = c - a * q[0] - b * q[1];
        if (dp >= 0.0) kept.push_back(p);
        if ((dp < 0.0) != (dq < 0.0))
            kept.push_back({p[0] + dp / (dp - dq) * (q[0] - p[0]), p[1] + dp / (dp - dq) * (q[1] - p[1])});
    }
    return kept;
}
double area_in_pixel(std::vector<Point> polygon, int x, int y) {
    polygon        = cut(cut(cut(cut(polygon, 1, 0, x + 1), -1, 0, -x), 0, 1, y + 1), 0, -1, -y);
    double doubled = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        doubled += p[0] * q[1] - q[0] * p[1];
    }
    return std::abs(doubled) / 2.0;
}

}  // namespace

// A straight side crosses 31 of a pixel's 16 x 16 cells at most and leaves half a cell of each unsure: 31/512; two sides, twice that.
TEST_CASE("a triangle covers its area", "[truth]") {
    const std::vector<Point> corners{{3.3, 2.1}, {28.7, 9.4}, {11.2, 29.6}};
    Frame frame = small_frame(32, 32);
    frame.passes[0].draws.push_back(add_window_triangles(
        frame, {at(corners[0][0], corners[0][1]), at(corners[1][0], corners[1][1]), at(corners[2][0], corners[2][1])}));
    const TruthPicture picture = draw_truth(frame, {.samples_per_axis = 16});
    int inside = 0, at_edge = 0;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            const double area = area_in_pixel(corners, x, y);
            INFO("pixel " << x << ", " << y);
            CHECK(std::abs(pixel(picture, x, y)[0] - area) <= 1.0 / 16.0);
            inside += area > 0.9999;
            at_edge += area > 0.0001 && area < 0.9999;
        }
    CHECK(inside > 200);
    CHECK(at_edge > 60);
}

TEST_CASE("triangles with a common side neither overlap nor leave a gap in the truth", "[truth]") {
    Random random(7);
    Frame frame                 = small_frame(16, 16);
    frame.passes[0].state.blend = {.source = BlendFactor::One, .dest = BlendFactor::One};
    // Around a corner on a sample, each with its own order of corners.
    std::vector<Point> around;
    for (int i = 0; i < 16; ++i)
        around.push_back({8.5 + 20 * std::cos(i * 0.39269908), 8.5 + 20 * std::sin(i * 0.39269908)});
    std::vector<WindowVertex> vertices;
    for (std::size_t i = 0; i < around.size(); ++i) {
        const Point &p = around[i], &q = around[(i + 1) % around.size()];
        const std::array<WindowVertex, 3> corners{at(8.5, 8.5), at(p[0], p[1]), at(q[0], q[1])};
        const auto turn = static_cast<std::size_t>(random.below(3));
        for (std::size_t k = 0; k < 3; ++k) vertices.push_back(corners[(k + turn) % 3]);
    }
    for (WindowVertex& vertex : vertices) vertex.diffuse = {0x40404040};
    frame.passes[0].draws.push_back(add_window_triangles(frame, vertices));
    for (const int samples : {1, 3, 4})
        for (const auto& color : draw_truth(frame, {.samples_per_axis = samples}).pixels)
            CHECK(std::abs(color[0] - 64.0 / 255.0) < 1e-12);
}

TEST_CASE("rectangles are sampled where the frame says, with all their samples around it", "[truth]") {
    Frame frame = small_frame(4, 1);
    frame.passes[0].draws.push_back(rectangle({0, 0, 1, 1}, 0xffffffff));
    std::get<DrawRectangle>(frame.passes[0].draws[0]).x0 = 0.75f;
    std::get<DrawRectangle>(frame.passes[0].draws[0]).x1 = 2.25f;
    const auto reds                                      = [&](int center, int samples) {
        frame.arithmetic.pixel_center = center;
        std::vector<double> out;
        for (const auto& color : draw_truth(frame, {.samples_per_axis = samples}).pixels) out.push_back(color[0]);
        return out;
    };
    std::get<DrawRectangle>(frame.passes[0].draws[0]).y0 = -1.0f;
    CHECK(reds(8, 1) == std::vector<double>{0, 1, 0, 0});
    CHECK(reds(0, 1) == std::vector<double>{0, 1, 1, 0});
    CHECK(reds(8, 4) == std::vector<double>{0.25, 1, 0.25, 0});
    CHECK(reds(0, 4) == std::vector<double>{0, 0.75, 0.75, 0});
}

// u = sum(l u / w) / sum(l / w), colour = sum(l c), l being the shares of the corners.
TEST_CASE("texture coordinates are in perspective, colours and depth linear in the window", "[truth]") {
    Frame frame = small_frame(16, 16, TargetFormat::D24);
    std::vector<std::uint8_t> ramp(256);
    for (std::size_t i = 0; i < 256; ++i) ramp[i] = static_cast<std::uint8_t>(i);
    const TextureId texture = add_texture(frame, TextureFormat::L8, 256, 1, ramp);
    std::vector<WindowVertex> v{at(1, 1), at(15, 2), at(4, 15)};
    v[0].rhw = 1.0f, v[1].rhw = 0.25f, v[2].rhw = 0.5f;
    v[0].uv0 = {0.1f, 0.5f, 1.0f}, v[1].uv0 = {0.9f, 0.5f, 1.0f}, v[2].uv0 = {0.6f, 0.5f, 2.0f};
    v[0].diffuse = {0x10000000}, v[1].diffuse = {0x80000000}, v[2].diffuse = {0xf0000000};
    v[0].z = 0.1f, v[1].z = 0.9f, v[2].z = 0.4f;
    DrawWindowTriangles draw          = add_window_triangles(frame, v);
    draw.textures[0]                  = bound(texture);
    TextureStage& stage               = frame.passes[0].state.stages[0];
    stage                             = {.color_op   = TextureOp::SelectArg1,
                                         .alpha_op   = TextureOp::SelectArg1,
                                         .alpha_arg1 = {.source = ArgSource::Diffuse},
                                         .filter     = TextureFilter::Linear};
    frame.passes[0].state.depth.write = true;
    frame.passes[0].draws.push_back(draw);
    // Green where the depth is beyond 0.5.
    Pass beyond             = frame.passes[0];
    beyond.state            = {};
    beyond.state.depth.func = CompareFunc::Less;
    beyond.state.color_mask = {false, true, false, false};
    beyond.draws            = {rectangle({0, 0, 16, 16}, 0xff00ff00, 0.5f)};
    frame.passes.push_back(beyond);
    const TruthPicture picture = draw_truth(frame, {.samples_per_axis = 1});

    int covered      = 0;
    const auto cross = [](const WindowVertex& a, const WindowVertex& b, double x, double y) {
        return (double{b.x} - a.x) * (y - a.y) - (double{b.y} - a.y) * (x - a.x);
    };
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
            const double px = x + 0.5, py = y + 0.5;
            std::array<double, 3> l{cross(v[1], v[2], px, py), cross(v[2], v[0], px, py), cross(v[0], v[1], px, py)};
            if (l[0] <= 0.0 || l[1] <= 0.0 || l[2] <= 0.0) continue;
            const double total = l[0] + l[1] + l[2];
            double s = 0.0, q = 0.0, alpha = 0.0, z = 0.0;
            for (std::size_t i = 0; i < 3; ++i) {
                const double share = l[i] / total;
                s += share * v[i].uv0.x * v[i].rhw;
                q += share * v[i].uv0.z * v[i].rhw;
                alpha += share * (v[i].diffuse.value >> 24) / 255.0;
                z += share * v[i].z;
            }
            INFO("pixel " << x << ", " << y);
            CHECK(std::abs(pixel(picture, x, y)[0] - (s / q * 256.0 - 0.5) / 255.0) < 1e-9);
            CHECK(std::abs(pixel(picture, x, y)[3] - alpha) < 1e-12);
            CHECK((pixel(picture, x, y)[1] == 1.0) == (z > 0.5));
            ++covered;
        }
    CHECK(covered > 80);
}

// A square before a camera: one light at 60 degrees, one behind, one point light; a fog; all in closed form.
TEST_CASE("the truth lights and fogs as the formulas say", "[truth]") {
    Frame frame                 = small_frame(8, 8);
    frame.cameras[0].projection = Mat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, -1, 0);  // w = z, near 1
    DrawTriangles draw          = add_quad(frame, 0xff804020);
    PipelineState& state        = frame.passes[0].state;
    LightingState& lighting     = state.lighting;
    lighting                    = {.enabled = true, .specular_enable = true, .local_viewer = false};
    lighting.ambient            = {0.1f, 0.1f, 0.1f};
    lighting.ambient_source     = ColorSource::Material;
    lighting.material.specular  = {0.5f, 0.5f, 0.5f};
    lighting.material.power     = 2.0f;
    lighting.specular_source    = ColorSource::Material;
    Light slanted;
    slanted.direction = {0.0f, std::sqrt(3.0f) / 2.0f, 0.5f};
    slanted.diffuse   = {1.0f, 0.5f, 0.25f};
    slanted.specular  = {1.0f, 0.0f, 0.0f};
    Light behind      = slanted;
    behind.direction  = {0.0f, 0.0f, -1.0f};
    lighting.lights   = {slanted, behind};
    for (Vertex& vertex : frame.vertices) {
        vertex.position = {vertex.position.x * 2.0f, vertex.position.y * 2.0f, 2.0f};
        vertex.normal   = {0.0f, 0.0f, -1.0f};
    }
    state.fog = {.mode = FogMode::Linear, .color = {0xff0000ff}, .start = 1.0f, .end = 5.0f, .density = 1.0f};
    frame.passes[0].draws.push_back(draw);

    // diffuse = 0.1 + vertex * 0.5 * light; highlight = 0.5 * (N.H)^2, H half way between 60 degrees and the viewer's 0.
    const double gleam = std::pow(std::cos(std::acos(-1.0) / 6.0), 2.0);
    const double red   = 0.1 + 128.0 / 255.0 * 0.5 + 0.5 * gleam;
    const double green = 0.1 + 64.0 / 255.0 * 0.5 * 0.5;
    const double blue  = 0.1 + 32.0 / 255.0 * 0.5 * 0.25;
    const double own   = 0.75;  // (5 - 2) / (5 - 1)
    for (const auto& color : draw_truth(frame, {.samples_per_axis = 2}).pixels) {
        CHECK(std::abs(color[0] - own * red) < 1e-6);
        CHECK(std::abs(color[1] - own * green) < 1e-6);
        CHECK(std::abs(color[2] - (own * blue + 0.25)) < 1e-6);
    }
    lighting                = {.enabled = true};
    lighting.diffuse_source = ColorSource::Material;
    Light point;
    point.type        = LightType::Point;
    point.position    = {0.0f, 0.0f, 1e3f};
    point.attenuation = {0.0f, 0.0f, 1e-6f};
    point.range       = 2e3f;
    lighting.lights   = {point};
    for (Vertex& vertex : frame.vertices) vertex.normal = {0.0f, 0.0f, 0.5f};
    state.fog = {.mode = FogMode::Exp2, .color = {0xff000000}, .density = 0.25f};
    // One over a square of 998 thousandths, by half the normal's length; the fog of exp(-(0.25 * 2)^2).
    for (const auto& color : draw_truth(frame, {.samples_per_axis = 1}).pixels)
        CHECK(std::abs(color[0] - 0.5 / (0.998 * 0.998) * std::exp(-0.25)) < 1e-4);
}
