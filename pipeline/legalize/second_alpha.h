// SPDX-License-Identifier: MIT
// A second stage that makes nothing but alpha, for a chip with one stage and no arithmetic on alpha (Graphics Synthesizer). The
// alpha is made first and left in the target, by which the first stage's colour is then blended (DESTALPHA, INVDESTALPHA).
//   MODULATE of a texture and TFACTOR        one pass that writes alpha alone
//   ADDSIGNED2X of a texture below one half  sums are made in red, green and blue of a target of their own: alpha is copied
//     and what stage 0 has                   there; 1 - x (INVDESTCOLOR, ZERO by white), so that adding takes away; one
//                                            half - texel is added by the pass's own triangles; 1 - x once more; twice
//                                            (DESTCOLOR, ONE by white); and copied back to the alpha of the pass's target
// 2 (a + f - 1/2) is 2 (1 - ((1 - a) + (1/2 - f))), cut at zero alike. Where the pass replaces what is there, alpha is kept only
// where it draws.
// The picture is the same but for rounding: by 1 of 255 before gs_alpha, and what that and gs_blend do.
// Triangles of a pass that lie over each other are blended by the last of their alphas.
// Comes right after window_triangles. Source: the profile's evidence, "stages" and "copy" (CopyChannels).
#pragma once

#include "pipeline/legalize/legalize.h"

namespace pipeline {

// A pass is left as it is unless it draws window triangles alone; tests nothing, has no fog and adds no specular; replaces, or
// blends by SRCALPHA, INVSRCALPHA onto a target whose alpha nothing reads later; its first stage reads one target of whole bytes and takes its texel,
// a product with TFACTOR, or of alpha the texel less TFACTOR; and its second is one of those above, of A8 textures.
Frame rewrite_second_alpha(Frame frame, const Profile& profile, RewriteNotes& notes);

}  // namespace pipeline
