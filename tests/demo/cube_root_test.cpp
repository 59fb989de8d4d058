// SPDX-License-Identifier: MIT
#include "demo/cube_root.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

TEST_CASE("cube roots are right to the last digits, at every size", "[demo][gltf]") {
    for (int exponent = -1074; exponent < 1024; ++exponent) {
        for (const double mantissa : {1.0, 1.1, 1.5, 1.7320508, 1.999999}) {
            const double value = std::ldexp(mantissa, exponent);
            CHECK(demo::cube_root(value) == Approx(std::cbrt(value)).epsilon(5e-16));
        }
    }
    for (int i = 1; i <= 2000; ++i) CHECK(demo::cube_root(static_cast<double>(i) * i * i) == Approx(i).epsilon(3e-16));
    CHECK(demo::cube_root(0.0) == 0.0);
    CHECK(demo::cube_root(1.0) == 1.0);
    CHECK(demo::cube_root(8.0) == 2.0);
}
