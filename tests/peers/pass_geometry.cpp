// SPDX-License-Identifier: MIT
#include "tests/peers/pass_geometry.h"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <optional>

#include "pipeline/execute/lower.h"
#include "pipeline/execute/vertex_stage.h"
#include "pipeline/legalize/window_map.h"

namespace peers {

using namespace pipeline;

namespace {

constexpr int kTile          = 16;       // pixels
constexpr double kReach      = 0.05;     // pixels: 1.42 * (1/32 + 1/512), and what floats lose
constexpr double kCutReach   = 0.1;      // the same for corners that are cut to 1/16 pixel
constexpr double kFloatDepth = 0x1p-23;  // two roundings of a float below 1
constexpr int kFiner         = 16;       // OpenGL's grid, 1/256 pixel, is this much finer than the frame's

// The vertex stage drops what has no area on its grid. In a viewport this much larger that is OpenGL's grid.
std::vector<raster::Triangle> triangles_of(const Frame& frame, Pass pass, const PixelRect& viewport) {
    pass.state.cull = CullMode::None;
    const PixelRect large{viewport.x0 * kFiner, viewport.y0 * kFiner, viewport.x1 * kFiner, viewport.y1 * kFiner};
    std::vector<raster::Triangle> triangles;
    for (const Draw& draw : pass.draws)
        if (const auto* range = std::get_if<DrawTriangles>(&draw)) {
            raster::Draw staged;
            run_vertex_stage(frame, pass, *range, large, staged);
            for (const raster::TriangleCorners& corners : staged.triangles)
                triangles.push_back(raster::triangle_of(staged, corners));
        }
    for (raster::Triangle& triangle : triangles)
        for (raster::Vertex& vertex : triangle) {
            vertex.x /= float{kFiner};
            vertex.y /= float{kFiner};
        }
    return triangles;
}

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

using Edge = std::pair<glm::dvec2, glm::dvec2>;

std::vector<Edge> edges_near(const raster::Triangle& triangle, const glm::dvec2& point, double reach) {
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2 a = place(triangle[i]), b = place(triangle[(i + 1) % 3]);
        if (distance_to_edge(a, b, point) <= reach) edges.emplace_back(a, b);
    }
    return edges;
}

// Neighbours in a mesh go round opposite ways.
bool is_same(const Edge& a, const Edge& b) {
    return a == b || (a.first == b.second && a.second == b.first);
}

bool is_on_edge(const raster::Subpixel& a, const raster::Subpixel& b, const raster::Subpixel& point) {
    const bool is_beside = point.x < std::min(a.x, b.x) || point.x > std::max(a.x, b.x) ||
                           point.y < std::min(a.y, b.y) || point.y > std::max(a.y, b.y);
    return !is_beside && (b.x - a.x) * (point.y - a.y) == (b.y - a.y) * (point.x - a.x);
}

bool is_on_edge(const raster::Triangle& triangle, const raster::Subpixel& point) {
    std::array<raster::Subpixel, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = raster::snap_to_subpixels({}, triangle[i].x, triangle[i].y);
    return is_on_edge(corners[0], corners[1], point) || is_on_edge(corners[1], corners[2], point) ||
           is_on_edge(corners[2], corners[0], point);
}

bool is_on_edge(const DrawRectangle& rectangle, const raster::Subpixel& point) {
    const raster::Subpixel a = raster::snap_to_subpixels({}, rectangle.x0, rectangle.y0);
    const raster::Subpixel b = raster::snap_to_subpixels({}, rectangle.x1, rectangle.y1);
    return point.x == a.x || point.x == b.x || point.y == a.y || point.y == b.y;
}

// The corners' weights at a point, if the triangle covers it or nearly.
std::optional<std::array<double, 3>> weights_at(const raster::Triangle& triangle, const glm::dvec2& point,
                                                double reach) {
    const glm::dvec2 a = place(triangle[0]), b = place(triangle[1]), c = place(triangle[2]);
    const double area = cross(b - a, c - a);
    if (area == 0.0) return std::nullopt;
    const std::array<double, 3> weights{cross(c - b, point - b) / area, cross(a - c, point - c) / area,
                                        cross(b - a, point - a) / area};
    const bool covers = *std::min_element(weights.begin(), weights.end()) >= 0.0;
    if (!covers && edges_near(triangle, point, reach).empty()) return std::nullopt;
    return weights;
}

// Per pixel, of what has these values at the corners.
double slope(const raster::Triangle& triangle, double at_a, double at_b, double at_c) {
    const glm::dvec2 a = place(triangle[0]), b = place(triangle[1]) - a, c = place(triangle[2]) - a;
    const double area = cross(b, c), to_b = at_b - at_a, to_c = at_c - at_a;
    return area == 0.0 ? 0.0 : std::hypot(to_b * c.y - to_c * b.y, to_c * b.x - to_b * c.x) / std::abs(area);
}

bool share_corner(const raster::Triangle& a, const raster::Triangle& b) {
    return std::any_of(a.begin(), a.end(), [&](const raster::Vertex& p) {
        return std::any_of(b.begin(), b.end(),
                           [&](const raster::Vertex& q) { return p.x == q.x && p.y == q.y && p.z == q.z; });
    });
}

bool are_same(const raster::Triangle& a, const raster::Triangle& b) {
    return std::equal(a.begin(), a.end(), b.begin(), [](const raster::Vertex& p, const raster::Vertex& q) {
        return p.x == q.x && p.y == q.y && p.z == q.z;
    });
}

bool is_culled(CullMode mode, const raster::Triangle& triangle) {
    const double area = cross(place(triangle[1]) - place(triangle[0]), place(triangle[2]) - place(triangle[0]));
    return mode == CullMode::Clockwise ? area > 0.0 : mode == CullMode::CounterClockwise && area < 0.0;
}

constexpr std::array kColors{&raster::Vertex::diffuse, &raster::Vertex::specular};
constexpr int kShifts[] = {0, 8, 16, 24};

double channel(const raster::Vertex& vertex, std::uint32_t raster::Vertex::*color, int shift) {
    return static_cast<double>(vertex.*color >> shift & 255);
}

double perspective_difference(const raster::Triangle& triangle, const std::array<double, 3>& weights) {
    double rhw = 0.0;
    for (std::size_t i = 0; i < 3; ++i) rhw += weights[i] * double{triangle[i].rhw};
    double greatest = 0.0;
    for (const auto color : kColors)
        for (const int shift : kShifts) {
            double linear = 0.0, perspective = 0.0;
            for (std::size_t i = 0; i < 3; ++i) {
                const double value = channel(triangle[i], color, shift);
                linear += weights[i] * value;
                perspective += weights[i] * double{triangle[i].rhw} * value / rhw;
            }
            greatest = std::max(greatest, std::abs(linear - perspective));
        }
    return greatest;
}

double steepest_color(const raster::Triangle& triangle) {
    double greatest = 0.0;
    for (const auto color : kColors)
        for (const int shift : kShifts)
            greatest =
                std::max(greatest, slope(triangle, channel(triangle[0], color, shift),
                                         channel(triangle[1], color, shift), channel(triangle[2], color, shift)));
    return greatest;
}

bool has_same_camera(const Frame& frame, const Pass& a, const Pass& b) {
    if (!a.camera || !b.camera) return !a.camera && !b.camera;
    const Camera& one = frame.cameras[static_cast<std::size_t>(a.camera.index)];
    const Camera& two = frame.cameras[static_cast<std::size_t>(b.camera.index)];
    return one.view == two.view && one.projection == two.projection;
}

}  // namespace

