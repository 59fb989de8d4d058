// SPDX-License-Identifier: MIT
// Blend factors become register ALPHA's operands, ((A - B) * C >> 7) + D: the four of them are chosen so that the coefficients
// of Cs and Cd are the factors, as (Cs - Cd) * As + Cd for SRCALPHA, INVSRCALPHA. The chip has no product of two colours and
// only one D: SRCCOLOR and DESTCOLOR, and ONE with INVSRCALPHA, have no such form; but what vertices alone say may have one:
//   DESTCOLOR, ONE        by white Cd * FIX + Cd, and by a grey that is the vertex's alpha too Cd * As + Cd
//   INVDESTCOLOR, ZERO    by white (Cs - Cd) * FIX
// It writes alpha as it is, where Direct3D blends it too; so a target's alpha must be masked, or be read by nothing before it is
// written anew, or be what the blend would give.
// The picture is the same but for rounding: by 2 of 255 at most, and to the bit where C is FIX.
// Comes right after gs_alpha, which makes 0x80 one. Source: the profile's evidence, "blend".
#pragma once

#include <optional>

#include "pipeline/legalize/legalize.h"

namespace pipeline {

// Red, green and blue of a blend of any colours, alpha being counted to 0x80; nothing if register ALPHA cannot say it.
std::optional<GsBlend> gs_blend_of(const BlendState& blend);

// Can the pass's blend be register ALPHA's, alpha included? FLIPPER_2X2 cannot be with it.
bool has_gs_blend(const Frame& frame, std::size_t pass);

// Sets Arithmetic::blend. A frame of which one pass has no such form stays as it is, as does one whose alpha is not counted
// to 0x80 (Arithmetic::combine).
Frame rewrite_gs_blend(Frame frame, const Profile& profile, RewriteNotes& notes);

}  // namespace pipeline
