// SPDX-License-Identifier: MIT
#include "raster/alpha_quads.h"

#include <algorithm>

namespace raster {

void pack_alpha_quads(const std::uint8_t* alphas, int width, int height, std::uint32_t* out) {
    const auto row = [&](int j) { return alphas + static_cast<std::ptrdiff_t>(std::clamp(j, 0, height - 1)) * width; };
    for (int j = -1; j < height; ++j) {
        const std::uint8_t *const above = row(j), *const below = row(j + 1);
        for (int i = -1; i < width; ++i) {
            const int left = std::max(i, 0), right = std::min(i + 1, width - 1);
            *out++ =
                above[left] | above[right] << 8 | below[left] << 16 | static_cast<std::uint32_t>(below[right]) << 24;
        }
    }
}

}  // namespace raster
