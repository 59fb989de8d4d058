// SPDX-License-Identifier: MIT
#include "pipeline/check/pixel_region.h"

#include <bitset>
#include <catch2/catch.hpp>
#include <string>

#include "tests/support/random.h"

using namespace pipeline;
using test_support::Random;

namespace {

constexpr int kSize = 12;
using Bits          = std::bitset<kSize * kSize>;

Bits bits_of(const std::vector<PixelRect>& rects) {
    Bits bits;
    for (const PixelRect& rect : rects)
        for (int y = rect.y0; y < rect.y1; ++y)
            for (int x = rect.x0; x < rect.x1; ++x) bits.set(static_cast<std::size_t>(y * kSize + x));
    return bits;
}
Bits bits_of(const PixelRegion& region) {
    return bits_of(region.parts());
}

PixelRect random_rect(Random& random) {
    const int x = random.from(0, kSize - 1), y = random.from(0, kSize - 1);
    return {x, y, random.from(x - 1, kSize), random.from(y - 1, kSize)};  // some are empty
}

PixelRegion random_region(Random& random) {
    PixelRegion region;
    for (int i = random.from(0, 4); i > 0; --i) region.add(random_rect(random));
    return region;
}

}  // namespace

TEST_CASE("pixel regions are the sets of their pixels", "[pixel_region]") {
    Random random(3);
    for (int i = 0; i < 3000; ++i) {
        const PixelRegion a = random_region(random), b = random_region(random);
        const PixelRect rect = random_rect(random);
        const Bits of_a = bits_of(a), of_b = bits_of(b), of_rect = bits_of(std::vector{rect});
        PixelRegion more = a, less = a, both = a;
        more.add(rect);
        less.remove(rect);
        both.add(b);
        REQUIRE(bits_of(more) == (of_a | of_rect));
        REQUIRE(bits_of(less) == (of_a & ~of_rect));
        REQUIRE(bits_of(both) == (of_a | of_b));
        REQUIRE(bits_of(common_part(a, b)) == (of_a & of_b));
        REQUIRE(bits_of(without(a, b)) == (of_a & ~of_b));
        REQUIRE(meet(a, b) == (of_a & of_b).any());
        REQUIRE(a.empty() == of_a.none());
        // The parts do not overlap, else there would be more.
        for (const PixelRegion& region : {a, b, more, less, both, common_part(a, b)})
            REQUIRE(region.pixels() == static_cast<std::int64_t>(bits_of(region).count()));
    }
}

TEST_CASE("pixel regions meet where one of them is moved", "[pixel_region]") {
    const PixelRegion a(PixelRect{0, 0, 4, 4}), b(PixelRect{0, 0, 2, 2});
    CHECK(meet(a, b, 3, 3));
    CHECK_FALSE(meet(a, b, 4, 0));
    CHECK(meet(a, b, -1, 0));
    CHECK_FALSE(meet(a, b, 0, -2));
}

TEST_CASE("what lies side by side in a pixel region is one part", "[pixel_region]") {
    PixelRegion region(PixelRect{0, 0, 4, 4});
    region.add(PixelRect{4, 0, 8, 4});
    CHECK(region.parts() == std::vector{PixelRect{0, 0, 8, 4}});
    region.add(PixelRect{4, 4, 8, 8});
    region.add(PixelRect{0, 4, 4, 8});
    CHECK(region.parts() == std::vector{PixelRect{0, 0, 8, 8}});
    region.remove(PixelRect{2, 2, 6, 6});
    CHECK(region.parts().size() == 4);
    CHECK(region.bounds() == PixelRect{0, 0, 8, 8});
    CHECK(PixelRegion().bounds() == PixelRect{});
    CHECK(contains({0, 0, 8, 8}, {2, 2, 8, 8}));
    CHECK_FALSE(contains({0, 0, 8, 8}, {2, 2, 9, 8}));
    CHECK(contains({0, 0, 1, 1}, {5, 5, 5, 9}));
}
