// SPDX-License-Identifier: MIT
// The chip samples pixels elsewhere, or cuts coordinates that the frame rounds. Everything drawn moves by as much as the
// sample points do, so that the picture stays in its place: by half a pixel to the left and up, to take Direct3D 7's
// and the Graphics Synthesizer's centres at integers ("Directly Mapping Texels to Pixels", DirectX 7 SDK help). What is
// cut moves by 1/32 pixel more to the right and down, as floor(16 x + 1/2) rounds.
//   rectangles  snapped as in the frame, then moved: the same pixels from the same texels, to the bit
//   triangles   by the projection, in the same direction. But for the projection's rounding a corner snaps to the same
//               place, save that cutting is toward zero: left of or above the first pixel's centre, by 1/16 pixel more
#pragma once

#include "pipeline/legalize/legalize.h"

namespace pipeline {

Frame move_to_pixel_centers(Frame frame, const Profile& profile, RewriteNotes& notes);

}  // namespace pipeline
