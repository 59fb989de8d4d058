// SPDX-License-Identifier: MIT
#include "raster/triangle_setup.h"

#include <algorithm>
#include <cmath>

namespace raster {
namespace {

// The pixels that are sampled in [low, high] subpixels, as a half-open range.
int first_pixel(const PixelGrid& grid, std::int64_t low) {
    return static_cast<int>((low - grid.center + kSubpixels - 1) >> kSubpixelBits);
}
int end_pixel(const PixelGrid& grid, std::int64_t high) {
    return static_cast<int>((high - grid.center) >> kSubpixelBits) + 1;
}
Rect pixels_between(const PixelGrid& grid, std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) {
    return {first_pixel(grid, x0), first_pixel(grid, y0), end_pixel(grid, x1), end_pixel(grid, y1)};
}

}  // namespace

bool set_up_rectangle(const Rectangle& rectangle, const SetupNeeds& needs, const PixelGrid& grid, const Rect& scissor,
                      SetUpRectangle& out) {
    const auto [x0, y0] = snap_to_subpixels(grid, rectangle.x0, rectangle.y0);
    const auto [x1, y1] = snap_to_subpixels(grid, rectangle.x1, rectangle.y1);
    // The end is open: a pixel sampled exactly on it is outside.
    out.bounds          = intersect(pixels_between(grid, x0, y0, x1 - 1, y1 - 1), scissor);
    if (out.bounds.empty()) return false;
    out.depth = depth_value(rectangle.z);
    out.color = rectangle.color;

    const auto axis = [&grid](float from, float to, int size, std::int64_t begin, std::int64_t end) {
        static constexpr double kTexel = 4294967296.0;           // 2^32
        static constexpr double kLimit = 4611686018427387904.0;  // 2^62
        const auto integer             = [](double value) {
            return static_cast<std::uint64_t>(
                static_cast<std::int64_t>(std::nearbyint(std::clamp(value, -kLimit, kLimit))));
        };
        const double w0 = static_cast<double>(from) * size, w1 = static_cast<double>(to) * size;
        const double step   = (w1 - w0) * (kTexel * kSubpixels) / static_cast<double>(end - begin);
        const double origin = w0 * kTexel + static_cast<double>(grid.center - begin) / kSubpixels * step;
        return AxisPlane{integer(origin), integer(step)};
    };
    for (int i = 0; i < kMaxTextures; ++i) {
        if (!needs.texture[i]) continue;
        SetUpRectangle::Texture& texture = out.textures[i];
        const Rectangle::UvRect& uv      = rectangle.uv[i];
        texture.u                        = axis(uv.u0, uv.u1, needs.width[i], x0, x1);
        texture.v                        = axis(uv.v0, uv.v1, needs.height[i], y0, y1);
        const auto per_pixel             = [](std::uint64_t step) {
            return static_cast<float>(static_cast<double>(static_cast<std::int64_t>(step)) / 4294967296.0);
        };
        texture.ux = per_pixel(texture.u.step);
        texture.vy = per_pixel(texture.v.step);
    }
    return true;
}

}  // namespace raster
