// SPDX-License-Identifier: MIT
// Fills the particles' target with the scene's colour and alpha 0: there is no cloud yet, and where the blur mixes a
// particle's edge with what is around it, that is the scene and not black.
#pragma once

#include "cloud/mega_particles/cloud_draw.h"

namespace cloud {

void append_scene_copy(const CloudDraw& draw);

}  // namespace cloud
