// SPDX-License-Identifier: MIT
// Frames of many small triangles, lit by one directional light and depth tested: the vertex stage, and what a
// rasterizer does for each triangle.
#include <cmath>

#include "cloud/particle_mesh.h"
#include "demo/camera_matrices.h"
#include "demo/trigonometry.h"
#include "tests/bench/frame_builder.h"
#include "tests/bench/frames.h"

namespace bench {

using namespace pipeline;

namespace {

constexpr int kWidth = 1280, kHeight = 720;

Frame lit_frame(const Vec3& eye, const Vec3& target) {
    Frame frame                 = one_pass_frame(kWidth, kHeight, TargetFormat::D24);
    frame.cameras[0].view       = demo::look_at(eye, target);
    frame.cameras[0].projection = demo::perspective(45.0, double{kWidth} / kHeight, 0.5, 500.0);
    PipelineState& state        = frame.passes[0].state;
    state.depth                 = {.func = CompareFunc::LessEqual, .write = true};
    state.cull                  = CullMode::Clockwise;
    state.lighting.enabled      = true;
    state.lighting.ambient      = Vec3(0.2f);
    state.lighting.lights       = {{.diffuse = Vec3(0.8f), .direction = Vec3(-0.6f, -0.8f, 0.0f)}};
    return frame;
}

// 128 x 128 squares of gentle hills seen from above, which fill the target: about 20 pixels each triangle.
Frame terrain_32k() {
    constexpr int kSquares = 128;
    Frame frame            = lit_frame(Vec3(0.0f, 100.0f, 20.0f), Vec3(0.0f, 0.0f, 0.0f));
    const auto height      = [](int i, int j) {
        return static_cast<float>(demo::sine(i * 0.31) + demo::sine(j * 0.23 + i * 0.07));
    };
    for (int j = 0; j <= kSquares; ++j)
        for (int i = 0; i <= kSquares; ++i) {
            Vertex& vertex  = frame.vertices.emplace_back();
            vertex.position = {(static_cast<float>(i) / kSquares - 0.5f) * 184.0f, height(i, j),
                               (static_cast<float>(j) / kSquares - 0.5f) * 108.0f};
            const Vec3 slope(height(i - 1, j) - height(i + 1, j), 2.0f, height(i, j - 1) - height(i, j + 1));
            vertex.normal  = slope / std::sqrt(slope.x * slope.x + slope.y * slope.y + slope.z * slope.z);
            vertex.diffuse = {0xffc09060};
        }
    for (std::uint32_t j = 0; j < kSquares; ++j)
        for (std::uint32_t i = 0; i < kSquares; ++i) {
            const std::uint32_t a = j * (kSquares + 1) + i, b = a + 1, c = a + kSquares + 1, d = c + 1;
            for (const std::uint32_t corner : {a, c, b, b, c, d}) frame.indices.push_back(corner);
        }
    frame.passes[0].draws.emplace_back(DrawTriangles{.index_count = 6 * kSquares * kSquares});
    return frame;
}

// 8 x 5 spheres, each a draw with its own world matrix; 1280 triangles, of which half show their backs.
Frame spheres_40x1k() {
    Frame frame                    = lit_frame(Vec3(0.0f, 0.0f, 60.0f), Vec3(0.0f, 0.0f, 0.0f));
    const cloud::Icosphere& sphere = cloud::icosphere();
    for (std::uint32_t i = 0; i < cloud::icosphere_vertices(cloud::kFinestLevel); ++i) {
        Vertex& vertex  = frame.vertices.emplace_back();
        vertex.position = vertex.normal = sphere.directions[i];
        vertex.diffuse                  = {0xffe0e0f0};
    }
    frame.indices = sphere.indices[cloud::kFinestLevel];
    for (int row = 0; row < 5; ++row)
        for (int column = 0; column < 8; ++column) {
            DrawTriangles draw{.index_count = static_cast<std::uint32_t>(frame.indices.size()), .world = Mat4(4.8f)};
            draw.world[3] = {static_cast<float>(2 * column - 7) * 5.0f, static_cast<float>(row - 2) * 9.0f, 0.0f, 1.0f};
            frame.passes[0].draws.emplace_back(draw);
        }
    return frame;
}

}  // namespace

std::vector<FrameCase> triangle_cases() {
    return {
        {"triangles/terrain_32k", &terrain_32k, 2.0 * 128 * 128, "triangles"},
        {"triangles/spheres_40x1k", &spheres_40x1k, 40.0 * cloud::icosphere_triangles(cloud::kFinestLevel),
         "triangles"},
    };
}

}  // namespace bench