PassGeometry::PassGeometry(const Frame& frame, std::size_t index)
    : pass_(frame.passes[index]),
      center_(frame.arithmetic.pixel_center),
      reach_(frame.arithmetic.snap == SnapRule::Truncate ? kCutReach : kReach) {
    const Pass& drawn    = pass_;
    const Target& target = frame.targets[static_cast<std::size_t>((drawn.color ? drawn.color : drawn.depth).index)];
    width_               = (target.width + kTile - 1) / kTile;
    height_              = (target.height + kTile - 1) / kTile;
    tiles_.resize(static_cast<std::size_t>(width_ * height_));

    if (drawn.depth)
        depth_step_ = kFloatDepth +
                      std::ldexp(1.0, -depth_bits(frame.targets[static_cast<std::size_t>(drawn.depth.index)].format));

    for (std::size_t i = 0; i <= index; ++i) {
        const Pass& pass      = frame.passes[i];
        const bool is_of_pass = i == index;
        if (!is_of_pass && !(pass.depth && pass.depth == drawn.depth)) continue;
        const bool writes_depth  = pass.depth && pass.state.depth.write;
        const PixelRect viewport = viewport_of(frame, pass);
        const bool same_view     = viewport == viewport_of(frame, drawn) && has_same_camera(frame, pass, drawn);
        for (const raster::Triangle& triangle : triangles_of(frame, pass, viewport))
            add({triangle, is_of_pass, is_culled(pass.state.cull, triangle), writes_depth, same_view});
        if (pass.clear.depth) flat_surfaces_.push_back({*pass.clear.depth, depth_step_, false, true});
        for (const Draw& draw : pass.draws)
            if (const auto* rectangle = std::get_if<DrawRectangle>(&draw))
                flat_surfaces_.push_back({rectangle->depth, depth_step_, is_of_pass, writes_depth});
    }
}

glm::dvec2 PassGeometry::center_of(int x, int y) const {
    return glm::dvec2(x, y) + static_cast<double>(center_) / raster::kSubpixels;
}

void PassGeometry::add(const NearTriangle& near) {
    const raster::Triangle& triangle = near.corners;
    const auto [x0, x1]              = std::minmax({triangle[0].x, triangle[1].x, triangle[2].x});
    const auto [y0, y1]              = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
    const auto tile                  = [](float coordinate, int count) {
        return static_cast<int>(std::clamp(std::floor(coordinate / float{kTile}), -1.0f, static_cast<float>(count)));
    };
    for (int y = std::max(0, tile(y0 - 1.0f, height_)); y <= std::min(height_ - 1, tile(y1 + 1.0f, height_)); ++y)
        for (int x = std::max(0, tile(x0 - 1.0f, width_)); x <= std::min(width_ - 1, tile(x1 + 1.0f, width_)); ++x)
            tiles_[static_cast<std::size_t>(y * width_ + x)].push_back(near);
}

