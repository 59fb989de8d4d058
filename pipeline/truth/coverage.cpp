// SPDX-License-Identifier: MIT
#include "pipeline/truth/coverage.h"

#include <cmath>
#include <tuple>

namespace pipeline::truth {
namespace {

Side side_of(const WindowCorner& a, const WindowCorner& b) {
    Side side{.x = a.x, .y = a.y, .to_x = b.x, .to_y = b.y};
    side.is_top_left = (b.y == a.y && b.x > a.x) || b.y < a.y;
    side.is_reversed = std::tie(b.x, b.y) < std::tie(a.x, a.y);
    if (side.is_reversed) {
        std::swap(side.x, side.to_x);
        std::swap(side.y, side.to_y);
    }
    return side;
}

// In one order, whichever corner the triangle begins with, so that what is drawn twice has the same depths.
WindowTriangle sorted(WindowTriangle triangle) {
    std::sort(triangle.begin(), triangle.end(), [](const WindowCorner& a, const WindowCorner& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    });
    return triangle;
}

double doubled_area(const WindowTriangle& t) {
    return (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[2].x - t[0].x) * (t[1].y - t[0].y);
}

template <class Value>
Plane plane_of(const WindowTriangle& t, Value value) {
    const double v0 = value(t[0]), v1 = value(t[1]) - v0, v2 = value(t[2]) - v0;
    const double area = doubled_area(t);
    return {v0, (v1 * (t[2].y - t[0].y) - v2 * (t[1].y - t[0].y)) / area,
            (v2 * (t[1].x - t[0].x) - v1 * (t[2].x - t[0].x)) / area};
}

}  // namespace

bool Side::has_inside(double px, double py) const {
    double e = (to_x - x) * (py - y) - (to_y - y) * (px - x);
    if (is_reversed) e = -e;
    return e > 0.0 || (e == 0.0 && is_top_left);
}

CoveredTriangle::CoveredTriangle(const WindowTriangle& triangle) {
    WindowTriangle clockwise = triangle;
    if (doubled_area(clockwise) < 0.0) std::swap(clockwise[1], clockwise[2]);
    for (std::size_t i = 0; i < 3; ++i) sides_[i] = side_of(clockwise[i], clockwise[(i + 1) % 3]);
    std::tie(left, right)           = std::minmax({triangle[0].x, triangle[1].x, triangle[2].x});
    std::tie(top, bottom)           = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
    std::tie(least_z_, greatest_z_) = std::minmax({triangle[0].z, triangle[1].z, triangle[2].z});

    const WindowTriangle t = sorted(triangle);
    origin_x_              = t[0].x;
    origin_y_              = t[0].y;
    depth_                 = plane_of(t, [](const WindowCorner& c) { return c.z; });
    for (int i = 0; i < 4; ++i) {
        diffuse_[i]  = plane_of(t, [&](const WindowCorner& c) { return c.diffuse[i]; });
        specular_[i] = plane_of(t, [&](const WindowCorner& c) { return c.specular[i]; });
    }
    for (std::size_t i = 0; i < textures_.size(); ++i) {
        const auto over_w = [&](int k) {
            return plane_of(t, [&](const WindowCorner& c) { return c.uv[i][k] * c.rhw; });
        };
        double largest_q = 0.0;
        for (const WindowCorner& c : t) largest_q = std::max(largest_q, std::abs(c.uv[i].z * c.rhw));
        // Where q is not positive nothing lies before the projector; a vanishing q stands in, as in `execute`.
        textures_[i] = {over_w(0), over_w(1), over_w(2), std::max(largest_q * 0x1p-29, 0x1p-1000)};
    }
}

bool CoveredTriangle::covers(double x, double y) const {
    return sides_[0].has_inside(x, y) && sides_[1].has_inside(x, y) && sides_[2].has_inside(x, y);
}

double CoveredTriangle::at(const Plane& plane, double x, double y) const {
    return plane.value + plane.dx * (x - origin_x_) + plane.dy * (y - origin_y_);
}

Color CoveredTriangle::color_at(const std::array<Plane, 4>& planes, double x, double y) const {
    return clamp01(Color(at(planes[0], x, y), at(planes[1], x, y), at(planes[2], x, y), at(planes[3], x, y)));
}

TexturePoint CoveredTriangle::point_at(const TexturePlanes& planes, double x, double y, double center_x,
                                       double center_y) const {
    const auto q_at = [&](double px, double py) { return std::max(at(planes.q, px, py), planes.least_q); };
    const double q = q_at(x, y), center_q = q_at(center_x, center_y);
    TexturePoint p{.u        = at(planes.s, x, y) / q,
                   .v        = at(planes.t, x, y) / q,
                   .center_u = at(planes.s, center_x, center_y) / center_q,
                   .center_v = at(planes.t, center_x, center_y) / center_q};
    p.ux = (planes.s.dx - p.u * planes.q.dx) / q;
    p.vx = (planes.t.dx - p.v * planes.q.dx) / q;
    p.uy = (planes.s.dy - p.u * planes.q.dy) / q;
    p.vy = (planes.t.dy - p.v * planes.q.dy) / q;
    return p;
}

Fragment CoveredTriangle::at(double x, double y, double center_x, double center_y, const FragmentSetup& setup) const {
    Fragment out{.depth    = std::clamp(at(depth_, x, y), least_z_, greatest_z_),
                 .diffuse  = color_at(diffuse_, x, y),
                 .specular = color_at(specular_, x, y),
                 .points   = {}};
    for (std::size_t i = 0; i < textures_.size(); ++i)
        if (setup.textures[i].texture || setup.textures[i].target)
            out.points[i] = point_at(textures_[i], x, y, center_x, center_y);
    return out;
}

bool covers(const DrawRectangle& rectangle, double x, double y) {
    return rectangle.x0 <= x && x < rectangle.x1 && rectangle.y0 <= y && y < rectangle.y1;
}

Fragment fragment_at(const DrawRectangle& rectangle, double x, double y, double center_x, double center_y) {
    Fragment out{.depth = rectangle.depth, .diffuse = to_color(rectangle.color), .points = {}};
    for (std::size_t i = 0; i < out.points.size(); ++i) {
        const UvRect& uv = rectangle.uv[i];
        const double ux  = (double{uv.u1} - uv.u0) / (double{rectangle.x1} - rectangle.x0);
        const double vy  = (double{uv.v1} - uv.v0) / (double{rectangle.y1} - rectangle.y0);
        out.points[i]    = {.u        = uv.u0 + ux * (x - rectangle.x0),
                            .v        = uv.v0 + vy * (y - rectangle.y0),
                            .center_u = uv.u0 + ux * (center_x - rectangle.x0),
                            .center_v = uv.v0 + vy * (center_y - rectangle.y0),
                            .ux       = ux,
                            .vy       = vy};
    }
    return out;
}

}  // namespace pipeline::truth
