// SPDX-License-Identifier: MIT
// Surfaces of a PC card and of the Xbox: rows one after the other, and mip levels after each other.
#include "pipeline/check/memory_layouts.h"
#include "pipeline/validate/check_pass.h"

namespace pipeline {

MemoryMap lay_out_surfaces(const Frame& frame, const Profile& profile) {
    const ChipLimits& limits = profile.limits;
    RegionBuilder memory(0);
    const auto add = [&](std::string what, std::int32_t width, std::int32_t height, int bytes_per, int levels,
                         std::uint32_t alignment) {
        const auto row_bytes = [&](int level) {
            return rounded_up(level_size(width, level) * static_cast<std::uint64_t>(bytes_per), alignment);
        };
        std::uint64_t bytes = 0;
        for (int level = 0; level < levels; ++level) bytes += row_bytes(level) * level_size(height, level);
        memory.add(std::move(what), bytes, limits.address_alignment,
                   row_bytes(0) / static_cast<std::uint64_t>(bytes_per));
    };
    for (std::size_t i = 0; i < frame.targets.size(); ++i) {
        const Target& target = frame.targets[i];
        add(target_name(frame, i), target.width, target.height, bytes_per_pixel(target.format), 1,
            limits.pitch_alignment);
    }
    for (std::size_t i = 0; i < frame.textures.size(); ++i) {
        const Texture& texture = frame.textures[i];
        const bool is_swizzled =
            limits.swizzles_textures && is_power_of_two(texture.width) && is_power_of_two(texture.height);
        add(texture_name(frame, i), texture.width, texture.height, bytes_per_texel(texture.format),
            sampled_levels(texture, profile), is_swizzled ? 1 : limits.pitch_alignment);
    }
    MemoryMap map;
    memory.finish("video memory", limits.memory, map);
    return map;
}

}  // namespace pipeline
