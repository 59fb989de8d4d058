// SPDX-License-Identifier: MIT
// Blits against the reference: the steps for which texels come from contiguous loads, those next to them, those at
// which coordinates wrap within a block, and pictures laid over one another pixel by pixel.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <vector>

#include "raster/fill_pass.h"
#include "raster/reference.h"
#include "raster/special_programs.h"
#include "tests/support/random.h"
#include "tests/support/simd_targets.h"

namespace {

using namespace raster;

std::vector<std::uint32_t> random_texels(test_support::Random& random, int count) {
    std::vector<std::uint32_t> texels(static_cast<std::size_t>(count));
    for (std::uint32_t& texel : texels) texel = random.bits();
    return texels;
}

// A rectangle `width` pixels wide from x, which reads `step` texels to the pixel from texel `from` on.
Rectangle blit(float x, int width, int height, double from, double step, int texture_width) {
    Rectangle r{.x0 = x, .y0 = 0.0f, .x1 = x + static_cast<float>(width), .y1 = static_cast<float>(height), .uv = {}};
    r.uv[0].u0 = static_cast<float>(from / texture_width);
    r.uv[0].u1 = static_cast<float>((from + step * width) / texture_width);
    return r;
}

bool same(const Image& a, const Image& b) {
    for (int y = 0; y < a.height(); ++y)
        if (!std::equal(a.row(y), a.row(y) + a.width(), b.row(y))) return false;
    return true;
}

Draw textured_draw(const std::vector<std::uint32_t>& texels, int width, int height) {
    Draw draw;
    draw.state.stage_count = 1;
    draw.state.stages[0]   = special::kTexelAsItIs;
    draw.state.samplers[0] = {
        .levels = {{texels.data(), width, height, width}}, .address_u = Address::Clamp, .address_v = Address::Clamp};
    return draw;
}

}  // namespace

TEST_CASE("blits at any step are those of the reference", "[raster][agreement]") {
    struct Case {
        int width;
        double step;
    };
    std::vector<Case> cases;
    for (const double step : {0.0, 0.25, 1.0 / 3, 0.5,  0.9,    0.999, 0.9999, 0.99999, 1.0,     1.00001, 1.0001, 1.001,
                              1.1, 1.99, 2.0,     2.01, 255.99, 256.0, 4096.0, 4096.01, 16384.0, -1.0,    -2.0,   -0.5})
        for (const int width : {4, 70}) cases.push_back({width, step});
    // Over as many lanes as a vector has, these come out as 1, 2 and 1/2 texels to the pixel, modulo 2^16.
    for (const int lanes : {4, 8, 16})
        for (const double step : {1.0, 2.0, 0.5}) cases.push_back({lanes - 1, step + 65536.0 / (lanes - 1)});
    test_support::Random random(7);
    for (const auto [texture_width, texture_height] : {std::array{8192, 3}, std::array{64, 8}, std::array{37, 5}}) {
        const std::vector<std::uint32_t> texels = random_texels(random, texture_width * texture_height);
        for (const auto [width, step] : cases)
            for (int round = 0; round < 8; ++round) {
                const double from             = random.chance(50) ? 0.25 * random.from(0, 4 * texture_width)
                                                                  : random.real(-2.0f, static_cast<float>(texture_width));
                Draw draw                     = textured_draw(texels, texture_width, texture_height);
                draw.state.samplers[0].linear = round % 4 != 3;
                draw.state.samplers[0].rule =
                    random.one_of({FilterRule::Single8, FilterRule::Single8, FilterRule::Single4, FilterRule::Single7,
                                   FilterRule::Cascade8, FilterRule::Cascade4});
                draw.rectangles = {blit(random.chance(50) ? 0.0f : static_cast<float>(random.from(0, 9)), width, 5,
                                        from, step, texture_width)};
                Image wanted(80, 5);
                PassFill pass{.color = &wanted, .scissor = wanted.bounds(), .draws = {draw}};
                const FillCounts counts = reference_fill_pass(pass);
                INFO("step " << step << " from " << from << ", texture " << texture_width << " wide");
                test_support::for_each_simd_target([&] {
                    Image got(80, 5);
                    pass.color = &got;
                    CHECK(fill_pass(pass) == counts);
                    CHECK(same(got, wanted));
                });
            }
    }
}

