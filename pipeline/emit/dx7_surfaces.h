// SPDX-License-Identifier: MIT
// Which of the frame's targets the Direct3D 7 program makes surfaces of, and of what kind.
#pragma once

#include <string>
#include <vector>

#include "pipeline/frame/frame.h"

namespace pipeline::dx7 {

struct Surface {
    std::string name;
    TargetFormat format = TargetFormat::A8R8G8B8;
    std::int32_t width = 0, height = 0;
    bool is_used    = false;  // or else there is none
    bool is_texture = false;  // read by a stage, so that its size must be one of a texture's
    bool is_zeroed  = false;  // used before all of it is cleared or written
    bool is_spare   = false;  // what a pass without colour target draws to: Direct3D 7 has no such pass
};

// What a pass draws to, as numbers of surfaces; -1 for none.
struct PassSurfaces {
    int color = -1, depth = -1;
};

// The frame's targets, by number, and then the spare ones.
struct Surfaces {
    std::vector<Surface> all;
    std::vector<PassSurfaces> passes;
};

Surfaces surfaces_of(const Frame& frame);

}  // namespace pipeline::dx7
