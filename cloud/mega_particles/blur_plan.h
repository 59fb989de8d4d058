// SPDX-License-Identifier: MIT
// How wide a blur on a pyramid is: down by boxes of 2x2 to `levels` and up again by bilinear steps of 2, with tents
// (1, 2, 1 per axis) between. Variances add up; in pixels of the full target
//   boxes and steps   (4^levels - 1) / 3          a tent at level k   4^k / 2
// With inner tents there is one before each step down but the first and one after each step up but the last: the kernel
// is then nearly the same at every pixel, and does not crawl under motion. bottom_tents stand at the coarsest level.
//
// A blur may begin and end at another level than 0, that of a smaller target: then there are no boxes above it, and it
// ends with one enlargement of n = 4^first_level: n / 6 + 1 / 12 texels of variance, as a mean over the pixels of a texel.
#pragma once

#include <array>

#include "cloud/cloud.h"

namespace cloud {

inline constexpr int kMaxBlurLevels = 5;

// extra_tents: at each level but the coarsest, before the step down from it.
struct BlurPlan {
    int levels       = 1;  // 1..kMaxBlurLevels
    bool inner_tents = false;
    int bottom_tents = 0;
    int first_level  = 0;  // 0..levels
    std::array<int, kMaxBlurLevels> extra_tents{};
    bool operator==(const BlurPlan&) const = default;
};

// Standard deviation in pixels of the full target.
float sigma_px(const BlurPlan& plan);

// The plan of the mode whose sigma comes nearest. Skirt: up to 4 levels with tents, in steps of about a fifth from 1.7
// to 20.6 px. Article: boxes and steps alone, 1 to 18.5 px.
BlurPlan plan_blur(Mode mode, float wanted_sigma_px);

// The plan for a target of 1/target_scale, 1, 2 or 4. Tents keep its variance, to half of what one at the finest level
// gives: 4^first_level / 4. Article mode has no tents: it keeps its levels, and the width is what it becomes.
BlurPlan at_target_scale(Mode mode, const BlurPlan& plan, int target_scale);

}  // namespace cloud
