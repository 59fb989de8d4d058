// SPDX-License-Identifier: MIT
// From the frame's state to the rasterizer's, as a compiler selects instructions.
#pragma once

#include "pipeline/execute/frame_memory.h"
#include "pipeline/frame/frame.h"
#include "raster/fill_state.h"

namespace pipeline {

raster::FillState lower(const PipelineState& state, const TextureBindings& textures, const FrameMemory& memory);

int depth_bits(TargetFormat format);

// Does a written pixel depend on the pixel that was there?
bool reads_destination(const BlendState& blend);

}  // namespace pipeline
