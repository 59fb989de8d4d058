// SPDX-License-Identifier: MIT
// Changes of vertices' colours for some draws and not for others that share the vertices.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "pipeline/frame/frame.h"

namespace pipeline {

using Recolor = std::function<void(Vertex&)>;

// kind: an index into the changes.
struct DrawColors {
    DrawTriangles* draw = nullptr;
    std::size_t kind    = 0;
};

// `draws` must be all of the frame's. A vertex that draws of several kinds use keeps its place for the first of them; for
// each other one it is copied, and draws that need the copy get a range of indices of their own.
void recolor_vertices(Frame& frame, std::span<const DrawColors> draws, std::span<const Recolor> kinds);

}  // namespace pipeline
