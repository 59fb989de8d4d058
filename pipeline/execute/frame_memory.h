// SPDX-License-Identifier: MIT
// A frame's targets and textures as the rasterizer sees them. What one frame has allocated serves the next.
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/frame/frame.h"
#include "raster/color_format.h"
#include "raster/image.h"
#include "raster/sampling_rules.h"

namespace pipeline {

using StoreFunction = std::uint32_t(const raster::ColorFormat& format, std::uint32_t argb);

class FrameMemory {
  public:
    // Targets become what they are if zeros are written. The frame must outlive its drawing. Uses the threads of the arena it is called in.
    // `stored`: see raster/color_format.h.
    void prepare(const Frame& frame, StoreFunction* stored);

    raster::Image* image(TargetId id) { return id ? &images_[id.index] : nullptr; }
    const raster::Image& image(TargetId id) const { return images_[id.index]; }

    // The levels of what is bound, with the filters left at their defaults; none if nothing is.
    raster::Sampler sampler(const TextureBinding& binding) const;

  private:
    std::vector<raster::Image> images_;
    std::vector<std::vector<std::uint32_t>>
        texels_;  // 0xAARRGGBB, whatever the texture's format; only of bound textures
    const Frame* frame_ = nullptr;
};

}  // namespace pipeline
