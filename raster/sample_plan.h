// SPDX-License-Identifier: MIT
// A sampler as the fill loop wants it: where its levels lie.
#pragma once

#include <array>
#include <cstdint>

#include "raster/sampling_rules.h"

namespace raster {

inline constexpr int kMaxLevels = 14;  // 8192 texels

struct SamplePlan {
    struct Level {
        const std::uint32_t* texels = nullptr;
        std::int32_t stride         = 0;  // texels
        std::int32_t width          = 0;
        std::int32_t last_column = 0, last_row = 0;
    };
    std::array<Level, kMaxLevels> levels;
    int level_count = 0;
    int lod_max     = 0;  // 1/256 level
};
SamplePlan plan_sampler(const Sampler& sampler, bool alpha_quads = false);

}  // namespace raster
