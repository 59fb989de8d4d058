// SPDX-License-Identifier: MIT
#include "raster/reference_plane.h"

#include <cmath>
#include <utility>

#include "raster/tile.h"

namespace raster::reference {

std::int64_t snap(const PixelGrid& grid, float pixels) {
    // Times 16 is exact, nearbyint takes ties to even in the default rounding mode, and a conversion truncates.
    const float subpixels = pixels * 16.0f;
    return static_cast<std::int64_t>(grid.truncate ? subpixels : std::nearbyint(subpixels));
}

Corners snap_clockwise(const PixelGrid& grid, Triangle& triangle) {
    const auto snapped = [&] {
        Corners c;
        c.center = grid.center;
        for (int i = 0; i < 3; ++i) {
            c.x[i] = snap(grid, triangle[i].x);
            c.y[i] = snap(grid, triangle[i].y);
        }
        // Less than 2^40, for coordinates of at most 2^18.
        c.d = (c.x[1] - c.x[0]) * (c.y[2] - c.y[0]) - (c.x[2] - c.x[0]) * (c.y[1] - c.y[0]);
        return c;
    };
    const Corners corners = snapped();
    if (corners.d >= 0) return corners;
    std::swap(triangle[1], triangle[2]);
    return snapped();
}

bool covers(const Corners& c, int x, int y) {
    const std::int64_t px = 16 * std::int64_t{x} + c.center, py = 16 * std::int64_t{y} + c.center;
    for (int a = 0; a < 3; ++a) {
        const int b          = (a + 1) % 3;
        const std::int64_t e = (c.x[b] - c.x[a]) * (py - c.y[a]) - (c.y[b] - c.y[a]) * (px - c.x[a]);
        const bool top       = c.y[b] == c.y[a] && c.x[b] > c.x[a];
        const bool left      = c.y[b] < c.y[a];
        if (e < 0 || (e == 0 && !top && !left)) return false;
    }
    return true;
}

std::uint64_t Plane::at(int x, int y) const {
    const std::int64_t dx = 16 * std::int64_t{x} + center - x0;
    const std::int64_t dy = 16 * std::int64_t{y} + center - y0;
    return v0 + gx * static_cast<std::uint64_t>(dx) + gy * static_cast<std::uint64_t>(dy);
}

std::uint32_t Plane::value(int x, int y) const {
    const int xb = x / kBlockWidth * kBlockWidth;  // x is not negative: a pixel of an image
    return rounded(at(xb, y), s) + static_cast<std::uint32_t>(x - xb) * rounded(16 * gx, s);
}

Plane make_plane(const Corners& c, const std::array<std::int64_t, 3>& v, int f, int s) {
    const std::int64_t one = std::int64_t{1} << f;
    // Less than 2^50 before the scale of at most 2^12 (2^28 and 2^23 for bytes), for differences of coordinates of at
    // most 2^19. Division of integers truncates.
    const std::int64_t nx  = (v[1] - v[0]) * (c.y[2] - c.y[0]) - (v[2] - v[0]) * (c.y[1] - c.y[0]);
    const std::int64_t ny  = (v[2] - v[0]) * (c.x[1] - c.x[0]) - (v[1] - v[0]) * (c.x[2] - c.x[0]);
    Plane plane;
    plane.v0     = static_cast<std::uint64_t>(v[0] * one);
    plane.gx     = static_cast<std::uint64_t>(nx * one / c.d);
    plane.gy     = static_cast<std::uint64_t>(ny * one / c.d);
    plane.x0     = c.x[0];
    plane.y0     = c.y[0];
    plane.s      = s;
    plane.center = c.center;
    return plane;
}

std::uint32_t rounded(std::uint64_t p, int s) {
    const std::uint64_t half = std::uint64_t{1} << (s - 1);
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(p + half) >> s);
}

std::int64_t depth_at_vertex(float z) {
    constexpr double kOne = (1 << kDepthBits) - 1;
    return static_cast<std::int64_t>(std::nearbyint(double{z} * kOne));
}

std::uint32_t depth_in_format(std::uint32_t value, int bits) {
    if (bits == 32) return value * 4 + (value >> 28);
    return value >> (kDepthBits - bits);
}

}  // namespace raster::reference
