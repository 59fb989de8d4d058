// SPDX-License-Identifier: MIT
// Where the chip's local memory holds a frame: targets, textures and palettes as pipeline/check/memory_map.h lays them out,
// and behind them what only the chip needs; and the transfers that fill it.
#pragma once

#include <optional>

#include "pipeline/emit/gs_builder.h"
#include "pipeline/frame/frame.h"

namespace pipeline {

// Pixel storage formats, as FRAME, ZBUF, TEX0 and BITBLTBUF name them.
enum class GsPsm : std::uint8_t {
    Ct32 = 0x00,
    Ct24 = 0x01,
    Ct16 = 0x02,
    T8   = 0x13,
    T8h  = 0x1b,
    Z32  = 0x30,
    Z24  = 0x31,
    Z16  = 0x32,
};
GsPsm psm_of(TargetFormat format);  // of a format that the chip has
GsPsm psm_of(TextureFormat format);
constexpr std::uint64_t code(GsPsm psm) {
    return static_cast<std::uint64_t>(psm);
}

inline constexpr std::uint32_t kGsPageBlocks = 32;

// block: address / 256. width64: pixels from one row to the next, / 64.
struct GsSurface {
    std::uint32_t block = 0, width64 = 1;
    GsPsm psm          = GsPsm::Ct32;
    std::int32_t width = 0, height = 0;

    std::uint32_t page() const { return block / kGsPageBlocks; }
    bool has_16_bits() const { return psm == GsPsm::Ct16 || psm == GsPsm::Z16; }
};

// grey: entry i is (i, i, i), L8's palette if there is one. white: a texel of 255 in all channels. Palettes are blocks.
struct GsMemory {
    std::vector<GsSurface> targets, textures;
    std::optional<std::uint32_t> a8_palette, l8_palette, grey_palette;
    std::optional<GsSurface> white;
};

// Throws std::invalid_argument if what only the chip needs does not fit behind the rest.
GsMemory place_in_gs_memory(const Frame& frame);

// One group: all textures and palettes.
void emit_uploads(const Frame& frame, const GsMemory& memory, GsBuilder& out);

// "target 1 'depth'"
std::string quoted_name(std::string_view kind, std::size_t index, std::string_view name);

}  // namespace pipeline
