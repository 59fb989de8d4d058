// SPDX-License-Identifier: MIT
#include "cloud/mega_particles/options.h"

#include <stdexcept>
#include <string>

#include "cloud/particle_mesh.h"

namespace cloud {
namespace {

void require(bool is_met, const char* name, const std::string& range, int value) {
    if (!is_met)
        throw std::invalid_argument(std::string(name) + " must be " + range + " (got " + std::to_string(value) + ")");
}

}  // namespace

void check(const MegaParticleOptions& options) {
    const int scale = options.target_scale, fewer = options.fewer_sphere_levels;
    require(scale == 1 || scale == 2 || scale == 4, "target_scale", "1, 2 or 4", scale);
    require(fewer >= 0 && fewer <= kFinestLevel, "fewer_sphere_levels", "0 to " + std::to_string(kFinestLevel), fewer);
}

}  // namespace cloud
