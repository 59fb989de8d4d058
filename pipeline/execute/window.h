// SPDX-License-Identifier: MIT
// The viewport transform, snapping, culling, and the guard band as bounds of its result. The formulas stand at
// pipeline/execute/vertex_stage.h.
#pragma once

#include <algorithm>

#include "pipeline/execute/clip.h"
#include "pipeline/frame/frame.h"
#include "raster/primitives.h"
#include "raster/vertex_blocks.h"

namespace pipeline {

inline constexpr float kGuardBand = 4096.0f;  // pixels; with targets of 8192 this stays within raster::kMaxCoordinate

// Twice the area of a triangle in subpixels, positive if its corners go clockwise on the screen.
inline std::int64_t area_of(const raster::Subpixel& a, const raster::Subpixel& b, const raster::Subpixel& c) {
    return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

inline bool is_culled(CullMode mode, std::int64_t area) {
    switch (mode) {
        case CullMode::None:
            return area == 0;
        case CullMode::Clockwise:
            return area >= 0;
        case CullMode::CounterClockwise:
            return area <= 0;
    }
    return false;
}

class Window {
  public:
    Window(const PixelRect& viewport, const raster::PixelGrid& grid, float guard_band)
        : grid_(grid),
          band_(guard_band),
          x_(static_cast<float>(viewport.x0)),
          y_(static_cast<float>(viewport.y0)),
          width_(static_cast<float>(viewport.x1 - viewport.x0)),
          height_(static_cast<float>(viewport.y1 - viewport.y0)) {}

    ClipVolume guard_band() const { return {.gx = 1.0 + 2.0 * band_ / width_, .gy = 1.0 + 2.0 * band_ / height_}; }

    void place(const Vec4& clip, raster::Vertex& vertex) const {
        const float x = x_ + (1.0f + clip.x / clip.w) * width_ / 2.0f;
        const float y = y_ + (1.0f - clip.y / clip.w) * height_ / 2.0f;
        vertex.x      = std::clamp(x, x_ - band_, x_ + width_ + band_);
        vertex.y      = std::clamp(y, y_ - band_, y_ + height_ + band_);
        vertex.z      = std::clamp(clip.z / clip.w, 0.0f, 1.0f);
        vertex.rhw    = 1.0f / clip.w;
    }

    raster::Subpixel snap(const raster::Vertex& vertex) const {
        return raster::snap_to_subpixels(grid_, vertex.x, vertex.y);
    }

    // The same for the kernels.
    raster::WindowTransform transform() const {
        return {.x       = x_,
                .y       = y_,
                .width   = width_,
                .height  = height_,
                .band    = band_,
                .gx      = guard_band().gx,
                .gy      = guard_band().gy,
                .least_w = kLeastW,
                .grid    = grid_};
    }

  private:
    raster::PixelGrid grid_;
    float band_;  // pixels around the viewport
    float x_, y_, width_, height_;
};

}  // namespace pipeline
