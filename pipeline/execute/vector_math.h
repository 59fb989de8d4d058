// SPDX-License-Identifier: MIT
// Products and lengths of vectors in one evident order. Lengths are double, so that no finite vector overflows or
// vanishes.
#pragma once

#include <cmath>

#include "pipeline/frame/math_types.h"

namespace pipeline {

inline float dot3(const Vec3& a, const Vec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline double length3(const Vec3& v) {
    const double x = v.x, y = v.y, z = v.z;
    return std::sqrt(x * x + y * y + z * z);
}

// The zero vector stays as it is.
inline Vec3 normalize3(const Vec3& v) {
    const double length = length3(v);
    if (length == 0.0) return v;
    return Vec3(static_cast<float>(v.x / length), static_cast<float>(v.y / length), static_cast<float>(v.z / length));
}

// To [0, 1]; not-a-number, as overflow may leave it, counts as 0.
inline float clamp01(float value) {
    return value > 0.0f ? (value < 1.0f ? value : 1.0f) : 0.0f;
}

}  // namespace pipeline
