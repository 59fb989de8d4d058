// SPDX-License-Identifier: MIT
// How the oracle weighs texels and mixes levels by each filter rule: numbers worked out by hand.
#include <array>
#include <catch2/catch.hpp>

#include "raster/reference.h"
#include "tests/raster/reference_scene.h"

using namespace raster;
using namespace reference_scene;

namespace {

constexpr std::array<FilterRule, 5> kRules = {FilterRule::Single8, FilterRule::Single4, FilterRule::Single7,
                                              FilterRule::Cascade8, FilterRule::Cascade4};

// Two by two grey texels, in rows, read at fractions fu, fv in 1/256 between them.
std::uint32_t filtered(FilterRule rule, const std::array<int, 4>& texels, int fu, int fv) {
    Texture texture(2, 2, [&](int x, int y) { return grey(texels[static_cast<std::size_t>(2 * y + x)]); });
    texture.sampler.linear    = true;
    texture.sampler.rule      = rule;
    texture.sampler.address_u = texture.sampler.address_v = Address::Clamp;
    const float u = static_cast<float>(128 + fu) / 512, v = static_cast<float>(128 + fv) / 512;
    Rectangle r = rectangle(0, 0, 1, 1);
    r.uv[0]     = {u, v, u, v};
    Canvas canvas(1, 1);
    canvas.draw(texture_only(texture), r);
    return canvas.at(0, 0);
}

}  // namespace

TEST_CASE("Each filter rule's weights, with known answers", "[reference]") {
    struct Row {
        std::array<int, 4> texels;
        int fu, fv;
        std::array<int, 5> expected;  // in the order of kRules
    };
    const std::array<Row, 13> rows = {{
        {{10, 20, 30, 41}, 0, 0, {10, 10, 10, 10, 10}},
        // 25.25; rows 15 and 35.5
        {{10, 20, 30, 41}, 128, 128, {25, 25, 25, 26, 25}},
        {{0, 3, 0, 3}, 128, 0, {2, 2, 1, 2, 1}},  // 1.5
        // Weights are cut to 16ths and 128ths: 1/256 is 0, 3/256 is 0 or 1/128, 255/256 is 15/16 or 127/128.
        {{0, 255, 0, 255}, 1, 0, {1, 0, 0, 1, 0}},
        {{0, 255, 0, 255}, 3, 0, {3, 0, 1, 3, 0}},              // 2.99; 1.99
        {{0, 255, 0, 255}, 255, 0, {254, 239, 253, 254, 239}},  // 254.004; 239.06; 253.008
        {{0, 0, 255, 255}, 0, 255, {254, 239, 253, 254, 239}},
        // Roundings that add up: 0.75 as rows 0.5 and 1; 0.25 as 0 and 0.5.
        {{0, 1, 1, 1}, 128, 128, {1, 1, 0, 1, 0}},
        {{0, 0, 0, 1}, 128, 128, {0, 0, 0, 1, 0}},
        // Along u first: 2.5 is 3, and an eighth of it 0.375; the other way round, 0.625 is 1, and half of it 1.
        {{0, 0, 5, 0}, 128, 32, {0, 0, 0, 0, 0}},
        // Along u first: 2.25 is 2, and half of it 1; the other way round, 1.5 is 1, and three quarters of it 0.
        {{0, 0, 3, 0}, 64, 128, {1, 1, 1, 1, 1}},
        {{255, 255, 255, 255}, 85, 170, {255, 255, 255, 255, 255}},
        // 200 + 55 * 0.75 = 241.25 and 100 - 100 * 0.75 = 25, mixed 187.19; of 241 and 25, 187.
        {{200, 255, 100, 0}, 192, 64, {187, 187, 187, 187, 187}},
    }};
    for (const Row& row : rows) {
        for (std::size_t i = 0; i < kRules.size(); ++i) {
            CAPTURE(row.texels, row.fu, row.fv, i);
            CHECK(filtered(kRules[i], row.texels, row.fu, row.fv) == grey(row.expected[i]));
        }
    }
}

TEST_CASE("A colour stays itself between four alike, and between two levels, by every rule", "[reference]") {
    const FilterRule rule = GENERATE(from_range(kRules));
    for (int byte = 0; byte < 256; byte += 3)
        for (int f = 0; f < 256; f += 15) CHECK(filtered(rule, {byte, byte, byte, byte}, f, 255 - f) == grey(byte));

    Texture levels(4, 4, [](int, int) { return 0x01fe807fu; });
    levels.add_level(2, 2, [](int, int) { return 0x01fe807fu; });
    levels.sampler.mip    = MipFilter::Linear;
    levels.sampler.rule   = rule;
    levels.sampler.linear = GENERATE(false, true);
    Rectangle r           = rectangle(0, 0, 16, 16);
    r.uv[0]               = {0, 0, 5, 7};
    Canvas canvas(16, 16);
    canvas.draw(texture_only(levels), r);
    CHECK(canvas.at(3, 3) == 0x01fe807f);
}

TEST_CASE("Levels are mixed by each rule, with known answers", "[reference]") {
    Texture two(4, 4, [](int, int) { return 0u; });
    two.add_level(2, 2, [](int, int) { return kWhite; });
    two.sampler.mip    = MipFilter::Linear;
    two.sampler.linear = GENERATE(false, true);
    Canvas canvas(16, 16);
    for (FilterRule rule : kRules) {
        CAPTURE(static_cast<int>(rule));
        two.sampler.rule = rule;
        const bool fine  = rule == FilterRule::Single8 || rule == FilterRule::Cascade8;
        // 5 over 4 texels a pixel: 1.25 squared is 1 + 9/16, a level of 9/32 or 72/256. 255 * 72/256 = 71.7; 72/256 is
        // 4/16 and a bit, and 255 * 4/16 = 63.75.
        Rectangle r      = rectangle(0, 0, 16, 16);
        r.uv[0]          = {0, 0, 5, 4};
        canvas.draw(texture_only(two), r);
        CHECK(canvas.at(3, 3) == grey(fine ? 72 : 63));
        // 8 over 4 is the second level, and there is no third.
        r.uv[0] = {0, 0, 8, 4};
        canvas.draw(texture_only(two), r);
        CHECK(canvas.at(3, 3) == kWhite);
    }
}
