// SPDX-License-Identifier: MIT
// Rectangles as sprites. The chip samples pixels at integers and fills a page of 64 pixels' width at a time, so that a
// rectangle becomes columns that end where pages do. A textured one is also cut to sizes that are powers of two: the chip
// steps a texel coordinate without error over these, and lets it fall up to 1/16 texel low over others (measured on a
// console, PCSX2 #14029 and #14078).
// Coordinates of texels: UV where both ends of every strip are whole sixteenths, else ST with Q = 1; and where rounding of
// those would give another texel, or another sixteenth of one between two, shorter strips, down to one pixel.
#pragma once

#include <vector>

#include "pipeline/emit/gs_draw_state.h"

namespace pipeline {

// Along one axis: pixels first..end, and the coordinates of texels at first and at end, as written: UV's integers, or the
// bits of S or T.
struct GsStrip {
    std::int32_t first = 0, end = 0;
    std::uint32_t from = 0, to = 0;
    bool operator==(const GsStrip&) const = default;
};

// One axis of a rectangle: where it lies, in 1/16 pixel, and its coordinates times the texture's size.
struct GsAxis {
    std::int64_t x0 = 0, x1 = 0;
    double texel0 = 0.0, texel1 = 0.0;
    bool across = true;  // u
};

// 1/16 texel at a pixel by the frame's rule (raster/sampling_rules.h), of which the chip keeps no more.
std::int32_t sixteenths_at(const GsAxis& axis, std::int32_t pixel);

// By UV: empty if some end is not a whole sixteenth within 0..1023.9375, or a pixel would read elsewhere.
std::vector<GsStrip> strips_by_uv(const GsAxis& axis, std::int32_t first, std::int32_t end);
// By S or T, of a texture of 2^log2_size texels as TEX0 says.
std::vector<GsStrip> strips_by_st(const GsAxis& axis, std::int32_t first, std::int32_t end, std::uint32_t log2_size);

// Corners of pixels, not textured; set_targets has been called.
void emit_sprites(const PixelRect& pixels, std::uint32_t depth, Argb color, GsBuilder& out);

// The corner (x, y), in pixels, with the kick.
void emit_corner(std::int32_t x, std::int32_t y, std::uint32_t depth, GsBuilder& out);

void emit_rectangle(const Frame& frame, const GsMemory& memory, const Pass& pass, const DrawRectangle& draw,
                    GsBuilder& out);

// A depth of 0..1 in a format's units.
std::uint32_t depth_units(float depth, TargetFormat format);
// In those of the pass's depth target; 0 without one.
std::uint32_t depth_units(const Frame& frame, const Pass& pass, float depth);

// A coordinate of a window, in 1/16 pixel, towards 0.
std::int64_t window_sixteenths(float pixels);

}  // namespace pipeline
