// SPDX-License-Identifier: MIT
// What formats keep of a colour: all values of each channel, beside any others. (blend_store_test.cpp has the
// kernels' store.)
#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "raster/color_format.h"
#include "raster/reference_color.h"
#include "tests/raster/blend_formula.h"

namespace {

using namespace raster;
using exact::Pixel;

std::vector<ColorFormat> all_formats() {
    std::vector<ColorFormat> formats;
    for (const bool zero_fill : {false, true})
        for (const int red : {5, 6, 8})
            for (const int green : {5, 6, 8})
                for (const int blue : {5, 6, 8})
                    for (const int alpha : {0, 1, 5, 6, 8}) formats.push_back({red, green, blue, alpha, zero_fill});
    return formats;
}

// One channel of what `format` gives back of value v in all channels.
int read(int bits, bool zero_fill, int v) {
    const ColorFormat format{8, 8, 8, bits, zero_fill};
    return static_cast<int>(stored(store_masks(format), static_cast<std::uint32_t>(v) << 24) >> 24);
}

// Runs check(format, colour) for each format and, in each channel, each value beside others of several kinds.
template <class Check>
void for_each_color(Check&& check) {
    for (const ColorFormat& format : all_formats())
        for (int channel = 0; channel < 4; ++channel)
            for (int v = 0; v < 256; ++v)
                for (const std::uint32_t others : {0u, 0xffffffffu, 0x9e3779b9u * static_cast<std::uint32_t>(v + 1)}) {
                    const std::uint32_t byte = 0xffu << 8 * channel;
                    check(format, (others & ~byte) | static_cast<std::uint32_t>(v) << 8 * channel);
                }
}

}  // namespace

TEST_CASE("a format gives back of each channel what the formula says", "[raster][exhaustive]") {
    for_each_color([](const ColorFormat& format, std::uint32_t argb) {
        const std::uint32_t want = blend_formula::stored(format, Pixel::of(argb)).argb();
        const std::uint32_t got = stored(store_masks(format), argb), reference = reference::stored_color(format, argb);
        if (got == want && reference == want) return;
        CAPTURE(format.red, format.green, format.blue, format.alpha, format.zero_fill, argb);
        CHECK(got == want);
        REQUIRE(reference == want);
    });
    CHECK(all_formats().size() == 270);
}

TEST_CASE("what is read from a target, written again, is kept as it is", "[raster][exhaustive]") {
    for_each_color([](const ColorFormat& format, std::uint32_t argb) {
        const StoreMasks masks   = store_masks(format);
        const std::uint32_t once = stored(masks, argb);
        if (stored(masks, once) == once) return;
        CAPTURE(format.red, format.green, format.blue, format.alpha, format.zero_fill, argb);
        REQUIRE(stored(masks, once) == once);
    });
}

TEST_CASE("repeated bits spread the kept values evenly over 0 to 255", "[raster][exhaustive]") {
    for (const int bits : {1, 5, 6, 8})
        for (int v = 0; v < 256; ++v) {
            CAPTURE(bits, v);
            const int kept = v * (1 << bits) / 256, most = (1 << bits) - 1;
            REQUIRE(std::abs(most * read(bits, false, v) - 255 * kept) < most);  // less than one from 255 * kept / most
            REQUIRE(read(bits, true, v) == kept * (256 >> bits));
        }
}

TEST_CASE("formats with known answers", "[raster]") {
    struct Known {
        int bits;
        bool zero_fill;
        int value, read;
    };
    for (const auto& [bits, zero_fill, value, want] : std::vector<Known>{{8, false, 0xa7, 0xa7},
                                                                         {6, false, 0x83, 0x82},
                                                                         {6, false, 0x7f, 0x7d},
                                                                         {6, true, 0xff, 0xfc},
                                                                         {5, false, 0x87, 0x84},
                                                                         {5, false, 0x7f, 0x7b},
                                                                         {5, true, 0xff, 0xf8},
                                                                         {1, false, 0x7f, 0x00},
                                                                         {1, false, 0x80, 0xff},
                                                                         {1, true, 0xff, 0x80},
                                                                         {0, false, 0x12, 0xff},
                                                                         {0, true, 0x12, 0x80}}) {
        CAPTURE(bits, zero_fill, value);
        CHECK(read(bits, zero_fill, value) == want);
    }
    CHECK(store_masks({}) == StoreMasks{});
}
