// SPDX-License-Identifier: MIT
#include "raster/image.h"

#include <algorithm>

namespace raster {

Image::Image(int width, int height) : width_(width), height_(height) {
    constexpr std::ptrdiff_t kPageInPixels = 4096 / sizeof(std::uint32_t);
    stride_                                = (width + kBlockWidth - 1) / kBlockWidth * kBlockWidth;
    if (stride_ % kPageInPixels == 0) stride_ += kBlockWidth;
    const std::size_t count = static_cast<std::size_t>(stride_) * static_cast<std::size_t>(height);
    pixels_                 = PixelBuffer(count);
    std::fill_n(pixels_.data(), count, 0u);
}

}  // namespace raster
