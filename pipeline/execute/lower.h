// SPDX-License-Identifier: MIT
// From the frame's state to the rasterizer's, as a compiler selects instructions.
#pragma once

#include <optional>

#include "pipeline/execute/frame_memory.h"
#include "pipeline/frame/frame.h"
#include "raster/color_format.h"
#include "raster/fill_state.h"
#include "raster/primitives.h"

namespace pipeline {

// `color`: the format of the colour target, if there is one.
raster::FillState lower(const Arithmetic& arithmetic, const PipelineState& state, std::optional<TargetFormat> color,
                        const TextureBindings& textures, const FrameMemory& memory);

raster::ColorFormat color_format(TargetFormat format);
int depth_bits(TargetFormat format);
raster::PixelGrid pixel_grid(const Arithmetic& arithmetic);

// Does a written pixel depend on the pixel that was there?
bool reads_destination(const Arithmetic& arithmetic, const PipelineState& state);

}  // namespace pipeline
