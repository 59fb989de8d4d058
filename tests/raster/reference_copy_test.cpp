// SPDX-License-Identifier: MIT
// The oracle's copies from one target to another, with known answers.
#include <array>
#include <catch2/catch.hpp>
#include <random>

#include "raster/copy_pixels.h"
#include "tests/raster/reference_scene.h"

using namespace raster;
using namespace reference_scene;

namespace {

constexpr ColorFormat kRgba6{6, 6, 6, 6};
constexpr ColorFormat kRgb8{8, 8, 8, 0};

// Four pixels, in rows, as one.
std::uint32_t halved(const std::array<std::uint32_t, 4>& pixels, const ColorFormat& from, const ColorFormat& to) {
    Image source(2, 2), target(1, 1);
    for (int i = 0; i < 4; ++i) source.row(i / 2)[i % 2] = pixels[i];
    CopyFill copy;
    copy.source        = &source;
    copy.source_format = from;
    copy.from          = source.bounds();
    copy.target        = &target;
    copy.target_format = to;
    copy.halve         = true;
    reference_copy_pixels(copy);
    return target.row(0)[0];
}

// What reading a 6-bit value gives.
constexpr std::uint32_t six(int value) {
    return grey(value << 2 | value >> 4);
}

}  // namespace

TEST_CASE("Pixels are copied to their place, and nothing else changes", "[reference]") {
    std::mt19937 random(5);
    Image source(40, 20), target(30, 25), before(30, 25);
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 40; ++x) source.row(y)[x] = random_color(random);
    for (int y = 0; y < 25; ++y)
        for (int x = 0; x < 30; ++x) target.row(y)[x] = before.row(y)[x] = random_color(random);
    const bool halve = GENERATE(false, true);
    CopyFill copy;
    copy.source = &source;
    copy.from   = {7, 3, 7 + 22, 3 + 12};
    copy.target = &target;
    copy.x      = 5;
    copy.y      = 9;
    copy.halve  = halve;
    reference_copy_pixels(copy);
    int wrong = 0;
    for (int y = 0; y < 25; ++y) {
        for (int x = 0; x < 30; ++x) {
            const int i = x - 5, j = y - 9;
            std::uint32_t expected = before.row(y)[x];
            if (i >= 0 && j >= 0 && i < (halve ? 11 : 22) && j < (halve ? 6 : 12)) {
                if (!halve) expected = source.row(3 + j)[7 + i];
                for (int c = 0; halve && c < 4; ++c) {
                    const int sum =
                        channel(source.row(3 + 2 * j)[7 + 2 * i], c) + channel(source.row(3 + 2 * j)[8 + 2 * i], c) +
                        channel(source.row(4 + 2 * j)[7 + 2 * i], c) + channel(source.row(4 + 2 * j)[8 + 2 * i], c);
                    expected = (expected & ~(0xffu << (8 * c))) | static_cast<std::uint32_t>(sum / 4) << (8 * c);
                }
            }
            if (target.row(y)[x] != expected) ++wrong;
        }
    }
    CHECK(wrong == 0);
}

TEST_CASE("A copy is written as the target keeps it", "[reference]") {
    Image source(1, 1), target(1, 1);
    source.row(0)[0]  = 0x12ff8709;
    const auto copied = [&](const ColorFormat& to) {
        CopyFill copy;
        copy.source        = &source;
        copy.from          = {0, 0, 1, 1};
        copy.target        = &target;
        copy.target_format = to;
        reference_copy_pixels(copy);
        return target.row(0)[0];
    };
    CHECK(copied({}) == 0x12ff8709);
    CHECK(copied({5, 6, 5, 0}) == 0xffff8608);
    CHECK(copied({5, 5, 5, 1, true}) == 0x00f88008);
    CHECK(copied(kRgb8) == 0xffff8709);
}

TEST_CASE("Four pixels of bytes become a quarter of their sum, rounded down", "[reference]") {
    CHECK(halved({grey(1), grey(2), grey(3), grey(5)}, {}, {}) == grey(2));
    CHECK(halved({grey(3), grey(4), grey(4), grey(4)}, {}, {}) == grey(3));
    CHECK(halved({grey(255), grey(255), grey(255), grey(254)}, {}, {}) == grey(254));
    CHECK(halved({0xff000010, 0xff000020, 0xff004030, 0xff000041}, kRgb8, {}) == 0xff001028);
    // Into six bits: 27 keeps 6, which reads as 24.
    CHECK(halved({grey(27), grey(27), grey(27), grey(27)}, {}, kRgba6) == grey(24));
}

TEST_CASE("Four pixels of six bits become a byte", "[reference]") {
    CHECK(halved({six(63), six(63), six(63), six(63)}, kRgba6, {}) == grey(255));  // 252 + 3
    CHECK(halved({six(1), 0, 0, 0}, kRgba6, {}) == grey(1));
    CHECK(halved({six(16), six(16), six(16), six(16)}, kRgba6, {}) == grey(65));  // 64 + 1
    CHECK(halved({six(63), six(63), six(63), six(0)}, kRgba6, {}) == grey(191));  // 189 + 2
    // Bytes would give (195 + 3 * 28) / 4 = 69; six bits 48 + 3 * 7 = 69, and 1.
    CHECK(halved({six(48), six(7), six(7), six(7)}, kRgba6, {}) == grey(70));
    // Back into six bits: 70 keeps 17, which reads as 68 + 1.
    CHECK(halved({six(48), six(7), six(7), six(7)}, kRgba6, kRgba6) == six(17));
    // Four alike are what one of them reads as.
    for (int value = 0; value < 64; ++value)
        CHECK(halved({six(value), six(value), six(value), six(value)}, kRgba6, {}) == six(value));
    // Channel by channel: green has 6 bits here, the others 8. 255 + 3 * 4 = 267, 66.75; 63 + 3 = 66, and 1.
    CHECK(halved({0xffffffff, 0x04040404, 0x04040404, 0x04040404}, {8, 6, 8, 8}, {}) == 0x42424342);
}
