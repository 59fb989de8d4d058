// SPDX-License-Identifier: MIT
// Copies against the closed forms of raster/copy_pixels.h: all formats, all values, and of the halved ones all sums
// that four bytes or four 6-bit values have. Both copy_pixels and the reference.
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

constexpr ColorFormat k8888{}, k6666{6, 6, 6, 6}, k6660{6, 6, 6, 0}, k565{5, 6, 5, 0}, k1555{5, 5, 5, 1},
    k8880{8, 8, 8, 0, true}, k5551{5, 5, 5, 1, true};

// As it is halved, by the format of the source; before the target's.
Pixel halved(const ColorFormat& format, const std::array<Pixel, 4>& pixels) {
    Pixel out;
    for (int c = 0; c < 4; ++c) {
        const bool six_bits = channel_bits(format, c) == 6;
        int sum             = 0;
        for (const Pixel& pixel : pixels) sum += six_bits ? pixel.c[c] / 4 : pixel.c[c];
        out.c[c] = six_bits ? sum + sum / 64 : sum / 4;
    }
    return out;
}

// Copies by both means, and compares every pixel of the target with the form.
void check_copy(CopyFill copy, int target_width, int target_height) {
    const int scale = copy.halve ? 2 : 1;
    const Rect placed{copy.x, copy.y, copy.x + (copy.from.x1 - copy.from.x0) / scale,
                      copy.y + (copy.from.y1 - copy.from.y0) / scale};
    for (const bool reference : {false, true}) {
        Image target(target_width, target_height);
        for (int y = 0; y < target_height; ++y)
            for (int x = 0; x < target_width; ++x) target.row(y)[x] = 0x12345678;
        copy.target = &target;
        (reference ? reference_copy_pixels : copy_pixels)(copy);
        for (int y = 0; y < target_height; ++y)
            for (int x = 0; x < target_width; ++x) {
                std::uint32_t want = 0x12345678;
                std::array<Pixel, 4> pixels;
                if (x >= placed.x0 && x < placed.x1 && y >= placed.y0 && y < placed.y1) {
                    for (int k = 0; k < 4; ++k)
                        pixels[k] = Pixel::of(copy.source->row(
                            copy.from.y0 + scale * (y - placed.y0) +
                            (copy.halve ? k / 2
                                        : 0))[copy.from.x0 + scale * (x - placed.x0) + (copy.halve ? k % 2 : 0)]);
                    want = blend_formula::stored(copy.target_format,
                                                 copy.halve ? halved(copy.source_format, pixels) : pixels[0])
                               .argb();
                }
                if (target.row(y)[x] == want) continue;
                FAIL((reference ? "reference" : "copy_pixels")
                     << (copy.halve ? ", halved" : "") << ", pixel " << x << ", " << y << " of 4 pixels from "
                     << std::hex << pixels[0].argb() << ": got " << target.row(y)[x] << " want " << want);
            }
    }
    SUCCEED();
}

// Squares of 2 x 2 pixels: all pairs of bytes stand in the upper two of a channel, anything in the lower two.
Image all_pairs() {
    Image image(512, 512);
    test_support::Random random(6);
    for (int y = 0; y < 512; y += 2)
        for (int x = 0; x < 512; x += 2) {
            Pixel left, right;
            for (int c = 0; c < 4; ++c) {
                left.c[c]  = exact::shuffled(c, x / 2);
                right.c[c] = exact::shuffled(c, y / 2);
            }
            image.row(y)[x]         = left.argb();
            image.row(y)[x + 1]     = right.argb();
            image.row(y + 1)[x]     = random.one_of({0u, 0xffffffffu, random.bits(), random.bits()});
            image.row(y + 1)[x + 1] = random.one_of({0u, 0xffffffffu, random.bits(), random.bits()});
        }
    return image;
}

}  // namespace

TEST_CASE("a copy is in the target's format, whatever the source's", "[raster][exhaustive]") {
    Image source(512, 64);
    test_support::Random random(4);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 512; ++x) {
            Pixel p;
            for (int c = 0; c < 4; ++c) p.c[c] = exact::shuffled(c, x);
            source.row(y)[x] = y == 0 ? p.argb() : random.bits();
        }
    const bool halve = GENERATE(false, true);
    for (const ColorFormat& from : {k8888, k6666, k6660, k8880, k1555})
        for (const ColorFormat& to : {k8888, k6666, k6660, k565, k1555, k8880, k5551})
            check_copy({.source        = &source,
                        .source_format = from,
                        .from          = source.bounds(),
                        .target_format = to,
                        .halve         = halve},
                       512, 64);
}

TEST_CASE("a halved copy is exact for all sums, of 8 bits and of 6", "[raster][exhaustive]") {
    const Image source = all_pairs();
    check_copy({.source        = &source,
                .source_format = GENERATE(k8888, k6666, k6660),
                .from          = source.bounds(),
                .target_format = k8888,
                .halve         = true},
               256, 256);
    // Each sum of four bytes; of 6 bits with any low bits, of which the sum is 0..252.
    Image sums(2 * 1021, 2);
    for (int sum = 0; sum <= 1020; ++sum)
        for (int k = 0; k < 4; ++k) {
            const int part                   = (sum + k) / 4;
            sums.row(k / 2)[2 * sum + k % 2] = Pixel{{part, part, part, part}}.argb();
        }
    check_copy({.source = &sums, .source_format = GENERATE(k8888, k6666), .from = sums.bounds(), .halve = true}, 1021,
               1);
}

TEST_CASE("halved copies with known answers", "[raster]") {
    struct Known {
        int bits;
        std::array<int, 4> values;
        int want;
    };
    for (const auto& [bits, values, want] : std::vector<Known>{{8, {0, 0, 0, 3}, 0},
                                                               {8, {1, 1, 1, 1}, 1},
                                                               {8, {255, 255, 255, 254}, 254},
                                                               {8, {255, 255, 255, 255}, 255},
                                                               {6, {255, 255, 255, 255}, 255},  // S = 252
                                                               {6, {255, 255, 255, 251}, 254},  // S = 251
                                                               {6, {3, 3, 3, 3}, 0},            // S = 0
                                                               {6, {130, 130, 130, 130}, 130},  // S = 128
                                                               {6, {4, 0, 0, 0}, 1}}) {         // S = 1
        Image source(2, 2), target(1, 1);
        for (int k = 0; k < 4; ++k) source.row(k / 2)[k % 2] = static_cast<std::uint32_t>(values[k]) << 8;
        copy_pixels({.source        = &source,
                     .source_format = {8, bits, 8, 8},
                     .from          = source.bounds(),
                     .target        = &target,
                     .halve         = true});
        CAPTURE(bits, values[0], values[3]);
        CHECK(target.row(0)[0] == static_cast<std::uint32_t>(want) << 8);
    }
}

TEST_CASE("a copy takes a part of its source to any place and touches no other pixel", "[raster]") {
    const Image source = all_pairs();
    const bool halve   = GENERATE(false, true);
    test_support::Random random(8);
    for (int i = 0; i < 40; ++i) {
        const int scale = halve ? 2 : 1, width = random.from(0, 20), height = random.from(0, 20);
        const int x0 = random.from(0, 470), y0 = random.from(0, 470);
        check_copy({.source        = &source,
                    .source_format = random.one_of({k8888, k6666}),
                    .from          = {x0, y0, x0 + scale * width, y0 + scale * height},
                    .target_format = random.one_of({k8888, k565, k5551}),
                    .x             = random.from(0, 64 - width),
                    .y             = random.from(0, 64 - height),
                    .halve         = halve},
                   64, 64);
    }
}
