// SPDX-License-Identifier: MIT
// Copies. Whole pixels: a transfer within the memory. Alpha to colour: the source read as PSMT8H, whose texels are the
// alphas of 32 bit pixels, by a palette of greys. Green to alpha: both as PSMCT16, where the halves of a 32 bit pixel, red
// with green and blue with alpha, are pixels 8 apart, so that columns of 8 are drawn 8 to the right with the bits of blue
// masked. The last two are drawn, point by point, and move bits as they are.
// Sources: PCSX2 GSTables.cpp for the places of pixels; the forms are known from games (PCSX2 GSHwHack.cpp).
#pragma once

#include <vector>

#include "pipeline/emit/gs_draw_state.h"

namespace pipeline {

// Throws std::invalid_argument for a copy between channels of formats that have not 32 bits.
void emit_copy(const Frame& frame, const GsMemory& memory, const Pass& pass, const CopyRectangle& copy, GsBuilder& out);

// Green to alpha: columns of the 16 bit views, all within one page of each. x, y: in the page, source's and destination's.
struct GsShuffle {
    std::uint32_t from_page = 0, to_page = 0;  // counted from the surface's first
    std::int32_t from_x = 0, from_y = 0, to_x = 0, to_y = 0, width = 0, height = 0;
    bool operator==(const GsShuffle&) const = default;
};
std::vector<GsShuffle> shuffle_columns(const CopyRectangle& copy, std::uint32_t from_width64, std::uint32_t to_width64);

}  // namespace pipeline
