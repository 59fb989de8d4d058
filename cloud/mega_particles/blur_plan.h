// SPDX-License-Identifier: MIT
// How wide a blur on a pyramid is: `levels` times down by boxes of 2x2 and up again by bilinear steps of 2, with tents
// (1, 2, 1 per axis) between. Variances add up; in pixels of the full target
//   boxes and steps   (4^levels - 1) / 3          a tent at level k   4^k / 2
// With inner tents there is one before each step down but the first and one after each step up but the last: the kernel
// is then nearly the same at every pixel, and does not crawl under motion. bottom_tents stand at the coarsest level.
#pragma once

#include "cloud/cloud.h"

namespace cloud {

inline constexpr int kMaxBlurLevels = 5;

struct BlurPlan {
    int levels                             = 1;  // 1..kMaxBlurLevels
    bool inner_tents                       = false;
    int bottom_tents                       = 0;
    bool operator==(const BlurPlan&) const = default;
};

// Standard deviation in pixels.
float sigma_px(const BlurPlan& plan);

// The plan of the mode whose sigma comes nearest. Skirt: up to 4 levels with tents, in steps of about a fifth from 1.7
// to 20.6 px. Article: boxes and steps alone, 1 to 18.5 px.
BlurPlan plan_blur(Mode mode, float wanted_sigma_px);

}  // namespace cloud
