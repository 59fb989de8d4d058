// SPDX-License-Identifier: MIT
// Copies from one channel to another, alpha to red, green and blue and green to alpha: known answers, and both copy_pixels and the
// reference against the closed form, all bytes in all formats.
#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <vector>

#include "raster/copy_pixels.h"
#include "tests/raster/blend_formula.h"
#include "tests/raster/exact.h"
#include "tests/support/random.h"

namespace {

using namespace raster;
using exact::Pixel;

constexpr ColorFormat k8888{}, k8880{8, 8, 8, 0}, k6666{6, 6, 6, 6}, k565{5, 6, 5, 0}, k1555{5, 5, 5, 1},
    kZeros8880{8, 8, 8, 0, true}, kZeros5551{5, 5, 5, 1, true};

std::uint32_t copied(CopyChannels channels, std::uint32_t from, std::uint32_t to,
                     const ColorFormat& target_format = {}) {
    std::array<std::uint32_t, 2> results{};
    for (const bool reference : {false, true}) {
        Image source(1, 1), target(1, 1);
        source.row(0)[0] = from;
        target.row(0)[0] = to;
        (reference ? reference_copy_pixels : copy_pixels)({.source        = &source,
                                                           .from          = {0, 0, 1, 1},
                                                           .target        = &target,
                                                           .target_format = target_format,
                                                           .channels      = channels});
        results[reference] = target.row(0)[0];
    }
    CHECK(results[0] == results[1]);
    return results[0];
}

// Bytes 0, 1, 2, 3 of a pixel are blue, green, red and alpha.
std::uint32_t formula(CopyChannels channels, const ColorFormat& format, std::uint32_t from, std::uint32_t to) {
    Pixel out          = Pixel::of(to);
    const Pixel source = Pixel::of(from);
    if (channels == CopyChannels::All) out = source;
    if (channels == CopyChannels::AlphaToColor) out.c[0] = out.c[1] = out.c[2] = source.c[3];
    if (channels == CopyChannels::GreenToAlpha) out.c[3] = source.c[1];
    return blend_formula::stored(format, out).argb();
}

Image random_image(int width, int height, std::uint32_t seed, const ColorFormat& format = {}) {
    Image image(width, height);
    test_support::Random random(seed);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.row(y)[x] = blend_formula::stored(format, Pixel::of(random.bits())).argb();
    return image;
}

}  // namespace

TEST_CASE("copies between channels with known answers", "[raster]") {
    CHECK(copied(CopyChannels::All, 0x12345678, 0x9abcdef0) == 0x12345678);
    CHECK(copied(CopyChannels::AlphaToColor, 0x12345678, 0x9abcdef0) == 0x9a121212);
    CHECK(copied(CopyChannels::GreenToAlpha, 0x12345678, 0x9abcdef0) == 0x56bcdef0);
    // As the target keeps it: 5 and 6 bits of 0x87 are 16 and 33, which read as 0x84 and 0x86.
    CHECK(copied(CopyChannels::AlphaToColor, 0x87000000, 0xff000000, k565) == 0xff848684);
    CHECK(copied(CopyChannels::GreenToAlpha, 0x00008000, 0x00ff0000, k1555) == 0xffff0000);
    CHECK(copied(CopyChannels::GreenToAlpha, 0x00007f00, 0xffff0000, k1555) == 0x00ff0000);
    CHECK(copied(CopyChannels::GreenToAlpha, 0x0000ff00, 0x00f80000, kZeros5551) == 0x80f80000);
    CHECK(copied(CopyChannels::GreenToAlpha, 0x00000000, 0xff123456, k8880) == 0xff123456);  // no alpha to write
    CHECK(copied(CopyChannels::GreenToAlpha, 0x00000000, 0x80123456, kZeros8880) == 0x80123456);
}

TEST_CASE("copies between channels are exact for all bytes and formats, anywhere", "[raster][exhaustive]") {
    const CopyChannels channels = GENERATE(CopyChannels::AlphaToColor, CopyChannels::GreenToAlpha);
    test_support::Random random(3);
    for (const ColorFormat& format : {k8888, k8880, k6666, k565, k1555, kZeros8880, kZeros5551}) {
        Image source = random_image(256, 9, 1);
        for (int x = 0; x < 256; ++x)
            source.row(4)[x] = static_cast<std::uint32_t>(x) << 24 | static_cast<std::uint32_t>(255 - x) << 8;
        const Image before = random_image(300, 20, 2, format);
        const int left = random.from(0, 3), top = random.from(0, 3), x0 = random.from(0, 40), y0 = random.from(0, 10);
        const Rect from{left, top, 256, 9};
        for (const bool reference : {false, true}) {
            Image target(300, 20);
            for (int y = 0; y < 20; ++y) std::copy_n(before.row(y), 300, target.row(y));
            (reference ? reference_copy_pixels : copy_pixels)({.source        = &source,
                                                               .from          = from,
                                                               .target        = &target,
                                                               .target_format = format,
                                                               .x             = x0,
                                                               .y             = y0,
                                                               .channels      = channels});
            int wrong = 0;
            for (int y = 0; y < 20; ++y)
                for (int x = 0; x < 300; ++x) {
                    const int sx = x - x0 + left, sy = y - y0 + top;
                    const bool is_inside    = sx >= from.x0 && sx < from.x1 && sy >= from.y0 && sy < from.y1;
                    const std::uint32_t old = before.row(y)[x];
                    wrong += target.row(y)[x] != (is_inside ? formula(channels, format, source.row(sy)[sx], old) : old);
                }
            INFO((reference ? "reference" : "copy_pixels"));
            CHECK(wrong == 0);
        }
    }
}
