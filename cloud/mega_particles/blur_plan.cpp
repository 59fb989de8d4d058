// SPDX-License-Identifier: MIT
#include "cloud/mega_particles/blur_plan.h"

#include <algorithm>
#include <cmath>

namespace cloud {
namespace {

// In pixels, of a texel of that level.
float texel_area(int level) {
    return static_cast<float>(1 << (2 * level));
}

float tent_variance(int level) {
    return texel_area(level) / 2.0f;
}

// Of a bilinear enlargement by 2^levels, in its pixels.
float enlargement_variance(int levels) {
    return levels == 0 ? 0.0f : (2.0f * texel_area(levels) + 1.0f) / 12.0f;
}

float variance_px(const BlurPlan& plan) {
    const float first = texel_area(plan.first_level), last = texel_area(plan.levels);
    float variance = static_cast<float>(plan.bottom_tents) * tent_variance(plan.levels) + (last - first) / 3.0f +
                     enlargement_variance(plan.first_level);
    for (int level = std::max(plan.first_level, 1); level < plan.levels; ++level) {
        const int tents = plan.extra_tents[static_cast<std::size_t>(level)] + (plan.inner_tents ? 2 : 0);
        variance += static_cast<float>(tents) * tent_variance(level);
    }
    return variance;
}

}  // namespace

float sigma_px(const BlurPlan& plan) {
    return std::sqrt(variance_px(plan));
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

BlurPlan at_target_scale(Mode mode, const BlurPlan& plan, int target_scale) {
    if (target_scale == 1) return plan;
    const int first_level = target_scale == 4 ? 2 : 1;
    BlurPlan other{.levels = std::max(plan.levels, first_level), .first_level = first_level};
    if (mode == Mode::Article) return other;

    const float wanted = variance_px(plan), tolerance = texel_area(first_level) / 4.0f;
    other.inner_tents = true;
    other.inner_tents = variance_px(other) <= wanted + tolerance;
    for (int level = other.levels; level >= first_level; --level) {
        const float tents = std::max((wanted - variance_px(other)) / tent_variance(level), 0.0f);
        (level == other.levels ? other.bottom_tents : other.extra_tents[static_cast<std::size_t>(level)]) =
            static_cast<int>(level == first_level ? std::round(tents) : std::floor(tents));
    }
    return other;
}

}  // namespace cloud
