// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "tests/extremes/downsample.h"

using namespace extremes;

TEST_CASE("extremes: odd sizes halved down to 1x1 keep constants, and energy to the filter's bound", "[extremes]") {
    for (std::size_t i = 0; i < pipeline::EnumNames<pipeline::FilterRule>::names.size(); ++i) {
        const auto filter        = static_cast<pipeline::FilterRule>(i);
        const HalvingError error = halving_error(filter);
        for (const auto& [width, height] : kChains) {
            INFO(pipeline::EnumNames<pipeline::FilterRule>::names[i] << ", " << width << "x" << height);
            CHECK(changed_constants(filter, width, height) == 0);
            const Energy energy = energy_drift(filter, width, height, 1);
            CHECK(energy.least >= error.least * energy.halvings - 1e-9);
            CHECK(energy.greatest <= error.greatest * energy.halvings + 1e-9);
        }
    }
}
