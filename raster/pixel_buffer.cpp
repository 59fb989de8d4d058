// SPDX-License-Identifier: MIT
#include "raster/pixel_buffer.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace raster {
namespace {

constexpr std::size_t kLine = 64, kHugePage = std::size_t{1} << 21;

}  // namespace

PixelBuffer::PixelBuffer(std::size_t count) {
    const std::size_t bytes = count * sizeof(std::uint32_t);
    const std::align_val_t alignment{bytes >= kHugePage ? kHugePage : kLine};
    pixels_ = {static_cast<std::uint32_t*>(::operator new[](bytes, alignment)), Free{alignment}};
#if defined(MADV_HUGEPAGE)
    if (bytes >= kHugePage) madvise(pixels_.get(), bytes, MADV_HUGEPAGE);  // only a hint: it may fail
#endif
}

}  // namespace raster
