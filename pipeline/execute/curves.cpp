// SPDX-License-Identifier: MIT
#include "pipeline/execute/curves.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pipeline {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLn2      = 0x1.62e42fefa39efp-1;
constexpr double kLog2E    = 0x1.71547652b82fep+0;

// 2^n for a normal result, -1022 <= n <= 1023.
double power_of_two(std::int64_t n) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(n + 1023) << 52);
}

}  // namespace

double portable_exp2(double x) {
    if (std::isnan(x)) return x;
    if (x >= 1024.0) return kInfinity;
    if (x < -1080.0) return 0.0;

    // 2^x = 2^n * e^t. |t| <= 0.3466, so the first term left out, t^14 / 14!, is below 5e-18.
    const double whole = std::floor(x + 0.5);
    const double t     = (x - whole) * kLn2;
    double sum         = 1.0;
    for (int k = 13; k >= 2; --k) sum = sum * (t / k) + 1.0;
    const double e_to_t = sum * t + 1.0;

    // In two factors, of which neither overflows nor is subnormal where their product is neither.
    const auto n    = static_cast<std::int64_t>(whole);
    const auto half = n / 2;
    return e_to_t * power_of_two(half) * power_of_two(n - half);
}

double portable_log2(double x) {
    if (std::isnan(x) || x == kInfinity) return x;
    if (x < 0.0) return std::numeric_limits<double>::quiet_NaN();
    if (x == 0.0) return -kInfinity;

    double exponent = 0.0;
    if (x < std::numeric_limits<double>::min()) {  // subnormal
        x *= 0x1p54;
        exponent = -54.0;
    }
    const auto bits = std::bit_cast<std::uint64_t>(x);
    double mantissa = std::bit_cast<double>((bits & 0x000fffffffffffffu) | 0x3ff0000000000000u);  // 1 .. 2
    exponent += static_cast<double>(static_cast<std::int64_t>(bits >> 52) - 1023);
    if (mantissa > 0x1.6a09e667f3bcdp+0) {  // sqrt(2): centres the mantissa on 1, where the logarithm is 0
        mantissa *= 0.5;
        exponent += 1.0;
    }

    // ln m = 2 (s + s^3 / 3 + s^5 / 5 + ...), s = (m - 1) / (m + 1). |s| <= 0.1716, so s^23 / 23 is below 1e-18 of s.
    const double s       = (mantissa - 1.0) / (mantissa + 1.0);
    const double squared = s * s;
    double series        = 1.0 / 21.0;
    for (int k = 19; k >= 1; k -= 2) series = series * squared + 1.0 / k;
    return exponent + series * s * (2.0 * kLog2E);
}

double portable_exp(double x) {
    return portable_exp2(x * kLog2E);
}

double portable_pow(double base, double exponent) {
    if (exponent == 0.0) return 1.0;
    return portable_exp2(exponent * portable_log2(base));
}

}  // namespace pipeline
