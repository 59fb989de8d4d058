// SPDX-License-Identifier: MIT
// Kernels: the texture stages, and what follows them before the tests (specular, fog), on batch.color.
#pragma once

#include <cstdint>

#include "raster/fill_state.h"
#include "raster/fragment_batch.h"

namespace raster {

struct CombineKernels {
    // batch.color = stage(batch.diffuse, color, texel[index], constant, specular); Current of stage 0 is diffuse.
    void (*stage)(const CombineStage& stage, CombineRule rule, int index, std::uint32_t constant, FragmentBatch& batch);
    void (*add_specular)(FragmentBatch& batch);
    void (*fog)(FogRule rule, std::uint32_t fog_color, FragmentBatch& batch);
};
CombineKernels combine_kernels();  // for this processor

}  // namespace raster
