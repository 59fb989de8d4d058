// SPDX-License-Identifier: MIT
// Pictures with known answers, for the tests of metrics.
#pragma once

#include <cmath>
#include <cstdint>

#include "demo/metrics/plane.h"

namespace tests {

// value(x, y) at each pixel.
template <class Value>
demo::Plane plane_of(int width, int height, Value&& value) {
    demo::Plane plane(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) plane.at(x, y) = static_cast<float>(value(x, y));
    return plane;
}

// 1 left of column `edge`, 0 right of it, as a Gaussian blurs it.
inline demo::Plane gaussian_edge(int width, int height, double edge, double sigma) {
    return plane_of(width, height, [&](int x, int) { return 0.5 * std::erfc((x - edge) / (sigma * std::sqrt(2.0))); });
}

inline demo::Mask all_of(const demo::Plane& plane) {
    return demo::Mask(plane.width, plane.height, 1);
}

// 0..1, without any pattern.
inline double noise_at(int x, int y) {
    std::uint32_t hash = static_cast<std::uint32_t>(x) * 0x9e3779b1u ^ static_cast<std::uint32_t>(y) * 0x85ebca77u;
    hash ^= hash >> 15, hash *= 0x2c1b3c6du, hash ^= hash >> 12, hash *= 0x297a2d39u, hash ^= hash >> 15;
    return (hash >> 8) / 16777216.0;
}

}  // namespace tests
