// SPDX-License-Identifier: MIT
// The GameCube's embedded frame buffer, and its main memory, which holds textures and what is copied.
#include <algorithm>

#include "pipeline/check/frame_buffer.h"
#include "pipeline/check/memory_layouts.h"

namespace pipeline {

namespace {

constexpr std::uint64_t kBufferBytes = 3;  // of a pixel's colour, and of its depth
constexpr std::uint64_t kAlignment   = 32;

// A tile in texels, and its bytes: I8; 16 bits; RGBA8, whose tiles are two of 32 bytes.
struct Tile {
    std::uint64_t width, height, bytes;
};
Tile tile_of(int bytes_per_texel) {
    if (bytes_per_texel == 1) return {8, 4, 32};
    return bytes_per_texel == 2 ? Tile{4, 4, 32} : Tile{4, 4, 64};
}

void add_tiles(std::string what, std::int32_t width, std::int32_t height, int bytes_per, int levels,
               RegionBuilder& memory) {
    const Tile tile     = tile_of(bytes_per);
    std::uint64_t bytes = 0;
    for (int level = 0; level < levels; ++level)
        bytes += divided_up(level_size(width, level), tile.width) * divided_up(level_size(height, level), tile.height) *
                 tile.bytes;
    memory.add(std::move(what), bytes, kAlignment, rounded_up(level_size(width, 0), tile.width));
}

std::vector<bool> targets_in_buffer(const Frame& frame, const ChipFormats& formats) {
    std::vector<bool> is_in_buffer;
    for (const Target& target : frame.targets)
        is_in_buffer.push_back(is_depth(target.format) || std::find(formats.draw.begin(), formats.draw.end(),
                                                                    target.format) != formats.draw.end());
    return is_in_buffer;
}

void add_frame_buffer(const Frame& frame, const BufferPlaces& places, const ChipLimits& limits, MemoryMap& map) {
    const auto pitch  = static_cast<std::uint64_t>(limits.frame_buffer_width);
    const auto pixels = pitch * static_cast<std::uint64_t>(limits.frame_buffer_height);
    map.regions.push_back(region_of("frame buffer", pixels * 2 * kBufferBytes,
                                    pitch * static_cast<std::uint64_t>(places.rows) * 2 * kBufferBytes));
    for (std::size_t i = 0; i < frame.targets.size(); ++i) {
        if (!places.spots[i]) continue;
        const Target& target      = frame.targets[i];
        const std::uint64_t first = static_cast<std::uint64_t>(places.spots[i]->y) * pitch +
                                    static_cast<std::uint64_t>(places.spots[i]->x) +
                                    (is_depth(target.format) ? pixels : 0);
        map.blocks.push_back({target_name(frame, i), 0, first * kBufferBytes,
                              level_size(target.width, 0) * level_size(target.height, 0) * kBufferBytes, pitch});
    }
    map.clashes = places.clashes;
}

}  // namespace

MemoryMap lay_out_tiles(const Frame& frame, const Profile& profile) {
    const ChipLimits& limits             = profile.limits;
    const std::vector<bool> is_in_buffer = targets_in_buffer(frame, profile.formats);
    MemoryMap map;
    add_frame_buffer(frame, place_targets(frame, is_in_buffer, limits.frame_buffer_width, limits.copy_from_step),
                     limits, map);
    RegionBuilder memory(1);
    for (std::size_t i = 0; i < frame.targets.size(); ++i) {
        const Target& target = frame.targets[i];
        if (!is_in_buffer[i])
            add_tiles(target_name(frame, i), target.width, target.height, bytes_per_pixel(target.format), 1, memory);
    }
    for (std::size_t i = 0; i < frame.textures.size(); ++i) {
        const Texture& texture = frame.textures[i];
        add_tiles(texture_name(frame, i), texture.width, texture.height, bytes_per_texel(texture.format),
                  sampled_levels(texture, profile), memory);
    }
    memory.finish("main memory", limits.memory, map);
    return map;
}

}  // namespace pipeline
