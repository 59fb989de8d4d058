// SPDX-License-Identifier: MIT
// The comparison of pictures itself: it must fail when it should.
#include "tests/support/image_match.h"

#include <catch2/catch.hpp>

#include "demo/image_file.h"
#include "tests/support/child_process.h"

using pipeline::ColorImage;
using test_support::compare_pictures;
using test_support::describe;
using test_support::difference_image;
using test_support::match_images;

namespace {

ColorImage gradient(int width, int height) {
    ColorImage image{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.pixels.push_back(0xff000000u | static_cast<std::uint32_t>(x * 3 << 16 | y * 5 << 8 | (x + y)));
    return image;
}

}  // namespace

TEST_CASE("equal pictures match", "[golden]") {
    CHECK(match_images(gradient(17, 9), gradient(17, 9)).equal());
    CHECK(describe(match_images(gradient(17, 9), gradient(17, 9))) == "");
}

TEST_CASE("one step of any channel of any pixel is a difference", "[golden]") {
    const ColorImage want = gradient(17, 9);
    for (std::size_t i = 0; i < want.pixels.size(); ++i)
        for (const int shift : {0, 8, 16, 24}) {
            ColorImage got = want;
            got.pixels[i] ^= 1u << shift;
            const auto match = match_images(got, want);
            CHECK_FALSE(match.equal());
            CHECK(match.differing == 1);
            CHECK(match.worst_difference == 1);
            CHECK(match.worst_x + match.worst_y * 17 == static_cast<int>(i));
        }
}

TEST_CASE("the worst pixel is named, and the others are counted", "[golden]") {
    const ColorImage want = gradient(17, 9);
    ColorImage got        = want;
    got.pixels[3] += 2;
    got.pixels[17 * 4 + 5]  = 0xff80190a;  // red 0x80 instead of 0x0f
    got.pixels[17 * 4 + 4]  = 0xff80140a;  // differs as much: the first is named
    got.pixels[17 * 8 + 16] = want.pixels[17 * 8 + 16] - 0x1000;
    CHECK(describe(match_images(got, want)) ==
          "4 of 153 pixels differ, by at most 116, as at (4, 4): ff80140a, not ff0c1408");
    const ColorImage shown = difference_image(got, want);
    CHECK(shown.pixels[0] == 0xff000000);
    CHECK(shown.pixels[3] == 0xff000041);
    CHECK(shown.pixels[17 * 4 + 4] == 0xff970041);
}

TEST_CASE("pictures of two sizes differ, even with the same pixels", "[golden]") {
    ColorImage turned = gradient(12, 6);
    std::swap(turned.width, turned.height);
    const auto match = match_images(turned, gradient(12, 6));
    CHECK_FALSE(match.equal());
    CHECK(describe(match) == "6x12 pixels instead of 12x6");
}

TEST_CASE("a failure leaves pictures to look at, and a success takes them away", "[golden]") {
    const tests::ScratchDirectory scratch;
    const std::string folder = scratch / "a/b";
    const ColorImage want    = gradient(17, 9);
    ColorImage got           = want;
    got.pixels[20] ^= 0x0f0000;
    const std::string report = compare_pictures(got, want, folder, "x");
    CHECK(report ==
          "x: 1 of 153 pixels differ, by at most 3, as at (3, 1): ff060504, not ff090504; see " + folder + "/x.*.png");
    CHECK(demo::read_image(folder + "/x.got.png") == got);
    CHECK(demo::read_image(folder + "/x.want.png") == want);
    CHECK(demo::read_image(folder + "/x.difference.png") == difference_image(got, want));

    CHECK(compare_pictures(gradient(5, 4), want, folder, "x") ==
          "x: 5x4 pixels instead of 17x9; see " + folder + "/x.*.png");
    CHECK(demo::read_image(folder + "/x.got.png") == gradient(5, 4));
    CHECK_THROWS(demo::read_image(folder + "/x.difference.png"));

    CHECK(compare_pictures(want, want, folder, "x") == "");
    CHECK_THROWS(demo::read_image(folder + "/x.got.png"));
    CHECK_THROWS(demo::read_image(folder + "/x.want.png"));
}
