// SPDX-License-Identifier: MIT
// From what a scene file says to what frames are made of: grows the clouds, makes terrain, solids and textures, and
// computes all light that does not depend on the view. The expensive part, once for a scene, on all cores: the canyon
// takes about 0.4 s of processor time.
#pragma once

#include "demo/scene_data.h"

namespace demo {

// Bakes on all cores; a cloud that makes no sense is a SceneError. before: as in cloud/bake.h.
cloud::BakedCloud bake_cloud(const SceneDescription& scene, const cloud::Cloud& cloud,
                             const cloud::BakedCloud* before = nullptr);

// Throws SceneError for a file that cannot be read.
Scene build_scene(SceneDescription description);

}  // namespace demo
