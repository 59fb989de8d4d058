// SPDX-License-Identifier: MIT
// Triangles for a chip that takes them in window space alone (Graphics Synthesizer): the program transforms, lights, clips and
// culls, and gives each vertex its texture coordinates and its fog. So draws name window vertices, and the state that made
// them goes: lights, culling, flat shading, texture coordinates from elsewhere, the formula of the fog; cameras, vertices and
// indices too, which nothing uses any more. The viewport, which is left as a limit, becomes part of the scissor.
// The picture is the same to the bit, but for triangles that reach beyond the guard band of the chip's coordinates: what is
// cut there is rounded elsewhere.
// Comes first: what follows finds colours and coordinates at the vertices. Source: the profile's evidence, "states".
#pragma once

#include "pipeline/legalize/legalize.h"

namespace pipeline {

// A frame that has a pass with triangles of both kinds stays as it is.
Frame rewrite_window_triangles(Frame frame, const Profile& profile, RewriteNotes& notes);

}  // namespace pipeline
