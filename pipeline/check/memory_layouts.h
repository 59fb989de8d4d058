// SPDX-License-Identifier: MIT
// The layouts of memory_map.h, one file each, and what they share.
#pragma once

#include "pipeline/check/memory_map.h"

namespace pipeline {

MemoryMap lay_out_surfaces(const Frame& frame, const Profile& profile);
MemoryMap lay_out_pages(const Frame& frame, const Profile& profile);
MemoryMap lay_out_tiles(const Frame& frame, const Profile& profile);

// Places blocks one after the other. index: the region's in the map.
class RegionBuilder {
  public:
    explicit RegionBuilder(std::size_t index) : index_(index) {}

    void add(std::string what, std::uint64_t bytes, std::uint64_t alignment, std::uint64_t pitch);
    // Hands the region over; those before it must be there.
    void finish(std::string_view name, std::uint64_t budget, MemoryMap& map);

  private:
    std::size_t index_;
    std::uint64_t end_ = 0;
    std::vector<MemoryBlock> blocks_;
};

MemoryRegion region_of(std::string_view name, std::uint64_t budget, std::uint64_t used);

std::string target_name(const Frame& frame, std::size_t index);
std::string texture_name(const Frame& frame, std::size_t index);

// Without those that no mip filter of the chip reads.
int sampled_levels(const Texture& texture, const Profile& profile);

constexpr std::uint64_t divided_up(std::uint64_t value, std::uint64_t by) {
    return (value + by - 1) / by;
}
constexpr std::uint64_t rounded_up(std::uint64_t value, std::uint64_t step) {
    return divided_up(value, step) * step;
}

// Of a size: pixels of mip level `level` along one axis.
constexpr std::uint64_t level_size(std::int32_t size, int level) {
    return size >> level > 1 ? static_cast<std::uint64_t>(size >> level) : 1;
}

}  // namespace pipeline
