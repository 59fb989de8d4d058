// SPDX-License-Identifier: MIT
// What the GameCube's chip does with the registers of tests/support/gx_log.h, in real numbers: vertices placed, lit and fogged, the
// TEV by its formula, texels untiled. What a program may not rely on is checked on the way, with Catch.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "pipeline/frame/frame.h"
#include "tests/support/gx_log.h"
#include "tests/support/stage_colors.h"

namespace test_support {

// A fragment's colour by the TEV. ras: of the colour channels 0 and 1; texels: of the maps.
RealColor run_tev(const GxRegisters& r, const std::array<RealColor, 2>& ras, const std::array<RealColor, 2>& texels);

// Which coordinate the TEV reads a map with; -1 if it does not.
int coordinate_of(const GxRegisters& r, int map);

// Clip coordinates as the chip has them.
std::array<double, 4> clip(const GxRegisters& r, const GxVertexRead& vertex);
double window_depth(const GxRegisters& r, const GxVertexRead& vertex);
// x0, y0, x1, y1 of a quad.
std::array<double, 4> window_rect(const GxEvent& event);

// s, t, q
std::array<double, 3> generated(const GxRegisters& r, int coordinate, const GxVertexRead& vertex);

// What the chip's lights give, by the formula of hwtests' lighting.cpp: red, green, blue, alpha.
std::array<int, 4> lit(const GxRegisters& r, const GxVertexRead& vertex);

// The share that the chip's own fog leaves.
double chip_fog(const GxRegisters& r, double depth);

// How many texels of all levels differ from what lies at this place of the data, untiled.
std::size_t differing_texels(const pipeline::Texture& texture, const std::vector<std::uint8_t>& data,
                             std::size_t start);

}  // namespace test_support
