// SPDX-License-Identifier: MIT
// Which pixels of a target can change the picture, pass by pass.
#pragma once

#include <vector>

#include "pipeline/check/pixel_region.h"
#include "pipeline/frame/frame.h"

namespace pipeline {

// [target][pass], of colour targets, with the picture at frame.passes.size(): pixels whose value before the pass matters. Others
// may be anything then.
std::vector<std::vector<PixelRegion>> wanted_pixels(const Frame& frame);

}  // namespace pipeline
