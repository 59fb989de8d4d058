// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "tests/extremes/extremes.h"
#include "tests/support/child_process.h"

TEST_CASE("the README's table of extremes is what nimbus7_extremes prints", "[readme][extremes]") {
    CHECK(tests::read_file(NIMBUS7_SOURCE_DIR "/README.md").find("\n\n" + extremes::table() + "\n") !=
          std::string::npos);
}

TEST_CASE("extremes: figures are rounded away from what is good") {
    CHECK(extremes::count_text(999) == "999");
    CHECK(extremes::count_text(1234567) == "1,234,567");
    CHECK(extremes::ceil_text(0.0, 2) == "0.00");
    CHECK(extremes::ceil_text(0.031, 2) == "0.04");
    CHECK(extremes::ceil_text(12.5, 1) == "12.5");
    CHECK(extremes::ceil_text(256.2, 0) == "257");
}
