// SPDX-License-Identifier: MIT
// Alpha, and colours that are multiplied by a texture, counted to 0x80 for one, as the Graphics Synthesizer does: byte v becomes
// round(v * 128 / 255). So change the alpha of vertices, rectangles, materials, textures and clears and the alpha test's
// references; and red, green and blue of vertices and rectangles where MODULATE multiplies them, Ct * Cf >> 7. MODULATE2X becomes
// MODULATE with colours as they are, of which 0x80 was one half and is one now. Likewise MODULATE2X of alpha, and MODULATE4X
// with texels' alpha as it is too; what then lies above one would be more than a blend's whole, so that a second pass
// replaces there, by the alpha test. Green that a copy takes for alpha is counted to 0x80 right before, and alpha that becomes
// colour to 255 right after. The chip has no white for a stage with
// nothing bound: it gets a texture of one texel. L8 whose alpha is read becomes A8R8G8B8, its alpha being 255 otherwise.
// The picture is the same but for rounding: a product of texture and vertex differs by 2 of 255 at most, alpha by MODULATE2X or MODULATE4X by 4, and alpha has 129 levels.
// Lit colours of passes that multiply them are cut at 2, not at one.
// Comes after all that brings a pass to one stage and to formats PSMCT*, and right before gs_blend: alpha is counted to
// 0x80 in between, and blended to 255. Source: the profile's evidence, "combine".
#pragma once

#include "pipeline/legalize/legalize.h"

namespace pipeline {

// round(v * 128 / 255)
constexpr std::uint8_t to_gs_scale(std::uint8_t byte) {
    return static_cast<std::uint8_t>((byte * 128 + 127) / 255);
}

// Sets Arithmetic::combine, on which the scale depends. Only a whole frame can be counted anew: it stays as it is if one pass has
// more than a stage, what no TFX and TCC say of vertex colour and texel, a blend that gs_blend has no form for, a test of the
// target's alpha where that is not known to be 0 or 255 (dest_alpha_test.h; bit 7 of 0x80 is set for 255 alone), alpha
// above one in a pass that does not just blend by it, green that is needed after it became alpha, or a target of another format
// than PSMCT*.
Frame rewrite_gs_alpha(Frame frame, const Profile& profile, RewriteNotes& notes);

}  // namespace pipeline
