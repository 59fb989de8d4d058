// SPDX-License-Identifier: MIT
#include "cloud/baselines/soft_disc.h"

#include <algorithm>
#include <cmath>

#include "cloud/noise.h"

namespace cloud {
namespace {

constexpr float kNoiseCycles      = 5.0f;  // across the disc
constexpr int kNoiseOctaves       = 4;
constexpr float kNoiseGain        = 0.6f;
constexpr std::uint32_t kNoiseKey = 5;

float smooth(float t) {
    t = std::clamp(t, 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

// x, y: -1..1 across the disc.
float disc_alpha(float x, float y) {
    const float r = std::sqrt(x * x + y * y);
    const float n = fbm(Vec3(x, y, 0.37f) * (0.5f * kNoiseCycles), kNoiseOctaves, kNoiseGain, kNoiseKey);
    return smooth(1.7f * (1.0f - r) + 1.6f * n * r - 0.25f) * smooth(5.0f * (1.0f - r));
}

std::vector<std::uint8_t> make_texels() {
    std::vector<std::uint8_t> texels;
    texels.reserve(std::size_t{kSoftDiscSize} * kSoftDiscSize);
    // From the first texel's centre to the last one's, so that both lie on the border.
    const auto across = [](int i) { return 2.0f * static_cast<float>(i) / (kSoftDiscSize - 1) - 1.0f; };
    for (int row = 0; row < kSoftDiscSize; ++row)
        for (int column = 0; column < kSoftDiscSize; ++column)
            texels.push_back(static_cast<std::uint8_t>(disc_alpha(across(column), across(row)) * 255.0f + 0.5f));
    return texels;
}

}  // namespace

const std::vector<std::uint8_t>& soft_disc_texels() {
    static const std::vector<std::uint8_t> texels = make_texels();
    return texels;
}

}  // namespace cloud
