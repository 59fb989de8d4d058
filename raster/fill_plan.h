// SPDX-License-Identifier: MIT
// One draw's state, resolved before the loop: which kernels run, what they read, what a triangle must be set up with.
#pragma once

#include <array>

#include "raster/blend_blocks.h"
#include "raster/combine_blocks.h"
#include "raster/cover_blocks.h"
#include "raster/fill_state.h"
#include "raster/interpolate_blocks.h"
#include "raster/sample_blocks.h"
#include "raster/test_blocks.h"
#include "raster/triangle_setup.h"

namespace raster {

struct FillPlan {
    FillState state;
    SetupNeeds needs;
    int depth_bits                    = 24;
    bool uses_depth                   = false;  // tests or writes it
    bool uses_color                   = false;  // writes it, or tests its alpha
    bool tests_first                  = false;  // no alpha test, so depth can be tested before the colour is made
    bool writes_color                 = false;
    bool fails_on                     = false;  // a fragment that fails the alpha test goes on, with less to write
    std::uint64_t texels_per_fragment = 0, texel_bytes_per_fragment = 0;

    CoverKernels cover;
    InterpolateKernels interpolate;
    std::array<SamplePlan, kMaxTextures> samplers;
    std::array<SampleKernel, kMaxTextures> sample{}, sample_rectangle{};
    PackKernel pack = nullptr;
    CombineKernels combine;
    TestKernels test;
    BlendPlan blend_plan;
    BlendKernel blend = nullptr;
};

// The one place where the instruction set is chosen, anew for each draw.
FillPlan plan_fill(const FillState& state, bool has_color, const ColorFormat& format, int depth_bits);

}  // namespace raster
