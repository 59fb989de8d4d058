// SPDX-License-Identifier: MIT
#include "demo/trigonometry.h"

#include <cassert>
#include <cmath>

namespace demo {
namespace {

// Horner's form of sum (-1)^k r^(2k+1) / (2k+1)!; the first term left out is below 1e-17 at pi/4.
double sine_near_zero(double r) {
    const double s = r * r;
    double sum     = 1.0;
    for (int k = 8; k >= 1; --k) sum = 1.0 - s / static_cast<double>(2 * k * (2 * k + 1)) * sum;
    return r * sum;
}

double cosine_near_zero(double r) {
    const double s = r * r;
    double sum     = 1.0;
    for (int k = 8; k >= 1; --k) sum = 1.0 - s / static_cast<double>((2 * k - 1) * (2 * k)) * sum;
    return sum;
}

double sine_of_quadrant(double angle_rad, long quadrants_ahead) {
    assert(std::abs(angle_rad) <= 1e5);
    // pi/2 in two parts: the product of the first, of 33 bits, with a count below 2^17 is exact.
    constexpr double kHalfPiHigh = 1.57079632673412561417;
    constexpr double kHalfPiLow  = 6.07710050650619224932e-11;
    const double count           = std::floor(angle_rad / (kPi / 2.0) + 0.5);
    const double r               = (angle_rad - count * kHalfPiHigh) - count * kHalfPiLow;
    switch ((static_cast<long>(count) + quadrants_ahead) & 3) {
        case 0:
            return sine_near_zero(r);
        case 1:
            return cosine_near_zero(r);
        case 2:
            return -sine_near_zero(r);
        default:
            return -cosine_near_zero(r);
    }
}

}  // namespace

double sine(double angle_rad) {
    return sine_of_quadrant(angle_rad, 0);
}

double cosine(double angle_rad) {
    return sine_of_quadrant(angle_rad, 1);
}

double tangent(double angle_rad) {
    return sine(angle_rad) / cosine(angle_rad);
}

}  // namespace demo
