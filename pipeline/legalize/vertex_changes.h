// SPDX-License-Identifier: MIT
// Changes of vertices for some draws and not for others that share the vertices.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "pipeline/frame/frame.h"

namespace pipeline {

// One change, of vertices of either kind. Without a function nothing changes.
struct VertexChange {
    std::function<void(Vertex&)> vertex;
    std::function<void(WindowVertex&)> window_vertex;
};

// kind: an index into the changes.
struct ChangedDraw {
    Draw* draw       = nullptr;
    std::size_t kind = 0;
};

// `draws` must be all of the frame's that draw triangles of either kind; others are left alone. A vertex that draws of several
// kinds use keeps its place for the first of them; for each other one it is copied, and draws that need the copy get a range of
// indices of their own.
void change_vertices(Frame& frame, std::span<const ChangedDraw> draws, std::span<const VertexChange> kinds);

// Puts a draw's vertices and indices once more at the end of the frame's, with a change of each vertex. Returns the first index.
std::uint32_t append_changed(Frame& frame, const DrawWindowTriangles& draw,
                             const std::function<void(WindowVertex&)>& change);

// One change for what both kinds of vertices have.
VertexChange change_of_diffuse(std::function<Argb(Argb)> change);

}  // namespace pipeline
