// SPDX-License-Identifier: MIT
#include "cloud/silver_lining.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace cloud {

namespace {

constexpr float kForward = 0.7f;  // g: the mean cosine of the angle by which light is turned

// 1 straight ahead.
float henyey_greenstein(float cosine) {
    const float ahead = (1.0f - kForward) * (1.0f - kForward);
    const float ratio = ahead / (ahead + 2.0f * kForward * (1.0f - cosine));
    return ratio * std::sqrt(ratio);
}

}  // namespace

float forward_scattering(float cosine) {
    if (cosine <= 0.0f) return 0.0f;
    const float aside = henyey_greenstein(0.0f);
    return (henyey_greenstein(std::min(cosine, 1.0f)) - aside) / (1.0f - aside);
}

Vec3 silver_lining(const Cloud& cloud, const Daylight& daylight, const LitVertex& vertex, Vec3 eye) {
    const Vec3 away      = vertex.position - eye;
    const float distance = glm::length(away);
    if (cloud.silver_lining <= 0.0f || !(distance > 0.0f)) return Vec3(0.0f);
    const Vec3 view   = away / distance;
    const float edge  = 1.0f - std::min(std::abs(glm::dot(vertex.normal, view)), 1.0f);
    const float phase = forward_scattering(glm::dot(view, daylight.to_sun));
    return daylight.sun * (cloud.silver_lining * vertex.sun * edge * phase);
}

}  // namespace cloud
