// SPDX-License-Identifier: MIT
// A second stage that multiplies becomes passes of its own, for a chip with one stage: the pass with its first stage, then the
// second's texture over it by a blend, dest * source (ZERO, SRCCOLOR), or twice that (DESTCOLOR, SRCCOLOR). On the Graphics
// Synthesizer, whose only factor is an alpha, a texture's red, green and blue become the alpha of three textures, drawn with
// dest * alpha (ZERO, SRCALPHA) and a mask each, or of one if it is grey; for twice, white is drawn with (DESTCOLOR, ONE) then.
// Fog comes last of all: the first pass fades to black and a last one adds the fog's share of its colour. Twice a product is cut
// at one before it fades, so that there white that fades to black is multiplied in; the Graphics Synthesizer cannot, as
// its fog leaves alpha alone. But its window triangles know their fog: a last pass draws its colour with that as alpha.
// The later passes draw where the first left its depth, so that this is for passes that test and write depth. But what lies at
// one place at the very same depth, to the last bit, is multiplied and fogged as often as it is drawn.
// The picture is the same to the bit, but with fog by 3 of 255 at most. On the Graphics Synthesizer, with gs_alpha and gs_blend,
// by 4, 6 with fog, and 8 for twice.
// Source: the profile's evidence, "stages" and "blend"; the three masked passes follow from register FRAME's FBMSK.
#pragma once

#include "pipeline/legalize/legalize.h"

namespace pipeline {

// A pass is left as it is unless it replaces colours (no blend) of whole bytes, compares depth with LESS, LESSEQUAL, GREATER or
// GREATEREQUAL and writes it, tests no alpha, adds no specular, and its second stage is MODULATE or MODULATE2X of CURRENT and
// TEXTURE that keeps CURRENT's alpha; on the Graphics Synthesizer also if that TEXTURE is a target, or if there is fog on
// twice a product of triangles that are not in window space. The textures whose channels are taken stay in the frame.
Frame rewrite_stages(Frame frame, const Profile& profile, RewriteNotes& notes);

}  // namespace pipeline
