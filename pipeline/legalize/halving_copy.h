// SPDX-License-Identifier: MIT
// Passes that are nothing but a halving: a rectangle over its limits, each of whose pixels shows, filtered linearly, the corner
// that four pixels of the other target share.
#pragma once

#include <optional>

#include "pipeline/frame/frame.h"

namespace pipeline {

// The copy that does the same for pixels `to` of the pass's target, which may be more than its limits; nothing if the pass does
// anything else, or if `to` is not half of a part of the source.
std::optional<CopyRectangle> halving_copy(const Frame& frame, const Pass& pass, const PixelRect& to);

}  // namespace pipeline
