// SPDX-License-Identifier: MIT
#include "cloud/mega_particles/options.h"

#include <cstdlib>
#include <stdexcept>
#include <string>

#include "cloud/mega_particles/blur_plan.h"
#include "cloud/particle_mesh.h"

namespace cloud {
namespace {

void require(bool is_met, const char* name, const std::string& range, int value) {
    if (!is_met)
        throw std::invalid_argument(std::string(name) + " must be " + range + " (got " + std::to_string(value) + ")");
}

void require_within(const char* name, int most, int value) {
    require(std::abs(value) <= most, name, "-" + std::to_string(most) + " to " + std::to_string(most), value);
}

}  // namespace

void check(const MegaParticleOptions& options) {
    const int scale = options.target_scale, boxes = options.fractal_boxes.value_or(1);
    require(scale == 1 || scale == 2 || scale == 4, "target_scale", "1, 2 or 4", scale);
    require_within("blur_levels", kMaxBlurLevels - 1, options.blur_levels);
    require_within("sphere_levels", kFinestLevel, options.sphere_levels);
    require(boxes == 1 || boxes == 2, "fractal_boxes", "1 or 2", boxes);
}

}  // namespace cloud
