// SPDX-License-Identifier: MIT
// Blits against the reference: the steps for which texels come from contiguous loads, those next to them, and those
// at which coordinates wrap within a block.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <vector>

#include "raster/fill_pass.h"
#include "raster/reference.h"
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
                const double from = random.chance(50) ? 0.25 * random.from(0, 4 * texture_width)
                                                      : random.real(-2.0f, static_cast<float>(texture_width));
                Draw draw;
                draw.state.stage_count     = 1;
                draw.state.stages[0].color = {CombineOp::Select, {.source = CombineArg::Source::Texel}, {}, {}};
                draw.state.stages[0].alpha = draw.state.stages[0].color;
                draw.state.samplers[0]     = {
                        .levels    = {{texels.data(), texture_width, texture_height, texture_width}},
                        .linear    = round % 4 != 3,
                        .rule      = random.one_of({FilterRule::Single8, FilterRule::Single8, FilterRule::Single4,
                                                    FilterRule::Single7, FilterRule::Cascade8, FilterRule::Cascade4}),
                        .address_u = Address::Clamp,
                        .address_v = Address::Clamp};
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
