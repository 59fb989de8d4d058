// SPDX-License-Identifier: MIT
// Targets in the chip's formats. What stands for a colour format is ChipFormats's: opaque for what has no alpha, with_alpha
// for what has. The Graphics Synthesizer's PSMCT16 stands for A1R5G5B5, whose colours it keeps, unless its alpha is read:
// PSMCT16's bit is set from 0x80 on, which is one. Where with_alpha does not keep whole bytes (GameCube), a target whose
// alpha nothing reads becomes opaque; the picture's own alpha is not shown.
// A target that keeps whole bytes now is not dithered any more. Depth gets the least format that has its bits and stands beside the colours that it is used with, or else the deepest.
// The picture is the same but for the bits that formats keep. PSMCT24 gives back 0x80 for alpha, which is one only after
// gs_alpha. PSMCT* themselves are left alone: a frame that has them counts alpha as the Graphics Synthesizer does.
// Source: the profile's evidence, "targets", "store" and "depth".
#pragma once

#include "pipeline/legalize/legalize.h"

namespace pipeline {

// A target stays as it is where the chip has no format for all its uses, or no depth that stands beside all its colours.
Frame rewrite_formats(Frame frame, const Profile& profile, RewriteNotes& notes);

}  // namespace pipeline
