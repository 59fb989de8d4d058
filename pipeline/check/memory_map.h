// SPDX-License-Identifier: MIT
// Where a chip's memory holds the targets and textures of a frame, and how much of it they take. Addresses and sizes are
// in bytes. Each target and each texture has a place of its own through the whole frame; only in the GameCube's frame
// buffer, where there is no other way, do targets share it in turn. Vertices, and a program's other buffers, are not in it.
//   surfaces  rows of a pitch, ChipLimits::pitch_alignment
//   pages     Graphics Synthesizer: targets in pages of 8 KB, 64 pixels by 32 of 32 or 24 bits or by 64 of 16, depth
//             likewise, with widths in multiples of 64; textures in blocks of 256 bytes, their last block being where
//             the order of blocks in a page puts it. A8 and L8 are PSMT8, and each of the two has a palette for all
//             its textures: 256 entries of PSMCT32
//   tiles     GameCube: targets that are drawn to are rectangles of the one embedded frame buffer, side by side where
//             they fit; it holds 3 bytes of colour for each pixel, row by row, and then 3 bytes of depth for each. All
//             else is textures in main memory, in tiles of 32 bytes
// Sources: the topic "memory" of the profile's evidence.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/profile/profile.h"

namespace pipeline {

// budget 0: no limit. used: to the end of the last block; of a frame buffer, its rows down to the last one in use, colour
// and depth. over: what is used beyond the budget.
struct MemoryRegion {
    std::string_view name;
    std::uint64_t budget = 0, used = 0, over = 0;
};

// what: "target 1 'depth'", "texture 0 'rock'", "palette of A8". region: an index into MemoryMap::regions. pitch: pixels
// from one row of the largest level to the next. bytes: with padding and all levels that the chip samples.
struct MemoryBlock {
    std::string what;
    std::size_t region    = 0;
    std::uint64_t address = 0, bytes = 0, pitch = 0;
};

// Two targets that would have to be at one place of a frame buffer while both are needed, from pass `pass` on: both are
// drawn to with one depth target, or hold depth for one colour target.
struct MemoryClash {
    TargetId one, other;
    std::size_t pass = 0;
};

// blocks: those of targets, of textures, of palettes, each in the frame's order.
struct MemoryMap {
    std::vector<MemoryRegion> regions;
    std::vector<MemoryBlock> blocks;
    std::vector<MemoryClash> clashes;
};

MemoryMap lay_out(const Frame& frame, const Profile& profile);

}  // namespace pipeline
