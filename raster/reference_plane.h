// SPDX-License-Identifier: MIT
// The oracle's reading of primitives.h: snapping, coverage, and a value as a plane over a triangle. Names are those of
// the rules, in lower case; C is `center`.
#pragma once

#include <array>
#include <cstdint>

#include "raster/primitives.h"

namespace raster::reference {

std::int64_t snap(const PixelGrid& grid, float pixels);  // to subpixels

// Snapped corners in subpixels, clockwise on the screen unless d is 0, and where in a pixel it is sampled.
struct Corners {
    std::array<std::int64_t, 3> x{}, y{};
    std::int64_t d = 0;
    int center     = 0;
};

// Snaps a triangle. Where it went counter-clockwise, its vertices 1 and 2 change places too.
Corners snap_clockwise(const PixelGrid& grid, Triangle& triangle);

bool covers(const Corners& corners, int x, int y);  // d is not 0

// A plane in 64-bit integers modulo 2^64, held as the bits of unsigned ones.
struct Plane {
    std::uint64_t v0 = 0, gx = 0, gy = 0;  // F fraction bits
    std::int64_t x0 = 0, y0 = 0;           // where it is v0, in subpixels
    int s      = 0;                        // the rules' S
    int center = 0;

    std::uint64_t at(int x, int y) const;
    std::int64_t step() const { return static_cast<std::int64_t>(16 * gx); }
    std::int64_t step_y() const { return static_cast<std::int64_t>(16 * gy); }
    std::uint32_t value(int x, int y) const;  // modulo 2^32
};

// `v`: the value at each corner; its differences are less than 2^30.
Plane make_plane(const Corners& corners, const std::array<std::int64_t, 3>& v, int f, int s);

// r(p, s) of the rules, modulo 2^32.
std::uint32_t rounded(std::uint64_t p, int s);

// Depth at a vertex or of a rectangle, in kDepthBits bits.
std::int64_t depth_at_vertex(float z);

// Depth in units of a format of `bits` bits.
std::uint32_t depth_in_format(std::uint32_t value, int bits);

}  // namespace raster::reference
