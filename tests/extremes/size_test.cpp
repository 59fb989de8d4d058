// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "tests/extremes/sizes.h"
#include "tests/support/child_process.h"

using namespace extremes;

TEST_CASE("extremes: targets of any size are drawn whole", "[extremes]") {
    for (const auto& [width, height] : kSizes) {
        INFO(width << "x" << height);
        const Hits hits = size_hits(width, height);
        CHECK(hits.pixels == static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height));
        CHECK(hits.wrong == 0);
    }
}

TEST_CASE("extremes: larger targets, and none, are refused before memory is taken", "[extremes]") {
    for (const auto& [width, height] : kTooLarge) CHECK(is_refused(width, height));
    CHECK(is_refused(0, 1));
    CHECK(is_refused(1, -1));
    CHECK_FALSE(is_refused(8192, 1));
}

TEST_CASE("extremes: the program refuses a picture of 8193 pixels in one line", "[extremes]") {
    const tests::ScratchDirectory directory;
    const tests::Ended ended = tests::run_program(
        NIMBUS7_PROGRAM, {"render", "canyon", "--size", "8193x16", "-o", "out.png"}, directory.path());
    CHECK(ended.status == 2);
    CHECK(ended.error.find('\n') == ended.error.size() - 1);
    CHECK(ended.error.find("8192") != std::string::npos);
    CHECK(directory.files().empty());
}
