// SPDX-License-Identifier: MIT
// Light that textures throw on what is there, dest * (1 + light) by DESTCOLOR, ONE, for a chip with one stage whose blends know
// no colour as factor (Graphics Synthesizer): the program evaluates the stages at the vertices, and a pass for each of red, green
// and blue, masked, draws it as the vertices' alpha and as a grey, which gs_blend takes for Cd * As + Cd. Triangles that a channel
// leaves dark are not drawn in it.
// The picture is the same but for what lies between vertices: light is interpolated from them, so that its edges are as fine as
// the mesh. Textures are read at level 0, by their filter; all else is rounded once.
// Comes after window_triangles. Source: the profile's evidence, "stages" and "blend".
#pragma once

#include "pipeline/legalize/legalize.h"

namespace pipeline {

// A pass is left as it is unless it draws window triangles alone, blends by DESTCOLOR, ONE, has alpha masked, adds no specular,
// and its stages make colour of plain arguments by SELECTARG1, SELECTARG2, MODULATE or MODULATE2X, of textures that repeat or
// clamp and are no targets.
Frame rewrite_light_at_vertices(Frame frame, const Profile& profile, RewriteNotes& notes);

}  // namespace pipeline
