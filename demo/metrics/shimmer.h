// SPDX-License-Identifier: MIT
// M5: does the soft rim flicker while the picture moves by whole pixels? A pipeline that treats all pixels alike gives
// the same picture, moved.
#pragma once

#include <vector>

#include "demo/metrics/plane.h"

namespace demo {

// What differs at marked pixels between a plane and another whose content has moved right and down by (x, y) pixels.
// Pixels that moved out of the picture are left out.
std::vector<double> differences_unmoved(const Plane& plane, const Plane& moved, int x, int y, const Mask& where);

}  // namespace demo
