// SPDX-License-Identifier: MIT
// The Graphics Synthesizer's local memory. TEX0.TBP0 is an address / 256, FRAME.FBP and ZBUF.ZBP are one / 8192, and a
// width in FBW or TBW is a pitch / 64.
#include <algorithm>

#include "pipeline/check/memory_layouts.h"

namespace pipeline {

namespace {

constexpr std::uint64_t kPageBytes = 8192, kBlockBytes = 256, kBlocksInPage = 32;
constexpr std::uint64_t kPaletteBytes = 256 * 4;

struct PageSize {
    std::uint64_t width, height;
};

PageSize page_of(TargetFormat format) {
    return bytes_per_pixel(format) == 2 ? PageSize{64, 64} : PageSize{64, 32};
}

// PSMCT32, and PSMT8 for A8 and L8: both have 8x4 blocks in a page, in one order.
PageSize page_of(TextureFormat format) {
    return format == TextureFormat::A8R8G8B8 ? PageSize{64, 32} : PageSize{128, 64};
}
constexpr std::uint64_t kBlocksX = 8, kBlocksY = 4;
constexpr std::uint8_t kBlockOrder[kBlocksY][kBlocksX] = {
    {0, 1, 4, 5, 16, 17, 20, 21},
    {2, 3, 6, 7, 18, 19, 22, 23},
    {8, 9, 12, 13, 24, 25, 28, 29},
    {10, 11, 14, 15, 26, 27, 30, 31},
};

// Blocks from the first to the last that holds texels of width x height.
std::uint64_t block_count(std::uint64_t width, std::uint64_t height, const PageSize& page) {
    const std::uint64_t blocks_x     = divided_up(width, page.width / kBlocksX),
                        blocks_y     = divided_up(height, page.height / kBlocksY);
    const std::uint64_t pages_in_row = divided_up(width, page.width);
    std::uint64_t last               = 0;
    for (std::uint64_t y = 0; y < blocks_y; ++y) {
        for (std::uint64_t x = 0; x < blocks_x; ++x) {
            const std::uint64_t page_number = y / kBlocksY * pages_in_row + x / kBlocksX;
            last = std::max(last, page_number * kBlocksInPage + kBlockOrder[y % kBlocksY][x % kBlocksX]);
        }
    }
    return last + 1;
}

void add_target(const Frame& frame, std::size_t index, RegionBuilder& memory) {
    const Target& target = frame.targets[index];
    const PageSize page  = page_of(target.format);
    const std::uint64_t pages =
        divided_up(level_size(target.width, 0), page.width) * divided_up(level_size(target.height, 0), page.height);
    memory.add(target_name(frame, index), pages * kPageBytes, kPageBytes,
               rounded_up(level_size(target.width, 0), page.width));
}

void add_texture(const Frame& frame, std::size_t index, int levels, RegionBuilder& memory) {
    const Texture& texture = frame.textures[index];
    const PageSize page    = page_of(texture.format);
    std::uint64_t blocks   = 0;
    for (int level = 0; level < levels; ++level)
        blocks += block_count(level_size(texture.width, level), level_size(texture.height, level), page);
    memory.add(texture_name(frame, index), blocks * kBlockBytes, kBlockBytes,
               rounded_up(level_size(texture.width, 0), page.width));
}

}  // namespace

MemoryMap lay_out_pages(const Frame& frame, const Profile& profile) {
    RegionBuilder memory(0);
    for (std::size_t i = 0; i < frame.targets.size(); ++i) add_target(frame, i, memory);
    for (std::size_t i = 0; i < frame.textures.size(); ++i)
        add_texture(frame, i, sampled_levels(frame.textures[i], profile), memory);
    for (const TextureFormat format : {TextureFormat::A8, TextureFormat::L8}) {
        const bool is_used = std::any_of(frame.textures.begin(), frame.textures.end(),
                                         [&](const Texture& texture) { return texture.format == format; });
        if (is_used) memory.add("palette of " + std::string(enum_name(format)), kPaletteBytes, kBlockBytes, 16);
    }
    MemoryMap map;
    memory.finish("local memory", profile.limits.memory, map);
    return map;
}

}  // namespace pipeline
