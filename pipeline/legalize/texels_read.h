// SPDX-License-Identifier: MIT
// Which texels of a target a draw reads, as far as it shows without drawing.
#pragma once

#include "pipeline/frame/frame.h"

namespace pipeline {

// Those of the target bound to `stage`, for pixels `at` of the pass, or more: of a rectangle what it shows there; of triangles
// whose coordinates are the window's own the same place; of others what their vertices' coordinates span, or all.
PixelRect texels_read(const Frame& frame, const Pass& pass, const Draw& draw, std::size_t stage, const PixelRect& at);

}  // namespace pipeline
