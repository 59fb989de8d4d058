// SPDX-License-Identifier: MIT
#include "pipeline/check/memory_map.h"

#include "pipeline/check/memory_layouts.h"
#include "pipeline/validate/findings.h"

namespace pipeline {

std::string target_name(const Frame& frame, std::size_t index) {
    return Place("target", index, frame.targets[index].name).text();
}

std::string texture_name(const Frame& frame, std::size_t index) {
    return Place("texture", index, frame.textures[index].name).text();
}

int sampled_levels(const Texture& texture, const Profile& profile) {
    return profile.states.mip_filters == std::vector<MipFilter>{MipFilter::None} ? 1 : texture.levels;
}

void RegionBuilder::add(std::string what, std::uint64_t bytes, std::uint64_t alignment, std::uint64_t pitch) {
    const std::uint64_t address = rounded_up(end_, alignment);
    blocks_.push_back({std::move(what), index_, address, bytes, pitch});
    end_ = address + bytes;
}

void RegionBuilder::finish(std::string_view name, std::uint64_t budget, MemoryMap& map) {
    map.regions.push_back(region_of(name, budget, end_));
    map.blocks.insert(map.blocks.end(), blocks_.begin(), blocks_.end());
}

MemoryRegion region_of(std::string_view name, std::uint64_t budget, std::uint64_t used) {
    return {name, budget, used, budget != 0 && used > budget ? used - budget : 0};
}

MemoryMap lay_out(const Frame& frame, const Profile& profile) {
    switch (profile.limits.layout) {
        case MemoryLayout::Surfaces:
            return lay_out_surfaces(frame, profile);
        case MemoryLayout::GsPages:
            return lay_out_pages(frame, profile);
        case MemoryLayout::FlipperTiles:
            return lay_out_tiles(frame, profile);
    }
    return {};
}

}  // namespace pipeline
