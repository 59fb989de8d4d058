// SPDX-License-Identifier: MIT
#include "demo/texture_pyramid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace demo {
namespace {

struct Picture {
    int width, height;
    std::vector<std::uint32_t> pixels;
    std::uint32_t at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

template <class PerChannel>
std::uint32_t for_each_channel(PerChannel&& value_of) {
    std::uint32_t pixel = 0;
    for (int shift = 0; shift < 32; shift += 8) pixel |= static_cast<std::uint32_t>(value_of(shift)) << shift;
    return pixel;
}

std::uint32_t channel(std::uint32_t pixel, int shift) {
    return (pixel >> shift) & 0xffu;
}

int power_of_two_near(int size) {
    int power = 1;
    while (power < kMaxTextureSize && power * 3 <= size * 2) power *= 2;
    return power;
}

// The mean of the source over each new pixel's rectangle, sampled often enough to meet every source pixel.
Picture resample(const Picture& source, int width, int height) {
    Picture result{width, height, std::vector<std::uint32_t>(static_cast<std::size_t>(width) * height)};
    const int taps_x = (source.width + width - 1) / width, taps_y = (source.height + height - 1) / height;
    const auto taps = static_cast<std::uint32_t>(taps_x * taps_y);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            std::uint32_t sums[4] = {};
            for (int tap_y = 0; tap_y < taps_y; ++tap_y) {
                const auto row =
                    static_cast<int>((2LL * (y * taps_y + tap_y) + 1) * source.height / (2LL * height * taps_y));
                for (int tap_x = 0; tap_x < taps_x; ++tap_x) {
                    const auto column =
                        static_cast<int>((2LL * (x * taps_x + tap_x) + 1) * source.width / (2LL * width * taps_x));
                    const std::uint32_t pixel = source.at(column, row);
                    for (int i = 0; i < 4; ++i) sums[i] += channel(pixel, 8 * i);
                }
            }
            result.pixels[static_cast<std::size_t>(y) * width + x] =
                for_each_channel([&](int shift) { return (sums[shift / 8] + taps / 2) / taps; });
        }
    }
    return result;
}

void store_texels(const Picture& picture, std::uint8_t* texels) {
    for (const std::uint32_t pixel : picture.pixels)
        for (int shift = 0; shift < 32; shift += 8) *texels++ = static_cast<std::uint8_t>(channel(pixel, shift));
}

// From a level of width x height texels the next: half as wide and high, 1 at least.
void halve(const std::uint8_t* source, int width, int height, std::uint8_t* half) {
    const int right = width > 1 ? 4 : 0, below = height > 1 ? 4 * width : 0;  // to the texel beside
    for (int y = 0; y < std::max(height / 2, 1); ++y) {
        const std::uint8_t* upper = source + static_cast<std::ptrdiff_t>(2 * y) * below;
        const std::uint8_t* lower = upper + below;
        for (int x = 0; x < std::max(width / 2, 1); ++x)
            for (int i = 0; i < 4; ++i) {
                const int at = 2 * x * right + i;
                *half++ =
                    static_cast<std::uint8_t>((upper[at] + upper[at + right] + lower[at] + lower[at + right] + 2) / 4);
            }
    }
}

}  // namespace

pipeline::Texture texture_pyramid(std::string name, int width, int height, std::vector<std::uint32_t> pixels) {
    assert(width > 0 && height > 0 && pixels.size() == static_cast<std::size_t>(width) * height);
    Picture level{width, height, std::move(pixels)};
    const int width2 = power_of_two_near(width), height2 = power_of_two_near(height);
    if (width2 != width || height2 != height) level = resample(level, width2, height2);

    pipeline::Texture texture{.name   = std::move(name),
                              .format = pipeline::TextureFormat::A8R8G8B8,
                              .width  = level.width,
                              .height = level.height,
                              .levels = 1,
                              .texels = {}};
    const auto bytes = [&](int of_width, int of_height) { return 4 * static_cast<std::size_t>(of_width) * of_height; };
    std::size_t size = bytes(level.width, level.height);
    for (int w = level.width, h = level.height; w > 1 || h > 1; ++texture.levels) {
        w = std::max(w / 2, 1), h = std::max(h / 2, 1);
        size += bytes(w, h);
    }
    texture.texels.resize(size);
    store_texels(level, texture.texels.data());
    level.pixels         = {};
    std::uint8_t* texels = texture.texels.data();
    for (int w = level.width, h = level.height; w > 1 || h > 1; w = std::max(w / 2, 1), h = std::max(h / 2, 1)) {
        halve(texels, w, h, texels + bytes(w, h));
        texels += bytes(w, h);
    }
    return texture;
}

}  // namespace demo
