// SPDX-License-Identifier: MIT
#include "raster/image.h"

#include <cstring>

namespace raster {

Image::Image(int width, int height) : width_(width), height_(height) {
    constexpr std::ptrdiff_t kPageInPixels = 4096 / sizeof(std::uint32_t);
    stride_                                = (width + kBlockWidth - 1) / kBlockWidth * kBlockWidth;
    if (stride_ % kPageInPixels == 0) stride_ += kBlockWidth;
    pixels_ = PixelBuffer(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(height));
    clear();
}

void Image::clear() {
    if (pixels_.data()) std::memset(pixels_.data(), 0, pixels_.size() * sizeof(std::uint32_t));
}

}  // namespace raster
