// SPDX-License-Identifier: MIT
// What a frame costs on a chip: amounts and milliseconds per pass and in all, from counts and the table of rates alone.
// A time is an amount by a rate; the least takes the rate's high end and the least amount, the most the other ends.
//
// Unit          amount                                                    rate (ChipRates)
// Fill          the slowest of three that work in step:                   clock and
//                 pixel slots: fragments and cleared pixels                 pixels, textured_pixels, fogged_pixels
//                 samples: one a fragment and texture, two if linear mips   samples
//                 texture stages of the fragments                           stages
// PageBreaks    changes of page, in clocks: pipeline/cost/page_breaks.h   clock and page_breaks
// FrameMemory   bytes of targets read and written, of PassCounts          frame_bandwidth
// TextureMemory texels that the samples before did not read               texture_bandwidth
// MainMemory    Shared: all bytes; Embedded: texels fetched, and copies   memory_bandwidth
// Copy          pixels that copies read                                   copies
// Setup         triangles drawn, rectangles                               setup
// Vertices      from distinct ones (all reused) to 3 a triangle           vertices
// VertexUpload  ps2: 16 bytes a register in a PACKED packet; RGBAQ, ST    upload
//               and XYZ2 of the 1 (strips) to 3 vertices of a triangle,
//               RGBAQ and two of UV and XYZ2 of a rectangle; without
//               texture no ST and UV
// Upload        textures not used before in the frame: none if they stay  upload
//               in the chip (least), or all (most)
//
// A pass takes, least:  the longest of Fill + PageBreaks and each other unit, which work side by side
//               most:   the same, and Upload added to it, as no source says that the chip draws meanwhile
// A frame takes the sum of its passes: no source says how far one begins before the other ends.
// On the Graphics Synthesizer setup beside filling is measured (clearbench: 140 sprites take the time of 3), and that
// textures and targets have ports of their own is published; on the others it is how such pipelines are built, and
// PC and Xbox memory is one, whose bytes add up.
//
// Pixel slots   least: fragments, as if every footprint were full; most: the footprints that are touched. Of a
//               rectangle exactly; of triangles of mean area a, each half of a square of side s = sqrt(2 a), the
//               (s - 1) / height + 1 rows of footprints have (s / 2 - 1) / width + 1 of them.
// Page breaks   least: the frame's or the texture's, whichever takes longer; most: both, and each triangle enters a
//               page (least: none does, as neighbours follow each other). A clear is page-sized rectangles (least) or
//               one (most).
// Texels        pipeline/cost/pass_work.h. least: no texture more than once a pass; most also, if all of a pass's
//               textures fit ChipRates::texture_cache.
//
// Not in these numbers: what `unknown` lists; what the processor, its program and the display take of the memory;
// changes of state; vertices read from memory; compressed or skipped depth; how far a memory stays below its peak.
#pragma once

#include <array>
#include <vector>

#include "pipeline/cost/range.h"
#include "pipeline/cost/rates.h"
#include "pipeline/execute/pass_counts.h"
#include "pipeline/frame/frame.h"

namespace pipeline {

enum class CostUnit : std::uint8_t {
    Fill,
    PageBreaks,
    FrameMemory,
    TextureMemory,
    MainMemory,
    Copy,
    Setup,
    Vertices,
    VertexUpload,
    Upload,
};
template <>
struct EnumNames<CostUnit> {
    static constexpr std::array<std::string_view, 10> names{
        "fill", "page breaks", "frame memory", "texture memory", "main memory",
        "copy", "setup",       "vertices",     "vertex upload",  "upload"};
};
inline constexpr std::size_t kCostUnits = EnumNames<CostUnit>::names.size();

struct PassCost {
    double pixels = 0.0;  // fragments, and pixels cleared and copied
    double texels = 0.0;  // PassCounts::texels
    double bytes  = 0.0;  // PassCounts::bytes: what a chip without caches would move
    Range page_breaks;
    Range uploaded_bytes;  // of textures
    std::array<Range, kCostUnits> unit_ms;
    Range ms;

    const Range& of(CostUnit unit) const { return unit_ms[static_cast<std::size_t>(unit)]; }
    PassCost& operator+=(const PassCost& more);
    bool operator==(const PassCost&) const = default;
};

// Against kFrameBudgetMs: at most, at least, or neither.
enum class Verdict : std::uint8_t { Fits, Depends, TooLong };
template <>
struct EnumNames<Verdict> {
    static constexpr std::array<std::string_view, 3> names{"fits", "depends", "too long"};
};
inline constexpr double kFrameBudgetMs = 1000.0 / 60.0;
Verdict verdict_of(const Range& ms);

struct FrameCost {
    std::vector<PassCost> passes;
    PassCost total;  // the sum of the passes
    Verdict verdict = Verdict::Fits;
    std::vector<Evidence> unknown;  // of rates that this frame needs and no source gives: they took no time
};

// frame: a valid one, and what execute() counted in each of its passes, or counts of the same meaning. Throws
// std::invalid_argument if there are more or fewer counts than passes.
FrameCost cost(const Frame& frame, const std::vector<PassCounts>& counts, const ChipRates& rates);

// The unit that takes the longest (most) of those that work side by side; PageBreaks count as Fill.
CostUnit slowest_unit(const PassCost& cost);

}  // namespace pipeline
