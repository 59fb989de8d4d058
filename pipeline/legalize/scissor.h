// SPDX-License-Identifier: MIT
// The chip has no scissor. Its viewport limits what is drawn and cleared as well (Direct3D 7: Wine 9.0,
// dlls/ddraw/tests/ddraw7.c, test_clear; a viewport lies within the target), so that it becomes what scissor and viewport
// have in common. Rectangles and clears need no more. The projection of triangles is scaled by the one viewport to the
// other and shifted, so that every corner stays where it was in the window but for the rounding of two floats: one that
// lies that near a tie may snap to the next 1/16 pixel, and a pass that meets by LESSEQUAL or EQUAL the depth that the same
// triangles left in a pass without a scissor may then miss a few. A pass that has nothing in common draws nothing.
#pragma once

#include "pipeline/legalize/legalize.h"

namespace pipeline {

Frame limit_by_viewport(Frame frame, const Profile& profile, RewriteNotes& notes);

}  // namespace pipeline
