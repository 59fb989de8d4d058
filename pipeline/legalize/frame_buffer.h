// SPDX-License-Identifier: MIT
// A chip with one frame buffer (GameCube) draws there alone, and reads as textures only what was copied out of it. Each target
// that is drawn to gets a copy beside it, a texture in main memory:
//   what is read, and was drawn since it was last copied, is copied before; the pass reads the copy
//   where another target is drawn at the same pixels, those of the first that the picture still depends on are copied before,
//     and shown from the copy, 1:1, before the first is drawn to or copied again
//   a rectangle that is exactly the halving of a target becomes a copy that halves, straight into the other's copy
// Copies read tiles whole. So what begins a target anew, as a clear or a rectangle over all of its limits, does so in whole
// tiles where nobody can see it: what copies read is always the target's own. Depth is never moved.
// The picture is the same to the bit, as copies keep the frame buffer's bits and give them back, but for what is halved: a copy
// has four 6-bit values S as S + (S >> 6), a whole byte, of which a target would keep 6 bits.
// Source: the profile's evidence, "targets", "copy" and "limits"; that a frame is saved and brought back around what is drawn with
// its depth follows from the buffer being one.
#pragma once

#include "pipeline/legalize/legalize.h"

namespace pipeline {

// A frame is left as it is if its targets have room beside each other and none is read as a texture, or if one does not fit
// into the buffer at all. It has its formats (formats) and copies (copies) by now.
Frame share_frame_buffer(Frame frame, const Profile& profile, RewriteNotes& notes);

}  // namespace pipeline