// By all that a window of texels may hang over its texture, and at positions that are almost those for which there is one.
TEST_CASE("pictures laid over one another are those of the reference", "[raster][agreement]") {
    constexpr int kWidth = 150, kHeight = 40;  // three tiles by two
    test_support::Random random(11);
    const std::vector<std::uint32_t> pixels = random_texels(random, kWidth * kHeight);
    for (int round = 0; round < 1000; ++round) {
        const bool linear = random.chance(70);
        const int scale   = linear && random.chance(50) ? 2 : 1;
        // In pixels of the target, with up to two texels too few or too many on each side.
        const int x = random.from(0, 40), y = random.from(0, 9), width = random.from(1, kWidth - x),
                  height = random.from(1, kHeight - y);
        const double u = random.from(-4, 6) / 2.0, v = random.from(-4, 6) / 2.0;
        const int texture_width  = std::max(1, scale * width + random.from(-2, 6)),
                  texture_height = std::max(1, scale * height + random.from(-2, 6));
        // In texels, from side to side: so little that it begins to show between two tiles, blocks or lanes.
        const auto slip          = [&] {
            return random.chance(30) ? random.one_of({0.005f, 0.02f}) * random.real(-1.0f, 1.0f) : 0.0f;
        };
        const std::vector<std::uint32_t> texels = random_texels(random, texture_width * texture_height);
        Draw draw                               = textured_draw(texels, texture_width, texture_height);
        draw.state.samplers[0].linear           = linear;
        if (!linear && random.chance(50)) {
            draw.state.blend.source = special::kSourceAlpha;
            draw.state.blend.dest   = special::kInvSourceAlpha;
        }
        const auto part = [](double texel, int size) { return static_cast<float>(texel / size); };
        draw.rectangles = {
            {.x0 = static_cast<float>(x),
             .y0 = static_cast<float>(y),
             .x1 = static_cast<float>(x + width),
             .y1 = static_cast<float>(y + height),
             .uv = {{{part(u, texture_width), part(v, texture_height), part(u + scale * width + slip(), texture_width),
                      part(v + scale * height + slip(), texture_height)}}}}};
        const auto drawn = [&](auto fill) {
            Image image(kWidth, kHeight);
            for (int row = 0; row < kHeight; ++row) std::copy_n(pixels.begin() + row * kWidth, kWidth, image.row(row));
            fill(PassFill{.color = &image, .scissor = image.bounds(), .draws = {draw}});
            return image;
        };
        const Image wanted = drawn(&reference_fill_pass);
        INFO("round " << round << ", texture " << texture_width << " x " << texture_height << " for " << width << " x "
                      << height << " pixels from " << u << ", " << v << " on" << (linear ? ", linear" : ""));
        test_support::for_each_simd_target(
            [&] { CHECK(same(drawn([](const PassFill& pass) { return fill_pass(pass); }), wanted)); });
    }

    // Modulo 2^16 the third of three rows reads the second texel after that of the first, but the one between them neither.
    const std::vector<std::uint32_t> texels = random_texels(random, 64 * 4);
    Draw draw                               = textured_draw(texels, 64, 4);
    draw.rectangles = {{.x1 = 64, .y1 = 3, .uv = {{{0, -16384.0f / 4, 1, (-16384.0f + 3 * 32769.0f) / 4}}}}};
    Image wanted(64, 3);
    reference_fill_pass({.color = &wanted, .scissor = wanted.bounds(), .draws = {draw}});
    CHECK(std::equal(wanted.row(2), wanted.row(2) + 64, texels.data() + 2 * 64));
    test_support::for_each_simd_target([&] {
        Image got(64, 3);
        fill_pass({.color = &got, .scissor = got.bounds(), .draws = {draw}});
        CHECK(same(got, wanted));
    });
}
