// SPDX-License-Identifier: MIT
#include "pipeline/execute/curves.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

using namespace pipeline;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The largest relative error of `curve` against `truth`, a function of long double, over x = least .. greatest.
template <class Curve, class Truth>
double worst_error(double least, double greatest, Curve curve, Truth truth) {
    std::mt19937 random(1);
    double worst = 0.0;
    for (int i = 0; i < 100000; ++i) {
        const double x          = least + (greatest - least) * (static_cast<double>(random()) / 4294967296.0);
        const long double wants = truth(static_cast<long double>(x));
        const long double error = wants == 0 ? std::abs(curve(x)) : std::abs((curve(x) - wants) / wants);
        worst                   = std::max(worst, static_cast<double>(error));
    }
    return worst;
}

}  // namespace

TEST_CASE("the curves keep the error bounds their header states", "[curves]") {
    const auto exp2l_of = [](long double x) { return std::exp2(x); };
    const auto log2l_of = [](long double x) { return std::log2(x); };
    const auto expl_of  = [](long double x) { return std::exp(x); };
    CHECK(worst_error(-1.0, 1.0, portable_exp2, exp2l_of) < 4e-16);
    CHECK(worst_error(-1022.0, 1023.999, portable_exp2, exp2l_of) < 4e-16);
    CHECK(worst_error(0.5, 2.0, portable_log2, log2l_of) < 1e-15);
    CHECK(worst_error(0.999, 1.001, portable_log2, log2l_of) < 1e-15);
    CHECK(worst_error(0.0, 1e300, portable_log2, log2l_of) < 1e-15);
    CHECK(worst_error(0.0, 1e-307, portable_log2, log2l_of) < 1e-15);
    CHECK(worst_error(-700.0, 700.0, portable_exp, expl_of) < 3e-13);
    for (const double exponent : {0.25, 1.0, 2.0, 5.5, 32.0, 1000.0, -3.0}) {
        INFO("exponent " << exponent);
        const auto curve = [&](double x) { return portable_pow(x, exponent); };
        const auto truth = [&](long double x) { return std::pow(x, static_cast<long double>(exponent)); };
        CHECK(worst_error(0.5, 2.0, curve, truth) < 1e-12);
    }
}

TEST_CASE("the curves are exact where the answer is a power of two", "[curves]") {
    for (int n = -1022; n <= 1023; ++n) {
        CHECK(portable_exp2(n) == std::ldexp(1.0, n));
        CHECK(portable_log2(std::ldexp(1.0, n)) == n);
    }
    CHECK(portable_exp2(-1074) == std::numeric_limits<double>::denorm_min());
    CHECK(portable_log2(std::numeric_limits<double>::denorm_min()) == -1074);
    CHECK(portable_pow(2.0, 10.0) == 1024.0);
    CHECK(portable_exp(0.0) == 1.0);
}

TEST_CASE("the curves at their limits", "[curves]") {
    CHECK(portable_exp2(1024.0) == kInfinity);
    CHECK(portable_exp2(kInfinity) == kInfinity);
    CHECK(portable_exp2(-1e9) == 0.0);
    CHECK(portable_exp2(-kInfinity) == 0.0);
    CHECK(portable_exp(-1e30) == 0.0);
    CHECK(portable_log2(0.0) == -kInfinity);
    CHECK(portable_log2(kInfinity) == kInfinity);
    CHECK(std::isnan(portable_log2(-1.0)));
    CHECK(std::isnan(portable_exp2(std::nan(""))));
    CHECK(portable_pow(0.0, 0.0) == 1.0);
    CHECK(portable_pow(0.5, 0.0) == 1.0);
    CHECK(portable_pow(0.0, 3.0) == 0.0);
    CHECK(portable_pow(0.0, -1.0) == kInfinity);
    CHECK(portable_pow(1.0, 1e30) == 1.0);
    CHECK(std::isnan(portable_pow(-1.0, 2.0)));
}
