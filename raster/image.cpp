// SPDX-License-Identifier: MIT
#include "raster/image.h"

#include <cstring>

namespace raster {

Image::Image(int width, int height) : width_(width), height_(height) {
    constexpr std::ptrdiff_t kPageInPixels = 4096 / sizeof(std::uint32_t);
    stride_                                = (width + kBlockWidth - 1) / kBlockWidth * kBlockWidth;
    if (stride_ % kPageInPixels == 0) stride_ += kBlockWidth;
    pixels_.reset(static_cast<std::uint32_t*>(::operator new[](bytes(), std::align_val_t{64})));
    clear();
}

void Image::clear() {
    if (pixels_) std::memset(pixels_.get(), 0, bytes());
}

}  // namespace raster
