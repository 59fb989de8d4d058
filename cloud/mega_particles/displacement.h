// SPDX-License-Identifier: MIT
// The article's second way to give the rim detail: pixels of the finished cloud are looked up a little aside. Hardware
// of the time had environment bump mapping for that, or had not; a grid whose vertices carry the displaced coordinates
// does the same in any pipeline, with detail down to a few of its cells.
#pragma once

#include <span>

#include "cloud/mega_particles/cloud_draw.h"

namespace cloud {

// A grid over the cloud's part of the picture, blended over the back buffer in one layer: the colour at each pixel's own
// texel, the alpha displaced (both, if the cloud is premultiplied). The displacement is noise at the point of the cloud
// that a vertex looks at, so it stays with the cloud when the camera moves; its greatest is Cloud::displacement sigmas.
void append_displaced_composite(const CloudDraw& draw);

// The point of the particles that a ray meets first; for a ray that passes by, its point nearest to one of them. The two
// meet at the outline. direction: of length 1.
Vec3 point_looked_at(std::span<const Particle> particles, Vec3 eye, Vec3 direction);

}  // namespace cloud
