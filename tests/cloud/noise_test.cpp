// SPDX-License-Identifier: MIT
#include "cloud/noise.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace cloud;

TEST_CASE("noise is zero at lattice points, smooth between, seeded and of no preferred sign") {
    CHECK(gradient_noise(Vec3(3.0f, -2.0f, 5.0f), 1) == 0.0f);
    double sum     = 0.0;
    float steepest = 0.0f, largest = 0.0f;
    int differs = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 p(static_cast<float>(i) * 0.173f - 700.0f, static_cast<float>(i) * 0.0917f, 3.3f);
        const float value = gradient_noise(p, 1);
        sum += value;
        largest  = std::max(largest, std::abs(value));
        steepest = std::max(steepest, std::abs(gradient_noise(p + Vec3(0.001f, 0.0f, 0.0f), 1) - value) / 0.001f);
        differs += value != gradient_noise(p, 2);
    }
    CHECK(std::abs(sum / 20000.0) < 0.02);
    CHECK(largest > 0.6f);
    CHECK(largest <= 1.0f);
    CHECK(steepest < 6.0f);
    CHECK(differs > 19000);
}

TEST_CASE("sums of octaves stay within -1 and 1") {
    for (int i = 0; i < 3000; ++i) {
        const Vec3 p = Vec3(0.37f, 0.21f, 0.13f) * static_cast<float>(i);
        CHECK(std::abs(fbm(p, 5, 0.5f, 9)) <= 1.0f);
        CHECK(std::abs(billow(p, 5, 0.5f, 9)) <= 1.0f);
    }
    CHECK(fbm(Vec3(0.3f), 0, 0.5f, 1) == 0.0f);
}
