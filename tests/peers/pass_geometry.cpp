// SPDX-License-Identifier: MIT
#include "tests/peers/pass_geometry.h"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <optional>

#include "pipeline/execute/vertex_stage.h"
#include "tests/peers/gl_state.h"

namespace peers {

using namespace pipeline;

namespace {

constexpr int kTile     = 16;    // pixels
constexpr double kReach = 0.05;  // pixels: 1.42 * (1/32 + 1/512), and what floats lose

glm::dvec2 place(const raster::Vertex& vertex) {
    return {vertex.x, vertex.y};
}

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

double distance_to_edge(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& point) {
    const glm::dvec2 edge = b - a, to_point = point - a;
    const double length2 = edge.x * edge.x + edge.y * edge.y;
    const double t = length2 > 0.0 ? std::clamp((to_point.x * edge.x + to_point.y * edge.y) / length2, 0.0, 1.0) : 0.0;
    return std::hypot(to_point.x - t * edge.x, to_point.y - t * edge.y);
}

int edges_near(const raster::Triangle& triangle, const glm::dvec2& point) {
    int count = 0;
    for (std::size_t i = 0; i < 3; ++i)
        count += distance_to_edge(place(triangle[i]), place(triangle[(i + 1) % 3]), point) <= kReach;
    return count;
}

// The corners' weights at a point, if the triangle covers it or nearly.
std::optional<std::array<double, 3>> weights_at(const raster::Triangle& triangle, const glm::dvec2& point) {
    const glm::dvec2 a = place(triangle[0]), b = place(triangle[1]), c = place(triangle[2]);
    const double area = cross(b - a, c - a);
    if (area == 0.0) return std::nullopt;
    const std::array<double, 3> weights{cross(c - b, point - b) / area, cross(a - c, point - c) / area,
                                        cross(b - a, point - a) / area};
    const bool covers = *std::min_element(weights.begin(), weights.end()) >= 0.0;
    if (!covers && edges_near(triangle, point) == 0) return std::nullopt;
    return weights;
}

double perspective_difference(const raster::Triangle& triangle, const std::array<double, 3>& weights) {
    double rhw = 0.0;
    for (std::size_t i = 0; i < 3; ++i) rhw += weights[i] * double{triangle[i].rhw};
    double greatest = 0.0;
    for (const auto color : {&raster::Vertex::diffuse, &raster::Vertex::specular})
        for (int shift = 0; shift < 32; shift += 8) {
            double linear = 0.0, perspective = 0.0;
            for (std::size_t i = 0; i < 3; ++i) {
                const double value = triangle[i].*color >> shift & 255;
                linear += weights[i] * value;
                perspective += weights[i] * double{triangle[i].rhw} * value / rhw;
            }
            greatest = std::max(greatest, std::abs(linear - perspective));
        }
    return greatest;
}

}  // namespace

PassGeometry::PassGeometry(const Frame& frame, std::size_t index) {
    const Pass& drawn    = frame.passes[index];
    const Target& target = frame.targets[static_cast<std::size_t>((drawn.color ? drawn.color : drawn.depth).index)];
    width_               = (target.width + kTile - 1) / kTile;
    height_              = (target.height + kTile - 1) / kTile;
    tiles_.resize(static_cast<std::size_t>(width_ * height_));

    std::vector<raster::Triangle> triangles;
    for (std::size_t i = 0; i <= index; ++i) {
        Pass pass = frame.passes[i];
        if (i != index && !(pass.depth && pass.depth == drawn.depth)) continue;
        pass.state.cull = CullMode::None;
        triangles.clear();
        for (const Draw& draw : pass.draws)
            if (const auto* range = std::get_if<DrawTriangles>(&draw))
                run_vertex_stage(frame, pass, *range, range->first_index, range->index_count,
                                 area_of(frame, pass).viewport, triangles);
        for (const raster::Triangle& triangle : triangles) add(triangle, i == index);
    }
}

void PassGeometry::add(const raster::Triangle& triangle, bool is_of_pass) {
    const auto [x0, x1] = std::minmax({triangle[0].x, triangle[1].x, triangle[2].x});
    const auto [y0, y1] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
    const auto tile     = [](float coordinate, int count) {
        return static_cast<int>(std::clamp(std::floor(coordinate / float{kTile}), -1.0f, static_cast<float>(count)));
    };
    for (int y = std::max(0, tile(y0 - 1.0f, height_)); y <= std::min(height_ - 1, tile(y1 + 1.0f, height_)); ++y)
        for (int x = std::max(0, tile(x0 - 1.0f, width_)); x <= std::min(width_ - 1, tile(x1 + 1.0f, width_)); ++x)
            tiles_[static_cast<std::size_t>(y * width_ + x)].push_back({triangle, is_of_pass});
}

const std::vector<PassGeometry::NearTriangle>& PassGeometry::near(int x, int y) const {
    return tiles_[static_cast<std::size_t>(y / kTile * width_ + x / kTile)];
}

bool PassGeometry::has_sliver(int x, int y) const {
    const glm::dvec2 center(x + 0.5, y + 0.5);
    const auto& triangles = near(x, y);
    return std::any_of(triangles.begin(), triangles.end(),
                       [&](const NearTriangle& triangle) { return edges_near(triangle.corners, center) >= 2; });
}

double PassGeometry::perspective(int x, int y) const {
    const glm::dvec2 center(x + 0.5, y + 0.5);
    double greatest = 0.0;
    for (const NearTriangle& triangle : near(x, y)) {
        if (!triangle.is_of_pass) continue;
        if (const auto weights = weights_at(triangle.corners, center))
            greatest = std::max(greatest, perspective_difference(triangle.corners, *weights));
    }
    return greatest;
}

}  // namespace peers
