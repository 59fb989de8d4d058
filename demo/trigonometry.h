// SPDX-License-Identifier: MIT
// Sine, cosine and tangent in a fixed order of + - * /, so that a camera and a mesh are the same bytes on every
// machine; the C library's choose their instructions by CPU. Angles in radians, |angle| <= 1e5; absolute error below
// 4e-16 + 1e-16 |angle|. Source: the Taylor series of both on [-pi/4, pi/4], after reduction by multiples of pi/2.
#pragma once

namespace demo {

inline constexpr double kPi = 3.14159265358979323846;

constexpr double radians(double degrees) {
    return degrees * (kPi / 180.0);
}

double sine(double angle_rad);
double cosine(double angle_rad);
double tangent(double angle_rad);

}  // namespace demo
