// SPDX-License-Identifier: MIT
#include "cloud/mega_particles/blur_plan.h"

#include <algorithm>
#include <cmath>

namespace cloud {

float sigma_px(const BlurPlan& plan) {
    float variance = 0.0f, texel_area = 1.0f;  // texel_area = 4^level
    for (int level = 1; level <= plan.levels; ++level) {
        texel_area *= 4.0f;
        const bool bottom = level == plan.levels;
        const int tents   = bottom ? plan.bottom_tents : plan.inner_tents ? 2 : 0;
        variance += static_cast<float>(tents) * texel_area / 2.0f;
        if (bottom) variance += (texel_area - 1.0f) / 3.0f;
    }
    return std::sqrt(variance);
}

BlurPlan plan_blur(Mode mode, float wanted_sigma_px) {
    const bool article = mode == Mode::Article;
    wanted_sigma_px = std::min(wanted_sigma_px, 100.0f);  // beyond the widest; much larger ones swallow the difference
    BlurPlan best;
    float best_error = 1e30f;
    for (int levels = 1; levels <= (article ? kMaxBlurLevels : kMaxBlurLevels - 1); ++levels)
        for (int tents = article ? 0 : 1; tents <= (article ? 0 : levels == kMaxBlurLevels - 1 ? 2 : 4); ++tents) {
            const BlurPlan plan{.levels = levels, .inner_tents = !article, .bottom_tents = tents};
            const float error = std::abs(sigma_px(plan) - wanted_sigma_px);
            if (error < best_error) best = plan, best_error = error;
        }
    return best;
}

}  // namespace cloud
