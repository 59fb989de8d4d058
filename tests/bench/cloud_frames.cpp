// SPDX-License-Identifier: MIT
// Clouds alone, at 1920x1080, to see how time grows with what they are made of.
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <memory>

#include "cloud/mega_particles/mega_particles.h"
#include "cloud/particle_mesh.h"
#include "demo/camera_matrices.h"
#include "demo/trigonometry.h"
#include "tests/bench/frame_builder.h"
#include "tests/bench/frames.h"

namespace bench {

using namespace pipeline;

namespace {

constexpr int kWidth = 1920, kHeight = 1080;

// Particles evenly spread in a ball, on a spiral of the golden angle from pole to pole; together they have the volume
// of the ball several times, whatever their number, so that the outline stays.
cloud::Cloud ball_of_particles(const Vec3& center, float radius, int count) {
    constexpr double kGoldenAngle = 2.399963229728653;
    cloud::Cloud ball;
    ball.name   = "ball";
    ball.blur_m = 0.05f * radius;
    for (int i = 0; i < count; ++i) {
        const double share  = (i + 0.5) / count;
        const double height = 1.0 - 2.0 * share, across = std::sqrt(1.0 - height * height);
        // The distance from the middle takes all values for each height: another multiple of an irrational number.
        const double turn = i * 0.7548776662466927, from_middle = std::cbrt(turn - std::floor(turn));
        const double angle = i * kGoldenAngle;
        const Vec3 direction(across * demo::cosine(angle), height, across * demo::sine(angle));
        ball.particles.push_back({.center = center + direction * static_cast<float>(0.85 * from_middle * radius),
                                  .radius = radius * 0.8f / std::cbrt(static_cast<float>(count))});
    }
    return ball;
}

// Lit by the sun, but without shadows: those take time that grows with the square of the particles, once for a cloud,
// and change nothing in the work of drawing it.
cloud::BakedCloud bake_without_shadows(const cloud::Cloud& ball) {
    const cloud::Daylight daylight;
    cloud::BakedCloud baked{ball, daylight, {}, {}};
    std::vector<cloud::LitVertex> vertices;
    Vec3 low(1e9f), high(-1e9f);
    for (std::size_t i = 0; i < ball.particles.size(); ++i) {
        const cloud::ParticleMesh mesh = cloud::shape_particle(ball, i);
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            const float share = 0.5f + 0.5f * glm::dot(mesh.normals[v], daylight.to_sun);
            vertices.push_back(
                {mesh.positions[v], mesh.normals[v], 0.85f * share * daylight.sun + 0.15f * daylight.sky, 1.0f});
            low  = glm::min(low, mesh.positions[v]);
            high = glm::max(high, mesh.positions[v]);
        }
    }
    baked.lit.vertices = cloud::LitVertices(std::move(vertices));
    baked.lit.low      = low;
    baked.lit.high     = high;
    return baked;
}

Frame cloud_frame(const std::vector<cloud::Cloud>& clouds) {
    Frame frame                 = one_pass_frame(kWidth, kHeight, TargetFormat::D24);
    const Vec3 eye              = Vec3(0.0f, 0.0f, 120.0f);
    frame.cameras[0].view       = demo::look_at(eye, Vec3(0.0f));
    frame.cameras[0].projection = demo::perspective(45.0, double{kWidth} / kHeight, 0.5, 500.0);
    const cloud::View view{.eye        = eye,
                           .view       = frame.cameras[0].view,
                           .projection = frame.cameras[0].projection,
                           .width      = kWidth,
                           .height     = kHeight,
                           .near_m     = 0.5f};
    std::vector<cloud::BakedCloud> baked;
    for (const cloud::Cloud& each : clouds) baked.push_back(bake_without_shadows(each));
    // Clouds of one size have the same.
    const Vec3 box_size = baked[0].lit.high - baked[0].lit.low;
    const auto fractal  = std::make_shared<const cloud::FractalFaces>(
        cloud::make_fractal(clouds[0].fractal, box_size, cloud::FractalCode::Half));
    for (cloud::BakedCloud& each : baked) each.fractal = fractal;
    cloud::append_mega_particles(frame, {.back_buffer = {0}, .depth = {1}, .camera = {0}, .fog = {}}, view, baked);
    return frame;
}

// One cloud, more than half as high as the picture.
FrameCase spheres(int count) {
    return {.name  = "growth/spheres/" + std::to_string(count),
            .build = [=] { return cloud_frame({ball_of_particles(Vec3(0.0f), 30.0f, count)}); },
            .size  = static_cast<double>(count)};
}

// columns x columns of them, side by side in the places that 8 x 8 have.
FrameCase clouds(int columns) {
    const auto build = [=] {
        std::vector<cloud::Cloud> all;
        for (int row = 0; row < columns; ++row)
            for (int column = 0; column < columns; ++column) {
                const float x = static_cast<float>(2 * column - columns + 1) * 9.0f;
                const float y = static_cast<float>(2 * row - columns + 1) * 5.5f;
                all.push_back(ball_of_particles(Vec3(x, y, 0.0f), 3.0f, 24));
            }
        return cloud_frame(all);
    };
    const int count = columns * columns;
    return {.name = "growth/clouds/" + std::to_string(count), .build = build, .size = static_cast<double>(count)};
}

}  // namespace

std::vector<FrameCase> cloud_cases() {
    std::vector<FrameCase> cases;
    for (const int count : {10, 100, 1000, 10000}) cases.push_back(spheres(count));
    for (const int columns : {1, 2, 4, 8}) cases.push_back(clouds(columns));
    return cases;
}

}  // namespace bench
