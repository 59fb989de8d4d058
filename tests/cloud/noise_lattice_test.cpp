// SPDX-License-Identifier: MIT
// What is computed a row, or a particle, at a time is, bit for bit, what its points are by themselves.
#include <catch2/catch.hpp>
#include <cstring>

#include "cloud/bake.h"
#include "cloud/noise.h"
#include "tests/cloud/cumulus.h"

using namespace cloud;

namespace {

// Last first, each through a function that has seen no other.
void in_reverse(std::size_t count, const std::function<void(std::size_t)>& work) {
    for (std::size_t i = count; i-- > 0;) work(i);
}

}  // namespace

TEST_CASE("rows of a noise lattice are the noise of their points") {
    std::array<std::vector<float>, 3> coordinates;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (int i = 0; i < 23; ++i)
            coordinates[axis].push_back(0.17f * static_cast<float>(i) - static_cast<float>(axis) * 1.3f);
    const NoiseLattice lattice(coordinates, 4);
    for (std::size_t along = 0; along < 3; ++along)
        for (const NoiseLattice::Point start : {NoiseLattice::Point{0, 0, 0}, {5, 11, 22}, {22, 3, 8}}) {
            const auto fbms    = lattice.fbm_row(along, start, 0.6f, 7),
                       billows = lattice.billow_row(along, start, 0.6f, 7);
            REQUIRE(fbms.size() == 23);
            for (std::size_t i = 0; i < fbms.size(); ++i) {
                NoiseLattice::Point at = start;
                at[along]              = i;
                const Vec3 p(coordinates[0][at[0]], coordinates[1][at[1]], coordinates[2][at[2]]);
                REQUIRE(fbms[i] == fbm(p, 4, 0.6f, 7));
                REQUIRE(billows[i] == billow(p, 4, 0.6f, 7));
            }
        }
}

TEST_CASE("a baked cloud does not depend on the order of the work") {
    const Cloud cloud      = cumulus();
    const BakedCloud first = bake(cloud, Daylight{}), other = bake(cloud, Daylight{}, in_reverse);
    const std::vector<LitVertex> a = first.lit.vertices.all(), b = other.lit.vertices.all();
    REQUIRE(a.size() == b.size());
    CHECK(std::memcmp(a.data(), b.data(), a.size() * sizeof(LitVertex)) == 0);
    CHECK(first.lit.mean_color == other.lit.mean_color);
    CHECK(*first.fractal == *other.fractal);
}
