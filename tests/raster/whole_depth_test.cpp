// SPDX-License-Identifier: MIT
// The oracle's depth at corners that are cut to whole units of the format, with known answers.
#include <catch2/catch.hpp>

#include "tests/raster/reference_scene.h"

using namespace raster;
using namespace reference_scene;

namespace {

// Of a depth of n units and a fraction of one, in a format of `bits` bits.
float depth_of(double units, int bits) {
    return static_cast<float>((units * static_cast<double>(1 << (kDepthBits - bits))) / ((1 << kDepthBits) - 1));
}

// The stored depths of the four pixels of a row, over which a triangle runs from `left` at x = 0 to `right` at x = 4 units.
std::array<std::uint32_t, 4> row(double left, double right, bool whole, int bits = 16) {
    FillState state;
    state.whole_depth = whole;
    state.depth_write = true;
    Canvas canvas(4, 1);
    const float z0 = depth_of(left, bits), z1 = depth_of(right, bits);
    canvas.draw(state,
                {{vertex(0, 0, kWhite, z0), vertex(4, 0, kWhite, z1), vertex(4, 1, kWhite, z1)},
                 {vertex(0, 0, kWhite, z0), vertex(4, 1, kWhite, z1), vertex(0, 1, kWhite, z0)}},
                {}, bits);
    return {canvas.depth.row(0)[0], canvas.depth.row(0)[1], canvas.depth.row(0)[2], canvas.depth.row(0)[3]};
}
using Depths = std::array<std::uint32_t, 4>;

}  // namespace

TEST_CASE("Whole depth is what corners have, rounded down, whatever lies between", "[reference]") {
    CHECK(row(100.75, 100.75, true) == Depths{100, 100, 100, 100});
    CHECK(row(100.75, 100.75, false) == Depths{100, 100, 100, 100});
    // 100.75 .. 104.75 is 101.25, 102.25, ... at the centres; from whole corners 100.5, 101.5, ...
    CHECK(row(100.75, 104.75, false) == Depths{101, 102, 103, 104});
    CHECK(row(100.75, 104.75, true) == Depths{100, 101, 102, 103});
    // To the right by 1.5 units, of which whole corners make 1 or 2.
    CHECK(row(100.5, 102.0, true) == Depths{100, 100, 101, 101});     // 100.25, 100.75, 101.25, 101.75
    CHECK(row(100.25, 101.75, true) == Depths{100, 100, 100, 100});   // 100.125 .. 100.875
    CHECK(row(100.25, 101.75, false) == Depths{100, 100, 101, 101});  // 100.4375, 100.8125, 101.1875, 101.5625
}

TEST_CASE("Whole depth has the units of each format, up to the bits that depth has at all", "[reference]") {
    CHECK(row(1000.75, 1004.75, true, 24) == Depths{1000, 1001, 1002, 1003});
    CHECK(row(1000.75, 1004.75, false, 24) == Depths{1001, 1002, 1003, 1004});
    // 32 bits have more than 30, so that nothing is cut.
    const auto row32 = [](bool whole) {
        FillState state;
        state.whole_depth = whole;
        state.depth_write = true;
        Canvas canvas(2, 1);
        canvas.draw(state, {{vertex(0, 0, kWhite, 0.3f), vertex(4, 0, kWhite, 0.7f), vertex(0, 2, kWhite, 0.9f)}}, {},
                    32);
        return std::array<std::uint32_t, 2>{canvas.depth.row(0)[0], canvas.depth.row(0)[1]};
    };
    CHECK(row32(true) == row32(false));
    CHECK(row32(true)[0] != 0);
}

TEST_CASE("Whole depth changes triangles alone, and nothing at the ends", "[reference]") {
    CHECK(row(0.0, 0.0, true) == Depths{0, 0, 0, 0});
    CHECK(row(65535.9999, 65535.9999, true) == Depths{65535, 65535, 65535, 65535});
    FillState state;
    state.whole_depth = true;
    state.depth_write = true;
    Canvas canvas(1, 1);
    canvas.draw(state, rectangle(0, 0, 1, 1, kWhite, depth_of(100.75, 16)), 16);
    CHECK(canvas.depth.row(0)[0] == 100);
    // A test sees what is stored: 100.75 equals 100.25.
    FillState test;
    test.whole_depth = true;
    test.depth_func  = Compare::Equal;
    canvas.draw(test,
                {{vertex(0, 0, 0xff000001, depth_of(100.25, 16)), vertex(4, 0, 0xff000001, depth_of(100.25, 16)),
                  vertex(0, 4, 0xff000001, depth_of(100.25, 16))}},
                {}, 16);
    CHECK(canvas.at(0, 0) == 0xff000001);
}
