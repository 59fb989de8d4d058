// SPDX-License-Identifier: MIT
#include "pipeline/execute/fog.h"

#include <cmath>

#include "pipeline/execute/curves.h"
#include "pipeline/execute/vector_math.h"

namespace pipeline {
namespace {

double unclamped_fog_factor(const FogState& fog, double distance) {
    const double depth = fog.density * distance;
    switch (fog.mode) {
        case FogMode::None:
            return 1.0;
        case FogMode::Linear:
            if (fog.start == fog.end) return 0.0;
            return (fog.end - distance) / (static_cast<double>(fog.end) - fog.start);
        case FogMode::Exp:
            return portable_exp(-depth);
        case FogMode::Exp2:
            return portable_exp(-(depth * depth));
    }
    return 1.0;
}

}  // namespace

float fog_factor(const FogState& fog, const Vec3& camera_position) {
    const double distance = fog.range ? length3(camera_position) : std::abs(static_cast<double>(camera_position.z));
    return clamp01(static_cast<float>(unclamped_fog_factor(fog, distance)));
}

}  // namespace pipeline
