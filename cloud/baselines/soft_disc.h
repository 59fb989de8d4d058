// SPDX-License-Identifier: MIT
// The picture of one puff: a disc that fades towards a frayed rim.
#pragma once

#include <cstdint>
#include <vector>

namespace cloud {

inline constexpr int kSoftDiscSize = 128;

// The share of the disc's radius (half the texture's edge) within which it is at least half opaque, on average.
inline constexpr float kSoftDiscCore = 0.56f;

// A8 texels, kSoftDiscSize squared; 0 along the border. With r the distance from the middle (1 at the border), n noise
// of mean 0: alpha = s(1.7 (1 - r) + 1.6 n r - 0.25) s(5 (1 - r)), s(t) = t^2 (3 - 2t) of t clamped to 0..1.
const std::vector<std::uint8_t>& soft_disc_texels();

}  // namespace cloud
