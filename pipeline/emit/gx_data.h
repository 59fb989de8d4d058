// SPDX-License-Identifier: MIT
// The side file of a GX program: textures in the chip's tiles, vertices, indices; numbers are big-endian, as the console's
// processor reads them, and every block begins at a multiple of 32 bytes.
//   I8      tiles of 8x4 texels, 32 bytes, rows of them from the top
//   RGBA8   tiles of 4x4, 64 bytes: alpha and red of all 16 texels in turn, and then green and blue
// Mip levels follow each other, each in whole tiles; what lies beyond a level's edge repeats its last column and row.
// Sources: Dolphin, VideoCommon/TextureDecoder; libogc, gx.c, GX_GetTexBufferSize.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/frame/frame.h"

namespace pipeline {

struct GxBlock {
    std::string what;
    std::uint32_t offset = 0, bytes = 0;
};

class GxData {
  public:
    // Gives the block's offset: that of an equal one if there is one already.
    std::uint32_t add(std::string what, const std::vector<std::uint8_t>& bytes);
    const std::vector<GxBlock>& blocks() const { return blocks_; }
    std::vector<std::uint8_t> take() { return std::move(bytes_); }
    std::size_t size() const { return bytes_.size(); }

  private:
    std::vector<std::uint8_t> bytes_;
    std::vector<GxBlock> blocks_;
    std::multimap<std::uint64_t, std::size_t> by_hash_;
};

// All levels, A8 and L8 as I8, A8R8G8B8 as RGBA8.
std::vector<std::uint8_t> gx_texels(const Texture& texture);

void put_u16(std::vector<std::uint8_t>& out, std::uint32_t value);
void put_float(std::vector<std::uint8_t>& out, float value);
void put_rgba(std::vector<std::uint8_t>& out, Argb color);

// Indices of 16 bits reach 65534 vertices from where the arrays begin (0xffff is left alone: the chip skips such a vertex),
// and GX_Begin takes as many at once: a draw is a list of parts. first: the vertex that its indices count from.
struct GxPart {
    std::uint32_t first = 0, vertices = 0;
    std::vector<std::uint16_t> indices;
};

// Vertices 0 up are the frame's; those beyond repeat the corners of triangles whose own are too far apart.
class GxVertices {
  public:
    explicit GxVertices(const Frame& frame) : frame_(frame) {}

    // The same list for the same indices. Valid until the next call.
    const std::vector<GxPart>& parts(std::uint32_t first_index, std::uint32_t index_count);

    std::uint32_t size() const;
    const Vertex& vertex(std::uint32_t index) const;

  private:
    std::vector<GxPart> split(std::span<const std::uint32_t> indices);
    std::array<std::uint32_t, 3> near_corners(std::span<const std::uint32_t> corners);

    const Frame& frame_;
    std::vector<std::uint32_t> repeated_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<GxPart>> parts_;
};

}  // namespace pipeline
