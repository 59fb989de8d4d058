// SPDX-License-Identifier: MIT
// Depth that grows toward the eye, for a chip that compares with GREATEREQUAL and GREATER alone (Graphics Synthesizer: register
// TEST's ZTST). Of a depth target's passes the projection gives z' = w - z, rectangles and clears 1 - depth, and compare
// functions turn around: LESSEQUAL becomes GREATEREQUAL, LESS becomes GREATER, and the other way. A target that was met before
// it was cleared held zeros, which are nearest; a pass that clears it to 1 now comes first.
// The picture is the same but for rounding: depths of n bits are 2^n - 1 less what they were where 1 - depth and w - z are exact,
// else next to that.
// Source: the profile's evidence, "depth".
#pragma once

#include "pipeline/legalize/legalize.h"

namespace pipeline {

// A depth target is reversed if more of its passes are then had by the chip: EQUAL and NOTEQUAL are left to be found.
// Cameras that passes with another depth target use as well are doubled.
Frame rewrite_reversed_depth(Frame frame, const Profile& profile, RewriteNotes& notes);

}  // namespace pipeline