const std::vector<PassGeometry::NearTriangle>& PassGeometry::near(int x, int y) const {
    return tiles_[static_cast<std::size_t>(y / kTile * width_ + x / kTile)];
}

bool PassGeometry::has_sliver(int x, int y) const {
    const glm::dvec2 center = center_of(x, y);
    std::optional<Edge> first;
    for (const NearTriangle& triangle : near(x, y))
        for (const Edge& edge : edges_near(triangle.corners, center, reach_)) {
            if (first && !is_same(*first, edge)) return true;
            first = edge;
        }
    return false;
}

bool PassGeometry::has_edge(int x, int y) const {
    const glm::dvec2 center = center_of(x, y);
    const auto& triangles   = near(x, y);
    return std::any_of(triangles.begin(), triangles.end(), [&](const NearTriangle& triangle) {
        return !edges_near(triangle.corners, center, reach_).empty();
    });
}

std::vector<PassGeometry::Surface> PassGeometry::surfaces_at(int x, int y) const {
    const glm::dvec2 center       = center_of(x, y);
    std::vector<Surface> surfaces = flat_surfaces_;
    for (const NearTriangle& triangle : near(x, y)) {
        if (triangle.is_culled) continue;
        const auto weights = weights_at(triangle.corners, center, reach_);
        if (!weights) continue;
        double depth = 0.0;
        for (std::size_t i = 0; i < 3; ++i) depth += (*weights)[i] * double{triangle.corners[i].z};
        const double reach =
            reach_ * slope(triangle.corners, triangle.corners[0].z, triangle.corners[1].z, triangle.corners[2].z) +
            depth_step_;
        surfaces.push_back(
            {depth, reach, triangle.is_of_pass, triangle.writes_depth, &triangle.corners, triangle.same_view});
    }
    return surfaces;
}

bool PassGeometry::has_depth_tie(int x, int y) const {
    const CompareFunc func = pass_.state.depth.func;
    if (func != CompareFunc::Less && func != CompareFunc::LessEqual) return false;
    const std::vector<Surface> surfaces = surfaces_at(x, y);
    const auto is_hidden                = [&](const Surface& back) {
        return std::any_of(surfaces.begin(), surfaces.end(), [&](const Surface& front) {
            return front.writes_depth && front.depth + front.reach < back.depth - back.reach;
        });
    };
    // Triangles of a mesh that meet at the centre are one surface, and so is one that a later pass draws again, unless it goes
    // through another projection.
    const auto are_one = [](const Surface& a, const Surface& b) {
        if (a.triangle == nullptr || b.triangle == nullptr || !a.same_view || !b.same_view) return false;
        return a.is_of_pass == b.is_of_pass ? share_corner(*a.triangle, *b.triangle)
                                            : are_same(*a.triangle, *b.triangle);
    };
    const auto tie = [&](const Surface& a, const Surface& b) {
        return (a.is_of_pass || b.is_of_pass) && (a.writes_depth || b.writes_depth) && !are_one(a, b) &&
               std::abs(a.depth - b.depth) <= a.reach + b.reach;
    };
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (tie(surfaces[i], surfaces[j]) && !is_hidden(surfaces[i]) && !is_hidden(surfaces[j])) return true;
    return false;
}

bool PassGeometry::has_tie(int x, int y) const {
    const raster::Subpixel center{x * raster::kSubpixels + center_, y * raster::kSubpixels + center_};
    const auto& triangles = near(x, y);
    return std::any_of(triangles.begin(), triangles.end(),
                       [&](const NearTriangle& near) { return near.is_of_pass && is_on_edge(near.corners, center); }) ||
           std::any_of(pass_.draws.begin(), pass_.draws.end(), [&](const Draw& draw) {
               const auto* rectangle = std::get_if<DrawRectangle>(&draw);
               return rectangle != nullptr && is_on_edge(*rectangle, center);
           });
}

double PassGeometry::perspective(int x, int y) const {
    const glm::dvec2 center = center_of(x, y);
    double greatest         = 0.0;
    for (const NearTriangle& triangle : near(x, y)) {
        if (!triangle.is_of_pass) continue;
        if (const auto weights = weights_at(triangle.corners, center, reach_))
            greatest = std::max(greatest, perspective_difference(triangle.corners, *weights));
    }
    return greatest;
}

double PassGeometry::change_within(double pixels, int x, int y) const {
    const glm::dvec2 center = center_of(x, y);
    double greatest         = 0.0;
    for (const NearTriangle& triangle : near(x, y))
        if (triangle.is_of_pass && !triangle.is_culled && weights_at(triangle.corners, center, reach_))
            greatest = std::max(greatest, pixels * steepest_color(triangle.corners));
    return std::min(greatest, 255.0);
}

}  // namespace peers
