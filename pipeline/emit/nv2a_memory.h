// SPDX-License-Identifier: MIT
// What the NV2A's memory holds for a frame: targets and textures at the addresses of pipeline/check/memory_map.h, and after
// them what is added. Bytes that must be there beforehand go to the side file one block after the other.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/emit/nv2a_stream.h"
#include "pipeline/frame/frame.h"

namespace pipeline {

// pitch: bytes from row to row. what: as in "texture 0 'rock'".
struct Nv2aPlace {
    std::uint32_t address = 0, pitch = 0;
    std::string what;
};

class Nv2aMemory {
  public:
    // Refers to the frame, which must be legal on "xbox".
    explicit Nv2aMemory(const Frame& frame);

    const Nv2aPlace& of(TargetId id) const { return targets_[static_cast<std::size_t>(id.index)]; }
    const Nv2aPlace& of(TextureId id) const { return textures_[static_cast<std::size_t>(id.index)]; }

    // Where the bytes are. Throws std::invalid_argument if the chip's memory ends before them.
    std::uint32_t add(const std::vector<std::uint8_t>& bytes, std::string_view what);

    // Bytes from address 0 on that are in use.
    std::uint64_t used() const { return end_; }
    // The lines `surface` and `data` of emit_nv2a.h.
    std::string take_table() { return table_.take(); }
    std::vector<std::uint8_t> take_data() { return std::move(data_); }

  private:
    void place(std::uint32_t address, const std::vector<std::uint8_t>& bytes, std::string_view what);

    std::vector<Nv2aPlace> targets_, textures_;
    std::uint64_t end_ = 0;
    Nv2aStream table_;
    std::vector<std::uint8_t> data_;
};

// Are the texels in Z order? Textures of other sizes, which have one level, and targets are in rows.
bool is_swizzled(const Texture& texture);

// As the chip reads them: each level's texels in Z order, the lowest bit of the place from x, the next from y and so on
// while both have bits (xemu, pgraph/swizzle.c); or rows of `pitch` bytes.
std::vector<std::uint8_t> nv2a_texels(const Texture& texture, std::uint32_t pitch);

void append_word(std::vector<std::uint8_t>& bytes, std::uint32_t value);
void append_float(std::vector<std::uint8_t>& bytes, float value);

}  // namespace pipeline
