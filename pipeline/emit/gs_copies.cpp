// SPDX-License-Identifier: MIT
#include "pipeline/emit/gs_copies.h"

#include <algorithm>
#include <stdexcept>

#include "pipeline/emit/gs_sprites.h"
#include "pipeline/validate/check_pass.h"

namespace pipeline {

namespace {

constexpr std::int32_t kPageWidth = 64, kPageHeight = 32;  // of 32 bits
constexpr std::uint64_t kSprite = 6;
constexpr GsFunction kDecal{.tfx = 1, .tcc = 1};

std::uint64_t unsigned_of(std::int32_t value) {
    return static_cast<std::uint64_t>(value);
}

void move_pixels(const GsSurface& from, const GsSurface& to, const CopyRectangle& copy, GsBuilder& out) {
    out.set(GsReg::BitBltBuf, {{"SBP", from.block},
                               {"SBW", from.width64},
                               {"SPSM", code(from.psm)},
                               {"DBP", to.block},
                               {"DBW", to.width64},
                               {"DPSM", code(to.psm)}});
    out.set(GsReg::TrxPos, {{"SSAX", unsigned_of(copy.from.x0)},
                            {"SSAY", unsigned_of(copy.from.y0)},
                            {"DSAX", unsigned_of(copy.x)},
                            {"DSAY", unsigned_of(copy.y)},
                            {"DIR", 0}});
    out.set(GsReg::TrxReg,
            {{"RRW", unsigned_of(copy.from.x1 - copy.from.x0)}, {"RRH", unsigned_of(copy.from.y1 - copy.from.y0)}});
    out.write(GsReg::TrxDir, {{"XDIR", 2}});
}

// Point by point, the texel (u, v) to the pixel (x, y) and what follows.
void emit_blit(std::int32_t u, std::int32_t v, const PixelRect& to, GsBuilder& out) {
    const auto middle = [](std::int32_t texel) { return unsigned_of(16 * texel + 8); };
    out.write(GsReg::Uv, {{"U", middle(u)}, {"V", middle(v)}});
    emit_corner(to.x0, to.y0, 0, out);
    out.write(GsReg::Uv, {{"U", middle(u + to.x1 - to.x0)}, {"V", middle(v + to.y1 - to.y0)}});
    emit_corner(to.x1, to.y1, 0, out);
}

// One column of pages of the source after the other; TBP0 points at the column's first page, so that u and v stay small.
void alpha_to_color(const GsMemory& memory, const GsSurface& from, const GsSurface& to, const CopyRectangle& copy,
                    GsBuilder& out) {
    constexpr std::int32_t kRows = 512;
    set_plain_state(out);
    const PixelRect all{copy.x, copy.y, copy.x + copy.from.x1 - copy.from.x0, copy.y + copy.from.y1 - copy.from.y0};
    set_targets({.color = to, .keep_bits = 0xff000000u, .depth = {}}, all, out);
    for (std::int32_t top = copy.from.y0 / kRows * kRows; top < copy.from.y1; top += kRows) {
        for (std::int32_t left = copy.from.x0 / kPageWidth * kPageWidth; left < copy.from.x1; left += kPageWidth) {
            GsSurface column = from;
            column.psm       = GsPsm::T8h;
            column.block += kGsPageBlocks * (static_cast<std::uint32_t>(top / kPageHeight) * from.width64 +
                                             static_cast<std::uint32_t>(left / kPageWidth));
            column.width          = kPageWidth;
            column.height         = kRows;
            const std::int32_t x0 = std::max(left, copy.from.x0), x1 = std::min(left + kPageWidth, copy.from.x1);
            const std::int32_t y0 = std::max(top, copy.from.y0), y1 = std::min(top + kRows, copy.from.y1);
            const std::int32_t dx = copy.x - copy.from.x0, dy = copy.y - copy.from.y0;
            set_texture({column, memory.grey_palette}, kDecal, false, false, false, out);
            out.write(GsReg::Prim, {{"PRIM", kSprite}, {"TME", 1}, {"FST", 1}});
            out.write(GsReg::Rgbaq, {{"R", 0x80}, {"G", 0x80}, {"B", 0x80}, {"A", 0x80}, {"Q", 0x3f800000}});
            emit_blit(x0 - left, y0 - top, {x0 + dx, y0 + dy, x1 + dx, y1 + dy}, out);
        }
    }
}

// Where a 32 bit pixel's low half lies in the 16 bit view: blocks of 8x8 pixels, 8 across and 4 down a page, become blocks
// of 16x8, 4 across and 8 down, with rows and columns of them exchanged.
struct HalfPlace {
    std::uint32_t page = 0;
    std::int32_t x = 0, y = 0;
};
HalfPlace half_place(std::int32_t x, std::int32_t y, std::uint32_t width64) {
    const std::int32_t in_x = x % kPageWidth, in_y = y % kPageHeight;
    return {static_cast<std::uint32_t>(y / kPageHeight) * width64 + static_cast<std::uint32_t>(x / kPageWidth),
            in_y / 8 * 16 + in_x % 8, in_x / 8 * 8 + in_y % 8};
}

// From `at` to the next multiple of 8 of either coordinate, or `end`.
std::int32_t piece_end(std::int32_t at, std::int32_t offset, std::int32_t end) {
    return std::min({end, (at / 8 + 1) * 8, ((at + offset) / 8 + 1) * 8 - offset});
}

// Does `next` go on below the column in both pages?
bool continues(const GsShuffle& column, const GsShuffle& next) {
    return column.from_page == next.from_page && column.to_page == next.to_page && column.from_x == next.from_x &&
           column.to_x == next.to_x && column.width == next.width && column.from_y + column.height == next.from_y &&
           column.to_y + column.height == next.to_y;
}

void green_to_alpha(const GsSurface& from, const GsSurface& to, const CopyRectangle& copy, GsBuilder& out) {
    constexpr std::uint32_t kBlueAndLow = 0x00003fff;  // of a 16 bit pixel in high places: 8 bits of blue stay
    set_plain_state(out);
    for (const GsShuffle& column : shuffle_columns(copy, from.width64, to.width64)) {
        const GsSurface source{.block   = from.block + kGsPageBlocks * column.from_page,
                               .width64 = 1,
                               .psm     = GsPsm::Ct16,
                               .width   = 64,
                               .height  = 64};
        GsSurface target = source;
        target.block     = to.block + kGsPageBlocks * column.to_page;
        set_targets({.color = target, .keep_bits = kBlueAndLow, .depth = {}}, {0, 0, 64, 64}, out);
        set_texture({source, {}}, kDecal, false, false, false, out);
        out.write(GsReg::Prim, {{"PRIM", kSprite}, {"TME", 1}, {"FST", 1}});
        out.write(GsReg::Rgbaq, {{"R", 0x80}, {"G", 0x80}, {"B", 0x80}, {"A", 0x80}, {"Q", 0x3f800000}});
        emit_blit(column.from_x, column.from_y,
                  {column.to_x + 8, column.to_y, column.to_x + 8 + column.width, column.to_y + column.height}, out);
    }
}

}  // namespace

std::vector<GsShuffle> shuffle_columns(const CopyRectangle& copy, std::uint32_t from_width64,
                                       std::uint32_t to_width64) {
    std::vector<GsShuffle> columns;
    const std::int32_t dx = copy.x - copy.from.x0, dy = copy.y - copy.from.y0;
    for (std::int32_t y = copy.from.y0; y < copy.from.y1;) {
        const std::int32_t y1 = piece_end(y, dy, copy.from.y1);
        for (std::int32_t x = copy.from.x0; x < copy.from.x1;) {
            const std::int32_t x1 = piece_end(x, dx, copy.from.x1);
            const HalfPlace from = half_place(x, y, from_width64), to = half_place(x + dx, y + dy, to_width64);
            const GsShuffle next{from.page, to.page, from.x, from.y, to.x, to.y, x1 - x, y1 - y};
            if (!columns.empty() && continues(columns.back(), next))
                columns.back().height += next.height;
            else
                columns.push_back(next);
            x = x1;
        }
        y = y1;
    }
    return columns;
}

void emit_copy(const Frame& frame, const GsMemory& memory, const Pass& pass, const CopyRectangle& copy,
               GsBuilder& out) {
    const GsSurface& from = memory.targets[static_cast<std::size_t>(copy.source.index)];
    const GsSurface& to   = memory.targets[static_cast<std::size_t>(pass.color.index)];
    if (copy.channels == CopyChannels::All) return move_pixels(from, to, copy, out);
    if (from.psm != GsPsm::Ct32 || to.psm != GsPsm::Ct32)
        throw std::invalid_argument("a copy " + std::string(enum_name(copy.channels)) + " from " +
                                    std::string(enum_name(find_target(frame, copy.source)->format)) + " to " +
                                    std::string(enum_name(find_target(frame, pass.color)->format)) +
                                    " has no form on the Graphics Synthesizer, which needs PSMCT32");
    if (copy.channels == CopyChannels::AlphaToColor) return alpha_to_color(memory, from, to, copy, out);
    green_to_alpha(from, to, copy, out);
}

}  // namespace pipeline
