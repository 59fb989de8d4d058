// SPDX-License-Identifier: MIT
// Moves what cameras draw within the window, by their projections: transform, lighting, fog and texture coordinates, which
// are made before, stay as they are.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/check/needed_pixels.h"
#include "pipeline/frame/frame.h"

namespace pipeline {

// In clip space: x becomes scale_x * x + shift_x * w, y likewise.
struct WindowMap {
    double scale_x = 1.0, shift_x = 0.0, scale_y = 1.0, shift_y = 0.0;
    bool operator==(const WindowMap&) const = default;
};

// maps: for each pass how its triangles move; none leaves them. A camera whose passes move in more than one way gets
// copies, "scene 2" and so on. Matrices are computed in double and rounded once.
void move_triangles(Frame& frame, const std::vector<std::optional<WindowMap>>& maps);

// The pass's viewport, with pixels for "the whole target". The pass is valid.
PixelRect viewport_of(const Frame& frame, const Pass& pass);

// Does a pass draw one rectangle, without a depth test, that holds all of the area?
bool covers(const Frame& frame, const Pass& pass, const PixelRect& area);

// "pass 3 'composite'"
std::string place_of(const Frame& frame, std::size_t pass);

}  // namespace pipeline
