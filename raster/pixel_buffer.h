// SPDX-License-Identifier: MIT
// Memory for pixels: starts on a cache line, and uses huge pages where it is large and the system has them. A column of
// tiles touches another page with each row; huge ones are few enough for the processor to keep track of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>

namespace raster {

class PixelBuffer {
  public:
    PixelBuffer() = default;
    explicit PixelBuffer(std::size_t count);  // not initialised

    std::uint32_t* data() { return pixels_.get(); }
    const std::uint32_t* data() const { return pixels_.get(); }

  private:
    struct Free {
        std::align_val_t alignment;
        void operator()(std::uint32_t* pixels) const { ::operator delete[](pixels, alignment); }
    };
    std::unique_ptr<std::uint32_t[], Free> pixels_{nullptr, Free{}};
};

}  // namespace raster
