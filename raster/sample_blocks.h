// SPDX-License-Identifier: MIT
// Kernels: points to texels, by the rules of raster/sampling_rules.h.
#pragma once

#include <array>
#include <cstdint>

#include "raster/fragment_batch.h"
#include "raster/sampling_rules.h"

namespace raster {

inline constexpr int kMaxLevels = 14;  // 8192 texels

// A sampler as the kernel wants it.
struct SamplePlan {
    struct Level {
        const std::uint32_t* texels = nullptr;
        std::int32_t stride         = 0;  // texels
        std::int32_t width = 0, height = 0;
    };
    std::array<Level, kMaxLevels> levels;
    int level_count   = 0;
    bool linear       = false;
    FilterRule rule   = FilterRule::Single8;
    MipFilter mip     = MipFilter::None;
    Address address_u = Address::Wrap;
    Address address_v = Address::Wrap;

    int lod_max() const { return mip == MipFilter::None ? 0 : 256 * (level_count - 1); }
    int texels_per_fragment() const {
        return level_count == 0 ? 0 : (linear ? 4 : 1) * (mip == MipFilter::Linear ? 2 : 1);
    }
};
SamplePlan plan_sampler(const Sampler& sampler);

// The first `count` blocks of points.
using SampleKernel = void (*)(const SamplePlan& plan, const SamplePoints& points, int count,
                              BlockRows<std::uint32_t>& out);

// This processor's kernels: for anything, and for rectangles, where v is the same along a block and u advances evenly.
SampleKernel sample_kernel(const SamplePlan& plan);
SampleKernel sample_rectangle_kernel(const SamplePlan& plan);

// Lists the live lanes of a batch, one at least, or all of them.
using PackKernel = void (*)(const FragmentBatch& batch, bool all, PackedPoints& out);
PackKernel pack_kernel();

}  // namespace raster
