// SPDX-License-Identifier: MIT
#include "pipeline/truth/vertices.h"

namespace pipeline::truth {
namespace {

constexpr double kLeastW    = 0x1p-32;
constexpr double kGuardBand = 4096.0;  // pixels
constexpr int kPlanes       = 7;

// Negative outside.
double distance_to(int plane, const glm::dvec4& p, double gx, double gy) {
    const double distances[kPlanes] = {p.w - kLeastW,  p.z,           p.w - p.z, gx * p.w + p.x, gx * p.w - p.x,
                                       gy * p.w + p.y, gy * p.w - p.y};
    return distances[plane];
}

ClipVertex between(const ClipVertex& a, const ClipVertex& b, double t) {
    ClipVertex out;
    out.position = a.position + t * (b.position - a.position);
    out.diffuse  = a.diffuse + t * (b.diffuse - a.diffuse);
    out.specular = a.specular + t * (b.specular - a.specular);
    for (std::size_t i = 0; i < out.uv.size(); ++i) out.uv[i] = a.uv[i] + t * (b.uv[i] - a.uv[i]);
    return out;
}

}  // namespace

// Each edge is cut from its inside end, so that triangles with a common edge get the same corner on it.
std::vector<ClipVertex> clip(const std::array<ClipVertex, 3>& triangle, const PixelRect& viewport) {
    const double gx = 1.0 + 2.0 * kGuardBand / (viewport.x1 - viewport.x0);
    const double gy = 1.0 + 2.0 * kGuardBand / (viewport.y1 - viewport.y0);
    std::vector<ClipVertex> polygon(triangle.begin(), triangle.end());
    for (int plane = 0; plane < kPlanes; ++plane) {
        std::vector<ClipVertex> kept;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const ClipVertex &here = polygon[i], &next = polygon[(i + 1) % polygon.size()];
            const double d_here = distance_to(plane, here.position, gx, gy);
            const double d_next = distance_to(plane, next.position, gx, gy);
            if (d_here >= 0.0) kept.push_back(here);
            if (d_here >= 0.0 && d_next < 0.0) kept.push_back(between(here, next, d_here / (d_here - d_next)));
            if (d_here < 0.0 && d_next >= 0.0) kept.push_back(between(next, here, d_next / (d_next - d_here)));
        }
        polygon = std::move(kept);
    }
    return polygon;
}

}  // namespace pipeline::truth
