// SPDX-License-Identifier: MIT
// Mip levels for a chip that does not choose them by the texels which a pixel spans (Graphics Synthesizer: by Q, or one for all
// that is drawn): each window triangle gets one level, the nearest to what its texels and pixels ask for on average, and draws
// are split by level, in their order. A level becomes a texture of its own, as TEX1's K with LCM says; with a mip filter the two
// nearest were mixed.
// The picture differs by what lies between two levels. Textures that are magnified keep level 0, bilinear.
// Comes after all that makes passes and textures. Source: the profile's evidence, "lod".
#pragma once

#include "pipeline/legalize/legalize.h"

namespace pipeline {

// A pass is left as it is if it draws triangles that are not in window space, or more than one stage reads textures.
Frame rewrite_mip_levels(Frame frame, const Profile& profile, RewriteNotes& notes);

}  // namespace pipeline
