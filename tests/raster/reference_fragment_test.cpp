// SPDX-License-Identifier: MIT
// Which fragments the oracle keeps, what those that failed the alpha test still write, and how all are counted.
#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>

#include "raster/reference.h"
#include "tests/raster/reference_scene.h"

using namespace raster;
using namespace reference_scene;

TEST_CASE("Alpha and depth tests keep a fragment if it compares so to the reference", "[reference]") {
    struct Row {
        Compare func;
        bool below, same, above;
    };
    const Row row = GENERATE(Row{Compare::Always, true, true, true}, Row{Compare::LessEqual, true, true, false},
                             Row{Compare::Less, true, false, false}, Row{Compare::GreaterEqual, false, true, true},
                             Row{Compare::Greater, false, false, true}, Row{Compare::Equal, false, true, false},
                             Row{Compare::NotEqual, true, false, true}, Row{Compare::Never, false, false, false});
    const std::array<bool, 3> passes = {row.below, row.same, row.above};
    for (int i = 0; i < 3; ++i) {
        FillState alpha;
        alpha.alpha_func      = row.func;
        alpha.alpha_reference = 100;
        alpha.depth_write     = true;
        Canvas canvas(2, 1);
        const auto color  = static_cast<std::uint32_t>(99 + i) << 24 | 0x123456;
        FillCounts counts = canvas.draw(alpha, rectangle(0, 0, 2, 1, color, 1.0f));
        CHECK(counts == (passes[i] ? FillCounts{2, 2, 2, 2, 2} : FillCounts{2}));
        CHECK(canvas.at(1, 0) == (passes[i] ? color : 0));
        CHECK(canvas.depth.row(0)[1] == (passes[i] ? 0xffffff : 0));

        FillState depth;
        depth.depth_func                    = row.func;
        canvas.color.row(0)[0]              = 0;
        const std::array<float, 3> fragment = {0.25f, 0.5f, 0.75f};
        for (bool write : {false, true}) {
            depth.depth_write      = write;
            canvas.depth.row(0)[0] = 1 << 23;  // what 0.5 is in 24 bits
            counts                 = canvas.draw(depth, rectangle(0, 0, 1, 1, color, fragment[i]));
            CHECK(counts == (passes[i] ? FillCounts{1, 1, 1, write ? 1u : 0u, 1} : FillCounts{1, 1}));
            CHECK(canvas.at(0, 0) == (passes[i] ? color : 0));
            const std::array<std::uint32_t, 3> written = {1 << 22, 1 << 23, 3 << 22};
            const bool wrote                           = write && passes[i];
            CHECK(std::abs(static_cast<int>(canvas.depth.row(0)[0]) -
                           static_cast<int>(wrote ? written[i] : 1u << 23)) <= (wrote ? 1 : 0));
        }
    }
}

