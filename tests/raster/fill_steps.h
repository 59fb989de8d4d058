// SPDX-License-Identifier: MIT
// The steps of the fill loop one at a time, on 256 pixels from memory, compiled for every instruction set: for tests
// over all values of a byte. Each step comes for any state, and for those that a program of raster/special_programs.h
// has.
#pragma once

#include <array>
#include <cstdint>

#include "raster/fill_counts.h"
#include "raster/fill_plan.h"
#include "raster/fill_program.h"
#include "raster/sample_plan.h"
#include "raster/tile.h"

namespace fill_steps {

inline constexpr int kBlocks = 16, kLanes = kBlocks * raster::kBlockWidth;
static_assert(kLanes == 256, "all values of a byte");

template <class Lane>
struct alignas(64) Lanes : std::array<Lane, kLanes> {};
using Colors = Lanes<std::uint32_t>;

enum class Kind { General, Special };

// Steps 2 to 4 of raster/fill_state.h: from what is interpolated and sampled to a colour.
struct ColorInputs {
    Colors diffuse{}, specular{};
    std::array<Colors, raster::kMaxTextures> texels{};
};
using MakeColors = void (*)(const raster::FillPlan& plan, const ColorInputs& inputs, Colors& out);

// Steps 5 to 9: fragments into targets. Lane i is pixel (i, y); it is a fragment if `live` has a bit for it. depth: in
// units of the target's format.
struct Fragments {
    Colors color{};
    Lanes<std::uint32_t> depth{};
    std::array<std::uint16_t, kBlocks> live{};
    int y = 0;

    bool is_live(int lane) const { return (live[lane / raster::kBlockWidth] >> lane % raster::kBlockWidth & 1) != 0; }
    void set_live(int lane, bool is) {
        const auto bit       = static_cast<std::uint16_t>(1 << lane % raster::kBlockWidth);
        std::uint16_t& block = live[lane / raster::kBlockWidth];
        block                = static_cast<std::uint16_t>(is ? block | bit : block & ~bit);
    }
};
struct Targets {
    Colors color{};
    Lanes<std::uint32_t> depth{};
};
using Shade = void (*)(const raster::FillPlan& plan, const Fragments& fragments, Targets& targets,
                       raster::FillCounts& counts);

// Step 1, of triangles: at points, u, v in 1/256 texel of level 0, lod in 1/256 level.
struct SamplePoints {
    Lanes<std::int32_t> u{}, v{}, lod{};
};
using Sample = void (*)(const raster::TextureProgram& program, const raster::SamplePlan& plan,
                        const SamplePoints& points, int blocks, Colors& out);

// Step 1, of rectangles: at blocks of lanes, u = (start + lane * step) >> 8 of each, modulo 2^24.
struct SampleRows {
    std::array<std::int32_t, kBlocks> start{}, step{}, v{};
};
using SampleRowsStep = void (*)(const raster::TextureProgram& program, const raster::SamplePlan& plan,
                                const SampleRows& rows, int blocks, Colors& out);

// From 30 bits to units of a format.
using DepthUnits = void (*)(int depth_bits, const Lanes<std::uint32_t>& depth, Lanes<std::uint32_t>& out);

// This processor's. Special: compiled for all that the step takes from the program, null if there is no such.
MakeColors make_colors_step(const raster::FillProgram& program, Kind kind);
Shade shade_step(const raster::FillProgram& program, Kind kind);
Sample sample_step(const raster::TextureProgram& program, Kind kind);
SampleRowsStep sample_rows_step(const raster::TextureProgram& program, Kind kind);
DepthUnits depth_units_step();

}  // namespace fill_steps
