// SPDX-License-Identifier: MIT
#include "pipeline/legalize/halved_textures.h"

#include <algorithm>

namespace pipeline {

namespace {

std::size_t texels_of(std::int32_t width, std::int32_t height) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

void drop_level(Texture& texture) {
    const auto bytes = static_cast<std::ptrdiff_t>(texels_of(texture.width, texture.height) *
                                                   static_cast<std::size_t>(bytes_per_texel(texture.format)));
    texture.texels.erase(texture.texels.begin(), texture.texels.begin() + bytes);
    --texture.levels;
}

void average(Texture& texture) {
    const auto step = static_cast<std::size_t>(bytes_per_texel(texture.format)),
               row  = static_cast<std::size_t>(texture.width) * step;
    std::vector<std::uint8_t> texels;
    for (std::size_t y = 0; y < static_cast<std::size_t>(texture.height); y += 2)
        for (std::size_t x = 0; x < static_cast<std::size_t>(texture.width); x += 2)
            for (std::size_t c = 0; c < step; ++c) {
                const std::size_t at = y * row + x * step + c;
                const int sum        = texture.texels[at] + texture.texels[at + step] + texture.texels[at + row] +
                                texture.texels[at + row + step];
                texels.push_back(static_cast<std::uint8_t>((sum + 2) / 4));
            }
    texture.texels = std::move(texels);
}

bool can_halve(const Texture& texture) {
    return std::max(texture.width, texture.height) > kLeastHalved &&
           (texture.levels > 1 || (texture.width % 2 == 0 && texture.height % 2 == 0));
}

}  // namespace

Frame with_halved_textures(Frame frame, int times) {
    for (Texture& texture : frame.textures)
        for (int i = 0; i < times && can_halve(texture); ++i) {
            if (texture.levels > 1)
                drop_level(texture);
            else
                average(texture);
            texture.width  = std::max(1, texture.width / 2);
            texture.height = std::max(1, texture.height / 2);
        }
    return frame;
}

}  // namespace pipeline
