// SPDX-License-Identifier: MIT
// Does the frame fit into the chip's memory?
#include "pipeline/check/chip_findings.h"
#include "pipeline/check/memory_layouts.h"

namespace pipeline {

namespace {

constexpr std::size_t kBlocksNamed = 5;

// "target 0 'back buffer' 3686400, ...": the largest blocks of a region.
std::string largest_blocks(const MemoryMap& map, std::size_t region) {
    std::vector<MemoryBlock> blocks;
    for (const MemoryBlock& block : map.blocks)
        if (block.region == region) blocks.push_back(block);
    std::stable_sort(blocks.begin(), blocks.end(),
                     [](const MemoryBlock& a, const MemoryBlock& b) { return a.bytes > b.bytes; });
    std::string text;
    for (std::size_t i = 0; i < std::min(kBlocksNamed, blocks.size()); ++i)
        text += (i == 0 ? "" : ", ") + blocks[i].what + ' ' + std::to_string(blocks[i].bytes);
    if (blocks.size() > kBlocksNamed) text += ", " + std::to_string(blocks.size() - kBlocksNamed) + " more";
    return text;
}

std::string quoted(const Frame& frame, TargetId id) {
    return target_name(frame, static_cast<std::size_t>(id.index));
}

}  // namespace

void check_memory(const Frame& frame, ChipFindings& findings) {
    const MemoryMap map = lay_out(frame, findings.profile());
    const Place place("frame");
    for (const MemoryClash& clash : map.clashes) {
        const Place pass =
            clash.pass < frame.passes.size() ? Place("pass", clash.pass, frame.passes[clash.pass].label) : place;
        findings.add(pass, "memory",
                     quoted(frame, clash.one) + " and " + quoted(frame, clash.other) + " at the same pixels",
                     "one frame buffer");
    }
    for (std::size_t i = 0; i < map.regions.size(); ++i) {
        const MemoryRegion& region = map.regions[i];
        if (region.over == 0) continue;
        findings.add(
            place, "memory",
            std::to_string(region.used) + " bytes, " + std::to_string(region.over) + " over: " + largest_blocks(map, i),
            std::to_string(region.budget) + " bytes of " + std::string(region.name));
    }
}

}  // namespace pipeline
