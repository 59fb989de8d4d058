// SPDX-License-Identifier: MIT
// The scene's depth at a fraction of the picture's scale. Fixed function cannot resample depth: the scene is drawn once
// more, without colour. The centre of a pixel of the small target is the point of the picture it stands for.
#pragma once

#include "cloud/bounds.h"
#include "cloud/mega_particles/mega_particles.h"

namespace cloud {

// depth: of width x height pixels, each 2^level of the picture's wide and high. They may reach beyond the picture's
// right and lower edge. camera sees through it as the scene's own does through the picture.
struct ScaledDepth {
    pipeline::TargetId depth;
    pipeline::CameraId camera;
};

// Appends one pass for each that has cleared or written the scene's depth so far, "<label>, depth at 1/2". area: where it is needed, in
// pixels of the picture. Throws std::invalid_argument where that depth hangs on the alpha of a colour target.
ScaledDepth append_scaled_depth(pipeline::Frame& frame, const SceneTargets& scene, int level, int width, int height,
                                const PixelRect& area);

}  // namespace cloud
