// SPDX-License-Identifier: MIT
#include "demo/surface_texture.h"

#include <utility>

#include "demo/desert_floor.h"
#include "demo/image_file.h"
#include "demo/rock_texture.h"
#include "demo/texture_pyramid.h"

namespace demo {
namespace {

constexpr std::uint32_t kTextureSeed = 3;
constexpr float kFileTileMeters      = 32.0f;

pipeline::Texture read_texture(const FileReference& file) {
    try {
        pipeline::ColorImage image = read_image(file.path);
        // Alpha is not the file's but how readily rock breaks through sand (rock_texture.h): evenly.
        constexpr auto kEvenly     = static_cast<std::uint32_t>(kLeastBareness * 255.0f + 0.5f) << 24;
        for (std::uint32_t& pixel : image.pixels) pixel = (pixel & 0x00ffffffu) | kEvenly;
        return texture_pyramid(file.path, image.width, image.height, std::move(image.pixels));
    } catch (const std::runtime_error& error) {
        throw SceneError(file.named_at + ": " + error.what());
    }
}

}  // namespace

int TextureLibrary::find(const SurfaceTexture& surface) {
    switch (surface.kind) {
        case SurfaceTexture::Kind::None:
            return -1;
        case SurfaceTexture::Kind::Rock: {
            const int known = find_named(kRockTextureName);
            return known >= 0 ? known : add(rock_texture(kTextureSeed));
        }
        case SurfaceTexture::Kind::Sand: {
            const int known = find_named(kSandTextureName);
            return known >= 0 ? known : add(sand_texture(kTextureSeed));
        }
        case SurfaceTexture::Kind::File: {
            const int known = find_named(surface.file.path);
            return known >= 0 ? known : add(read_texture(surface.file));
        }
    }
    return -1;
}

int TextureLibrary::detail(const SurfaceTexture& surface) {
    const bool is_sand = surface.kind == SurfaceTexture::Kind::Sand;
    const int known    = find_named(is_sand ? kDesertFloorTextureName : kVariationTextureName);
    if (known >= 0) return known;
    return add(is_sand ? desert_floor_texture(kTextureSeed) : variation_texture(kTextureSeed));
}

Vec2 TextureLibrary::detail_size(const SurfaceTexture& surface) {
    if (surface.kind == SurfaceTexture::Kind::Sand) return {kDesertFloorWidth, kDesertFloorHeight};
    return Vec2(kVariationTile);
}

Vec2 TextureLibrary::tile_size(const SurfaceTexture& surface, const std::optional<float>& tile_m) {
    if (surface.kind == SurfaceTexture::Kind::Rock) {
        const float height = tile_m.value_or(kRockTileHeight);
        return {height * (kRockTileWidth / kRockTileHeight), height};
    }
    const float own = surface.kind == SurfaceTexture::Kind::Sand ? kSandTile : kFileTileMeters;
    return Vec2(tile_m.value_or(own));
}

int TextureLibrary::find_named(const std::string& name) const {
    for (std::size_t i = 0; i < geometry_.textures.size(); ++i)
        if (geometry_.textures[i].name == name) return static_cast<int>(i);
    return -1;
}

int TextureLibrary::add(pipeline::Texture texture) {
    geometry_.textures.push_back(std::move(texture));
    return static_cast<int>(geometry_.textures.size()) - 1;
}

}  // namespace demo
