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
    float variance = static_cast<float>(plan.bottom_tents) * tent_variance(plan.levels) + (last - first) / 12.0f +
                     enlargement_variance(plan.first_level);
    variance += plan.rise == BlurRise::Steps ? (last - first) / 4.0f
                                             : first * enlargement_variance(plan.levels - plan.first_level);
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

BlurPlan replan_blur(Mode mode, const BlurPlan& plan, const MegaParticleOptions& options) {
    const int first_level = options.target_scale == 4 ? 2 : options.target_scale == 2 ? 1 : 0;
    const int finest      = std::max(first_level, 1);  // with tents
    if (first_level == 0 && options.blur_levels == 0 && options.blur_rise == BlurRise::Steps) return plan;
    BlurPlan other{.levels = std::max(plan.levels, finest), .first_level = first_level, .rise = options.blur_rise};
    if (mode == Mode::Article) return other;

    const float wanted = variance_px(plan), tolerance = texel_area(finest) / 4.0f;
    const auto is_too_wide = [&](const BlurPlan& bare) { return variance_px(bare) > wanted + tolerance; };
    for (other.levels = std::clamp(plan.levels + options.blur_levels, finest, kMaxBlurLevels);; --other.levels) {
        other.inner_tents = options.blur_rise == BlurRise::Steps;
        if (is_too_wide(other)) other.inner_tents = false;
        if (!is_too_wide(other) || other.levels <= std::max(plan.levels, finest)) break;
    }
    for (int level = other.levels; level >= finest; --level) {
        const float tents = std::max((wanted - variance_px(other)) / tent_variance(level), 0.0f);
        (level == other.levels ? other.bottom_tents : other.extra_tents[static_cast<std::size_t>(level)]) =
            static_cast<int>(level == finest ? std::round(tents) : std::floor(tents));
    }
    return other;
}

}  // namespace cloud
