// SPDX-License-Identifier: MIT
// Which pixels of a target hold something that a frame still needs, pass by pass.
#pragma once

#include <vector>

#include "pipeline/check/pixel_region.h"
#include "pipeline/frame/frame.h"

namespace pipeline {

// What viewport and scissor leave of the pass's targets, maybe nothing.
PixelRect limit_of(const Frame& frame, const Pass& pass);

// The pixels whose sample points lie in it, in no target's bounds.
PixelRect covered_pixels(const Arithmetic& arithmetic, const DrawRectangle& rectangle);

// Pixels of its target.
PixelRect written_by(const CopyRectangle& copy);

// Pixels of the pass's colour target that it may change.
PixelRegion drawn_to(const Frame& frame, const Pass& pass);

// Those that hold after it what was not there before, in all channels and without fail: those
// of a clear, of rectangles that nothing tests, masks or blends, and of copies.
PixelRegion overwritten(const Frame& frame, const Pass& pass);

// For each pass which pixels of the target are needed while it goes on, and then those of the picture, at
// frame.passes.size(). A pixel is needed from a pass that overwrites it, or the first that uses it, to the last that uses it
// before the next that overwrites it; what is read as a texture is used whole. What nothing uses of the picture is needed
// from the start.
std::vector<PixelRegion> needed_pixels(const Frame& frame, TargetId id);

// For each pass those that it is the first to use, but does not overwrite: as a target starts, they are zeros.
std::vector<PixelRegion> pixels_used_as_zeros(const Frame& frame, TargetId id);

}  // namespace pipeline
