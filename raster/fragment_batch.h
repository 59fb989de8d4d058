// SPDX-License-Identifier: MIT
// Fragments on their way through the kernels: up to 16 blocks of 16 pixels of one primitive, as rows of lanes, small enough to
// stay in the L1 cache. Lanes that are not set in `mask` hold anything; a kernel never writes a target there.
#pragma once

#include <cstdint>

#include "raster/primitives.h"
#include "raster/tile.h"

namespace raster {

inline constexpr int kBatchBlocks = 16;
static_assert(kBatchBlocks >= kTileWidth / kBlockWidth, "a batch holds at least one row of a tile");

// One value for each lane of a batch; [block] is its row.
template <class Lane>
struct alignas(64) BlockRows {
    Lane lanes[kBatchBlocks * kBlockWidth];
    Lane* operator[](int block) { return lanes + block * kBlockWidth; }
    const Lane* operator[](int block) const { return lanes + block * kBlockWidth; }
};

// Where textures are read: u, v in 1/256 texel of level 0, lod in 1/256 level.
struct SamplePoints {
    BlockRows<std::int32_t> u, v, lod;
};

struct alignas(64) FragmentBatch {
    BlockRows<std::uint32_t> mask;  // 0: dead. The bits of the colour target that a live lane may change, all at first
    BlockRows<std::uint32_t> passed;  // all ones: passed the alpha test. Only where those that fail may go on
    BlockRows<std::uint32_t> depth;   // in units of the target's format
    BlockRows<std::uint32_t> diffuse, specular, color;
    BlockRows<std::uint32_t> texel[kMaxTextures];
    SamplePoints points;
    struct {
        int x, y;  // pixel of lane 0
    } at[kBatchBlocks];
    int count = 0;  // blocks
};

// The lanes of a batch that read a texture: all of them, or the live ones moved together, since small triangles leave
// most lanes of a block dead, and reading a texture is the dearest step. index says which lane of the batch
// (block * 16 + lane) each is.
struct alignas(64) PackedPoints {
    BlockRows<std::uint32_t> index;
    SamplePoints points;
    BlockRows<std::uint32_t> texel;
    int lanes = 0;  // the last block is padded with repetitions
    int blocks() const { return (lanes + kBlockWidth - 1) / kBlockWidth; }
};

}  // namespace raster
