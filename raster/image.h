// SPDX-License-Identifier: MIT
// A target in memory: 32 bits a pixel, rows from the top. Colour is 0xAARRGGBB; depth is an unsigned integer in units
// of its format. Rows start on a cache line, hold whole blocks, and are never a multiple of 4096 bytes apart, so that a
// column of tiles does not fall into a few cache sets.
#pragma once

#include <cstddef>
#include <cstdint>

#include "raster/pixel_buffer.h"
#include "raster/tile.h"

namespace raster {

class Image {
  public:
    Image() = default;
    Image(int width, int height);  // all zeros

    int width() const { return width_; }
    int height() const { return height_; }
    std::ptrdiff_t stride() const { return stride_; }  // pixels from one row to the next
    std::uint32_t* row(int y) { return pixels_.data() + y * stride_; }
    const std::uint32_t* row(int y) const { return pixels_.data() + y * stride_; }
    Rect bounds() const { return {0, 0, width_, height_}; }

  private:
    int width_ = 0, height_ = 0;
    std::ptrdiff_t stride_ = 0;
    PixelBuffer pixels_;
};

}  // namespace raster
