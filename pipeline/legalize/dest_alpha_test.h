// SPDX-License-Identifier: MIT
// The chip has no test of destination alpha. Where that alpha is known to be 0 or 255, and one layer is blended over by its
// own alpha, with alpha masked, it is a factor instead:
//   ZERO, SRCALPHA, alpha alone    alpha there becomes the layer's, or stays 0
//   DESTALPHA, INVDESTALPHA        the layer is blended by it; alpha is lost
//   and what wrote alpha before    writes it again
// The bytes are the same by NEAREST255: a * 255 / 255 is a. Alpha is known if all that drew to the target since a
// rectangle over the whole area wrote alpha alone, 0 or 255, by depth tests that would end today as they did then; one layer is one
// rectangle. Other tests stay, for check to find. The first pass needs a mask, which masked_alpha replaces: it comes after.
// Source: DirectX 7 SDK help, D3DBLEND.
#pragma once

#include "pipeline/legalize/legalize.h"

namespace pipeline {

Frame test_by_blending(Frame frame, const Profile& profile, RewriteNotes& notes);

}  // namespace pipeline
