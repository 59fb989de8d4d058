// SPDX-License-Identifier: MIT
// The frame computes by the chip's rules: those of Arithmetic but for snap and pixel_center, which move the picture
// (pixel_center.h). Nothing stands in their place, as no chip can compute otherwise, so that the picture differs by the
// rules' rounding. A rule that the frame's states have no meaning under stays. So do the Graphics Synthesizer's combine and
// blend, which come with alpha counted to 0x80 (gs_alpha.h, gs_blend.h). Comes last. Sources: the profile's evidence.
#pragma once

#include "pipeline/legalize/legalize.h"

namespace pipeline {

Frame use_chip_arithmetic(Frame frame, const Profile& profile, RewriteNotes& notes);

}  // namespace pipeline
