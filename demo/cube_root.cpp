// SPDX-License-Identifier: MIT
#include "demo/cube_root.h"

#include <cmath>

namespace demo {

double cube_root(double value) {
    if (value <= 0.0) return 0.0;
    // value = mantissa 8^power, mantissa in [1/8, 1): both steps are exact.
    int exponent        = 0;
    double mantissa     = std::frexp(value, &exponent);
    const int remainder = ((exponent % 3) + 3) % 3;
    mantissa            = std::ldexp(mantissa, remainder == 0 ? 0 : remainder - 3);
    const int power     = (exponent + (remainder == 0 ? 0 : 3 - remainder)) / 3;
    // Newton's steps from a line that is within 7 %, each squaring the error: 4e-3, 2e-5, 3e-10, below 1e-16.
    double root         = 0.46 + 0.58 * mantissa;
    for (int i = 0; i < 4; ++i) root -= (root - mantissa / (root * root)) / 3.0;
    return std::ldexp(root, power);
}

}  // namespace demo
