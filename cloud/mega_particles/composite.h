// SPDX-License-Identifier: MIT
// Rectangles that blend over the back buffer.
#pragma once

#include "cloud/mega_particles/cloud_draw.h"

namespace cloud {

// A finished cloud of the back buffer's size, texel on pixel: source * alpha + dest * (1 - alpha), or source + dest *
// (1 - alpha) if it is premultiplied. Its alpha is multiplied by the cloud's constant opacity.
void append_composite(const CloudDraw& draw, pipeline::TargetId finished);

// With the eye inside a particle there is nothing to see but the cloud: the whole picture takes the colour of what is
// around the eye, and begins to within ten standard deviations of the blur from the surface, but not beyond 0.6 of the
// largest radius, so that coming in and going out are gradual. Appends nothing from farther away.
void append_whiteout(const CloudDraw& draw);

// Its alpha: 0 from farther away.
float whiteout(const Cloud& cloud, const View& view);

}  // namespace cloud
