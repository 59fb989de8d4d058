// SPDX-License-Identifier: MIT
// One draw's state, resolved before the loop: what the loop branches on, its numbers, the kernel that draws it, and
// what a primitive must be set up with.
#pragma once

#include <array>
#include <cstdint>

#include "raster/blend_plan.h"
#include "raster/fill_counts.h"
#include "raster/fill_program.h"
#include "raster/fill_state.h"
#include "raster/image.h"
#include "raster/sample_plan.h"
#include "raster/settled_pixels.h"
#include "raster/triangle_setup.h"

namespace raster {

// One of them may be null. depth: in units of its format.
struct FillTarget {
    Image* color = nullptr;
    Image* depth = nullptr;
};

struct FillPlan;

// What kernels know of a tile beyond its pixels.
struct TileWork {
    FillCounts* counts     = nullptr;  // to add to; null: nobody asks, so that what is hidden may be left out
    SettledPixels* settled = nullptr;  // of a triangle whose program is_last_word(): these it leaves alone and adds to
};

// Both fill what lies within the tile.
struct FillKernel {
    using Triangle        = void (*)(const FillPlan& plan, const SetUpTriangle& triangle, const Rect& tile,
                              const FillTarget& target, const TileWork& work);
    using Rectangle       = void (*)(const FillPlan& plan, const SetUpRectangle& rectangle, const Rect& tile,
                               const FillTarget& target, const TileWork& work);
    Triangle triangle     = nullptr;
    Rectangle rectangle   = nullptr;
    bool special_triangle = false, special_rectangle = false;  // compiled for this very program
};

struct FillPlan {
    FillProgram program;
    std::array<SamplePlan, kMaxTextures> samplers;
    BlendPlan blend;
    std::uint32_t constant = 0, fog_color = 0;
    std::uint8_t alpha_reference      = 0;
    std::uint32_t bits_if_failed      = 0;  // of the colour target that may change in spite of the alpha test
    std::uint64_t texels_per_fragment = 0, texel_bytes_per_fragment = 0;
    SetupNeeds needs;
    FillKernel kernel;
};

// The one place where the instruction set is chosen, anew for each draw. general: not a special kernel, for tests.
FillPlan plan_fill(const FillState& state, bool has_color, const ColorFormat& format, int depth_bits,
                   bool general = false);

}  // namespace raster
