// SPDX-License-Identifier: MIT
// Blurs the particles' target, colour and alpha, by bilinear blits alone (blur_plan.h).
#pragma once

#include "cloud/mega_particles/cloud_draw.h"

namespace cloud {

void append_blur(const CloudDraw& draw);

}  // namespace cloud