TEST_CASE("A fragment that fails the alpha test writes what alpha_fail leaves to it", "[reference]") {
    struct Row {
        AlphaFail fail;
        std::uint32_t mask, color;
        bool depth;
        FillCounts counts;
    };
    // 0x11223344 over 0xaabbccdd.
    const Row row = GENERATE(Row{AlphaFail::Keep, 0xffffffff, 0xaabbccdd, false, {1}},
                             Row{AlphaFail::ColorOnly, 0xffffffff, 0x11223344, false, {1, 1, 1, 0, 1}},
                             Row{AlphaFail::ColorOnly, 0, 0xaabbccdd, false, {1, 1, 1, 0, 0}},
                             Row{AlphaFail::DepthOnly, 0xffffffff, 0xaabbccdd, true, {1, 1, 1, 1, 0}},
                             Row{AlphaFail::RgbOnly, 0xffffffff, 0xaa223344, false, {1, 1, 1, 0, 1}},
                             Row{AlphaFail::RgbOnly, 0xff0000ff, 0xaabbcc44, false, {1, 1, 1, 0, 1}},
                             Row{AlphaFail::RgbOnly, 0xff000000, 0xaabbccdd, false, {1, 1, 1, 0, 0}});
    FillState state;
    state.alpha_func       = Compare::GreaterEqual;
    state.alpha_reference  = 0x12;
    state.alpha_fail       = row.fail;
    state.depth_write      = true;
    state.blend.write_mask = row.mask;
    Canvas canvas(1, 1);
    canvas.color.row(0)[0] = 0xaabbccdd;
    CAPTURE(static_cast<int>(row.fail), row.mask);

    SECTION("and the other tests pass") {
        CHECK(canvas.draw(state, rectangle(0, 0, 1, 1, 0x11223344, 1.0f)) == row.counts);
        CHECK(canvas.at(0, 0) == row.color);
        CHECK(canvas.depth.row(0)[0] == (row.depth ? 0xffffff : 0));
    }
    SECTION("and nothing where the depth test fails") {
        state.depth_func = Compare::Less;
        const bool keeps = row.fail != AlphaFail::Keep;
        CHECK(canvas.draw(state, rectangle(0, 0, 1, 1, 0x11223344, 1.0f)) == FillCounts{1, keeps ? 1u : 0u});
        CHECK(canvas.at(0, 0) == 0xaabbccdd);
        CHECK(canvas.depth.row(0)[0] == 0);
    }
    SECTION("and nothing where the alpha already there is not asked for") {
        state.dest_alpha_test          = DestAlphaTest::Zero;
        const std::uint64_t any_tested = row.fail != AlphaFail::Keep ? 1 : 0;
        CHECK(canvas.draw(state, rectangle(0, 0, 1, 1, 0x11223344, 1.0f)) ==
              FillCounts{1, 0, 0, 0, 0, 0, 0, any_tested});
        CHECK(canvas.at(0, 0) == 0xaabbccdd);
        CHECK(canvas.depth.row(0)[0] == 0);
    }
    SECTION("which says nothing of a fragment that passes") {
        state.alpha_reference         = 0x11;
        const std::uint64_t any_color = row.mask != 0 ? 1 : 0;
        CHECK(canvas.draw(state, rectangle(0, 0, 1, 1, 0x11223344, 1.0f)) == FillCounts{1, 1, 1, 1, any_color});
        CHECK(canvas.at(0, 0) == ((0x11223344 & row.mask) | (0xaabbccdd & ~row.mask)));
        CHECK(canvas.depth.row(0)[0] == 0xffffff);
    }
}

TEST_CASE("The destination alpha test asks for bit 7 of the alpha already there", "[reference]") {
    struct Row {
        DestAlphaTest test;
        bool below, above;
    };
    const Row row = GENERATE(Row{DestAlphaTest::Off, true, true}, Row{DestAlphaTest::Zero, true, false},
                             Row{DestAlphaTest::One, false, true});
    FillState state;
    state.dest_alpha_test = row.test;
    state.depth_write     = true;
    for (std::uint32_t alpha : {0x00u, 0x7fu, 0x80u, 0xffu}) {
        Canvas canvas(1, 1);
        canvas.color.row(0)[0]   = alpha << 24 | 0x808080;
        const bool passes        = alpha < 0x80 ? row.below : row.above;
        FillCounts counts        = passes ? FillCounts{1, 1, 1, 1, 1} : FillCounts{1};
        counts.dest_alpha_tested = row.test == DestAlphaTest::Off ? 0 : 1;
        CHECK(canvas.draw(state, rectangle(0, 0, 1, 1, 0x40123456, 1.0f)) == counts);
        CHECK(canvas.at(0, 0) == (passes ? 0x40123456 : alpha << 24 | 0x808080));
        CHECK(canvas.depth.row(0)[0] == (passes ? 0xffffff : 0));
    }
}

TEST_CASE("Each fragment meets the alpha that the one before it left", "[reference]") {
    // As a stencil: the first sets bit 7, which keeps the second away.
    FillState state;
    state.dest_alpha_test = DestAlphaTest::Zero;
    Canvas canvas(2, 1);
    const FillCounts counts =
        canvas.draw(state, {}, {rectangle(0, 0, 1, 1, 0x80111111), rectangle(0, 0, 2, 1, 0xff222222)});
    CHECK(counts == FillCounts{3, 2, 2, 0, 2, 0, 0, 3});
    CHECK(canvas.at(0, 0) == 0x80111111);
    CHECK(canvas.at(1, 0) == 0xff222222);
}

TEST_CASE("A target with one bit of alpha is asked for that bit", "[reference]") {
    FillState state;
    state.dest_alpha_test = DestAlphaTest::One;
    Canvas canvas(2, 1);
    canvas.format = {5, 5, 5, 1, true};
    canvas.draw({}, {}, {rectangle(0, 0, 1, 1, 0xc0000000), rectangle(1, 0, 2, 1, 0x7f000000)});
    CHECK(canvas.at(0, 0) == 0x80000000);
    CHECK(canvas.at(1, 0) == 0);
    CHECK(canvas.draw(state, rectangle(0, 0, 2, 1, 0xffffffff)).color_written == 1);
    CHECK(canvas.at(0, 0) == 0x80f8f8f8);
    CHECK(canvas.at(1, 0) == 0);
}
