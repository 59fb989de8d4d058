// SPDX-License-Identifier: MIT
// The chip has no colour mask. A blend whose factors are colours leaves a channel as it is if the fragment has the right
// value there: a factor SRCCOLOR is (R, G, B, A), so that white with ZERO, SRCCOLOR multiplies alpha alone, and black with
// ONE, ONE adds to alpha alone. By NEAREST255, of whole bytes, what they leave keeps its bytes, and the others are those
// that the mask gives; frames and chips with other rules are left alone. Source: DirectX 7 SDK help, D3DBLEND.
//   nothing written        ZERO, ONE
//   alpha alone            red, green and blue become white or black by TFACTOR, without fog and specular colour:
//     ZERO, SRCx             ZERO, SRCCOLOR, white; DESTx, ZERO is the same
//     ZERO, INVSRCx          ZERO, INVSRCCOLOR, black
//     ONE, ONE               ONE, ONE, black
//     ONE, INVSRCx           ONE, INVSRCCOLOR, black
//     ONE, ZERO              if all that is drawn has alpha 0, ZERO, SRCCOLOR, white; if it has 255, ONE, ONE, black
//   red, green and blue    alpha becomes 0 or 255 in the last stage, if neither factors of colour nor a test read it:
//     x, ONE; x, INVSRCCOLOR alpha 0
//     ZERO, SRCCOLOR; DESTCOLOR or DESTALPHA, ZERO   alpha 255
// (x: COLOR or ALPHA.) Other masks stay, for check to find: among them red, green and blue replaced or blended by
// alpha, and single ones of them.
#pragma once

#include "pipeline/legalize/legalize.h"

namespace pipeline {

Frame mask_by_blending(Frame frame, const Profile& profile, RewriteNotes& notes);

}  // namespace pipeline
