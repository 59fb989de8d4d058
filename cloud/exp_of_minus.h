// SPDX-License-Identifier: MIT
#pragma once

namespace cloud {

// exp(-x) for x >= 0, in a fixed order of products: relative error below 1e-6, and 0 beyond 40.
inline float exp_of_minus(float x) {
    // exp(-x) = 1 / exp(x / 64)^64; the series of degree 9 misses exp(0.625) by less than 3e-9.
    const bool leaves_some = x < 40.0f;
    const double a         = static_cast<double>(leaves_some ? x : 0.0f) / 64.0;
    double e               = 1.0 + a / 9.0;
    for (int n = 8; n >= 1; --n) e = 1.0 + a / n * e;
    for (int i = 0; i < 6; ++i) e *= e;
    return leaves_some ? static_cast<float>(1.0 / e) : 0.0f;
}

}  // namespace cloud
