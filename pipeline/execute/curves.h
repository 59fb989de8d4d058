// SPDX-License-Identifier: MIT
// The curves that specular highlights and fog need, the same bits for every CPU and compiler: the C library's own
// differ in their last ones. Double precision, + - * / only, in one fixed order: a Taylor polynomial of 2^f on
// |f| <= 1/2, and the series of the inverse hyperbolic tangent for log2.
// Relative errors, against the exact value of the double given, results below 2^-1022 apart:
//   exp2 4e-16   log2 1e-15   exp 3e-13   pow 1e-12
// Special values follow the C library: exp2(-inf) = 0, log2(0) = -inf, log2(x < 0) is not a number, overflow gives inf.
#pragma once

namespace pipeline {

double portable_exp2(double x);
double portable_log2(double x);
double portable_exp(double x);

// base >= 0; a negative base is not a number for every exponent but 0. pow(x, 0) = 1 for every x.
double portable_pow(double base, double exponent);

}  // namespace pipeline
