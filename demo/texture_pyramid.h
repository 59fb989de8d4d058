// SPDX-License-Identifier: MIT
// A picture as a texture with all its mip levels. Colour factors 0..1 become bytes by rounding to nearest; each level
// is the mean of 2 x 2 texels of the level above it, rounded half up.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/frame/frame.h"

namespace demo {

// 0xffRRGGBB of factors, clamped to 0..1.
inline pipeline::Argb to_argb(const pipeline::Vec3& color, float alpha = 1.0f) {
    const auto byte = [](float factor) {
        return static_cast<std::uint32_t>(std::clamp(factor, 0.0f, 1.0f) * 255.0f + 0.5f);
    };
    return {byte(alpha) << 24 | byte(color.x) << 16 | byte(color.y) << 8 | byte(color.z)};
}

// pixels: 0xAARRGGBB, rows from the top. Any size: one that is no power of two is resampled to the nearest one, at most
// kMaxTextureSize.
inline constexpr int kMaxTextureSize = 2048;
pipeline::Texture texture_pyramid(std::string name, int width, int height, std::vector<std::uint32_t> pixels);

}  // namespace demo
