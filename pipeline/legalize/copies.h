// SPDX-License-Identifier: MIT
// Copies that the chip has not, as those that convert or halve, become rectangles that show the source as a texture: whole, so
// that its coordinates are exact, with the viewport as the part that is copied; a pass for each.
//   as they are   nearest texel: the same bytes, to the bit, in any formats
//   halved        linear, each pixel on the corner that four texels share. A copy shifts their sum, S >> 2; the filters
//                 round it by their rule: REFERENCE8 to (S + 2) >> 2, at most 1 more; GS_FLOOR4 to S >> 2 as well
// The frame's arithmetic says where pixels are sampled: it may be the chip's already, or not yet. Source: "copy" and
// "filter" of the profile's evidence; DirectX 7 SDK help, "Directly Mapping Texels to Pixels", for the place.
#pragma once

#include "pipeline/legalize/legalize.h"

namespace pipeline {

Frame draw_copies(Frame frame, const Profile& profile, RewriteNotes& notes);

}  // namespace pipeline
