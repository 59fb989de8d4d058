// SPDX-License-Identifier: MIT
// One rectangle, texel on pixel, that blends a finished cloud over the back buffer: source * alpha + dest * (1 -
// alpha).
#pragma once

#include "cloud/mega_particles/cloud_draw.h"

namespace cloud {

// finished: of the back buffer's size. Its alpha is multiplied by the cloud's constant opacity.
void append_composite(const CloudDraw& draw, pipeline::TargetId finished);

}  // namespace cloud
