// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "tests/extremes/depths.h"

using namespace extremes;

TEST_CASE("extremes: geometry drawn again has the depth it had", "[extremes]") {
    const int bits   = GENERATE(16, 24, 32);
    const auto check = [&](Size size, Again again) {
        const Ties ties = depth_ties(bits, size, again);
        CHECK(ties.pixels > 50000);
        CHECK(ties.not_equal == 0);
        CHECK(ties.not_less_equal == 0);
    };
    check(Size::Whole, Again::Same);
    check(Size::Cut, Again::Same);
    check(Size::Whole, Again::WayRound);
}

// What does not hold, so that nobody counts on it: planes start at their first corner.
TEST_CASE("extremes: with another corner first, or once cut, depth differs in its last bits", "[extremes]") {
    CHECK(depth_ties(24, Size::Whole, Again::FirstCorner).not_equal > 0);
    CHECK(depth_ties(24, Size::Cut, Again::WayRound).not_equal > 0);
    const std::uint32_t difference = first_corner_difference();
    CHECK(difference > 0);
    CHECK(difference <= kFirstCornerBound);
}
