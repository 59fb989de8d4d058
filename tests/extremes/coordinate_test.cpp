// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/extremes/coordinates.h"

using namespace extremes;

TEST_CASE("extremes: a texture is read where double says, up to 2^22 texels", "[extremes]") {
    const Depths depths           = GENERATE(Depths::Equal, Depths::OneToFour);
    const raster::Address address = GENERATE(raster::Address::Wrap, raster::Address::Mirror, raster::Address::Clamp);
    for (int exponent = 8; exponent <= kLastExponent; ++exponent) {
        INFO("2^" << exponent << " texels");
        const PositionError error = position_error(exponent, depths, address);
        CHECK(error.pixels == 2 * 256 * 16);
        CHECK(error.texels < position_bound(exponent, depths));
        CHECK(error.ahead < ahead_bound(exponent, depths));
        CHECK(error.wrong_texels == 0);
    }
}

TEST_CASE("extremes: beyond 2^22 texels the position stands still", "[extremes]") {
    const PositionError error = position_error(24, Depths::Equal, raster::Address::Wrap);
    // The last coordinate is within 4 texels of 2^24, where a float has steps of one.
    CHECK(std::abs(error.texels - ((1 << 24) - (1 << 22))) < 4.0);
}
