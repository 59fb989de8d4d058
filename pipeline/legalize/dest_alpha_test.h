// SPDX-License-Identifier: MIT
// The chip has no test of destination alpha. Where that alpha is known to be 0 or 255, and one layer is blended over by its
// own alpha, with alpha masked, it is a factor instead. By blending:
//   ZERO, SRCALPHA, alpha alone    alpha there becomes the layer's, or stays 0
//   DESTALPHA, INVDESTALPHA        the layer is blended by it; alpha is lost
//   and what wrote alpha before    writes it again
// Or by a texture, for a chip whose alpha costs bits of colour (GameCube), if nothing else reads the target's alpha:
//   what wrote alpha               draws to a target of its own, beside the same depth
//   another stage of the layer     multiplies its alpha by that target's
// The bytes are the same: a * 255 / 255 is a by NEAREST255, and so is a * 256 >> 8 by TEV, with a, 0, for 0. Alpha is known if all
// that drew to the target since a rectangle over the whole area wrote alpha alone, 0 or 255, by depth tests that would end
// today as they did then; one layer is one rectangle. Other tests stay, for check to find.
// Blending needs a mask, which masked_alpha replaces, and whole bytes of alpha: it comes before the one and after formats. The
// texture comes before formats, which gives the target one without alpha then.
// Source: DirectX 7 SDK help, D3DBLEND; the profile's evidence, "combine".
#pragma once

#include "pipeline/legalize/legalize.h"

namespace pipeline {

// Is the alpha that a pass tests known so? Its target is that of the pass.
bool is_tested_alpha_known(const Frame& frame, std::size_t pass);

Frame test_by_blending(Frame frame, const Profile& profile, RewriteNotes& notes);
Frame test_by_texture(Frame frame, const Profile& profile, RewriteNotes& notes);

}  // namespace pipeline
