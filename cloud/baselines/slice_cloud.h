// SPDX-License-Identifier: MIT
// The sliced volume of 1999, to measure mega-particles against: a stack of textured slices across the axis that is
// nearest to the line of sight, blended over the scene from back to front (SRCALPHA, INVSRCALPHA), with z test and no z
// write. A chip needs no volume texture for it, but memory for three stacks (slice_volume.h): 3 MiB for 64 slices.
//
// What makes the comparison fair: the volume is that of the very particles that mega-particles draw, with the cloud's
// own fractal on its rim and the same baked light in every texel; the blend is what marching a ray through it gives.
// What the technique cannot do stays: detail ends at a texel; the picture changes at once where the line of sight turns
// past 45 degrees and another stack is drawn; seen at an angle, a ray meets no more slices than straight on, up to 1.7
// times too few; things that stand in the cloud cut each slice off sharply; each pixel is blended many times over.
#pragma once

#include <span>

#include "cloud/baselines/slice_volume.h"
#include "cloud/mega_particles/mega_particles.h"

namespace cloud {

// Appends one pass for each cloud in view, "<cloud>: slices across z, back to front", farthest cloud first, with a draw
// and a texture for each slice that is not clear all over. The cloud's opacity is that of each slice. Clear texels are
// kept from the blend: slices are cut to their rest, and alpha 0 fails the alpha test.
void append_slice_clouds(pipeline::Frame& frame, const SceneTargets& scene, const View& view,
                         std::span<const SliceVolume> clouds);

// The same, making the volumes first; an animation of the camera makes them once instead.
void append_slice_clouds(pipeline::Frame& frame, const SceneTargets& scene, const View& view,
                         std::span<const BakedCloud> clouds, const SliceOptions& options = {});

}  // namespace cloud
