// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <numeric>
#include <vector>

#include "raster/copy_row.h"

TEST_CASE("a row is copied, and nothing beyond it", "[raster]") {
    std::vector<std::uint32_t> from(100);
    std::iota(from.begin(), from.end(), 1u);
    for (int count = 0; count <= 50; ++count)
        for (int place = 0; place < 3; ++place) {
            std::vector<std::uint32_t> to(100, 0u), wanted = to;
            std::copy_n(from.begin() + 1, count, wanted.begin() + place);
            raster::copy_row(from.data() + 1, count, to.data() + place);
            CHECK(to == wanted);
        }
}
