// SPDX-License-Identifier: MIT
// TFACTOR for a chip whose stages cannot read a constant (Graphics Synthesizer): it goes into the vertices' colours, where the
// stages do not read those anyway, red, green and blue apart from alpha; the argument becomes DIFFUSE. A draw that others share
// vertices with gets its own. And DECAL with a product for alpha, which register TEX0 has not (SELECTARG1 beside MODULATE),
// becomes MODULATE by white vertices; so this comes before gs_alpha, after which white is 0x80.
// The picture is the same to the bit. Source: the profile's evidence, "stages".
#pragma once

#include "pipeline/legalize/legalize.h"

namespace pipeline {

// A pass is left as it is if it is lit, or for the channels in which it reads both TFACTOR and its vertices.
Frame rewrite_vertex_constants(Frame frame, const Profile& profile, RewriteNotes& notes);

}  // namespace pipeline
