// SPDX-License-Identifier: MIT
// Where the oracle samples a pixel, and how corners snap: coverage, colour, depth and texels on pixel grids other than
// that of pixels' centres.
#include <catch2/catch.hpp>

#include "raster/reference.h"
#include "raster/reference_plane.h"
#include "tests/raster/reference_scene.h"

using namespace raster;
using namespace reference_scene;

namespace {

int hash(int x, int y) {
    return (x * 73 + y * 151 + x * y * 31) & 255;
}

}  // namespace

TEST_CASE("Coordinates snap to sixteenths", "[reference]") {
    struct Row {
        float sixteenths;
        int nearest, truncated;
    };
    for (const Row& row : {Row{0.0f, 0, 0}, Row{7.25f, 7, 7}, Row{8.5f, 8, 8}, Row{9.5f, 10, 9}, Row{9.9375f, 10, 9},
                           Row{-0.75f, -1, 0}, Row{-8.5f, -8, -8}, Row{-9.5f, -10, -9}, Row{-9.9375f, -10, -9},
                           Row{262144.0f, 262144, 262144}, Row{-262144.0f, -262144, -262144}}) {
        CAPTURE(row.sixteenths);
        CHECK(reference::snap({8, false}, row.sixteenths / 16) == row.nearest);
        CHECK(reference::snap({8, true}, row.sixteenths / 16) == row.truncated);
    }
}

TEST_CASE("A pixel is sampled where the grid says", "[reference]") {
    const int center = GENERATE(0, 7, 8, 9, 15);
    const auto c     = static_cast<float>(center) / 16;
    CAPTURE(center);
    Canvas canvas(4, 4);
    canvas.grid = {center, false};
    SECTION("by rectangles") {
        // Left and top edges through sample points are inside, right and bottom edges are not.
        CHECK(canvas.draw({}, rectangle(1 + c, 1 + c, 3 + c, 2 + c)).covered == 2);
        CHECK(canvas.at(1, 1) == kWhite);
        CHECK(canvas.at(2, 1) == kWhite);
        const float bit = 1.0f / 16;
        CHECK(canvas.draw({}, rectangle(1 + c + bit, 1 + c, 3 + c + bit, 2 + c)).covered == 2);
        CHECK(canvas.at(3, 1) == kWhite);
        CHECK(canvas.draw({}, rectangle(1 + c, 1 + c + bit, 2 + c, 2 + c)).covered == 0);
    }
    SECTION("by triangles") {
        CHECK(canvas.draw({}, {triangle({{{1 + c, 1 + c}, {3 + c, 1 + c}, {1 + c, 3 + c}}})}).covered == 3);
        CHECK(canvas.at(1, 1) == kWhite);
        CHECK(canvas.at(2, 1) == kWhite);
        CHECK(canvas.at(1, 2) == kWhite);
    }
    SECTION("which is where colours and depth are taken") {
        // Blue falls from 200 by 32 a pixel to the right, green rises from 1 by 48 a pixel down; depth as blue.
        const auto corner = [&](int x, int y) {
            return vertex(static_cast<float>(x) + c, static_cast<float>(y) + c,
                          static_cast<std::uint32_t>((1 + 48 * y) << 8 | (200 - 32 * x)),
                          static_cast<float>(4 - x) / 4);
        };
        FillState state;
        state.depth_write  = true;
        state.floor_colors = GENERATE(false, true);
        canvas.draw(state, {{corner(0, 0), corner(4, 0), corner(0, 4)}}, {}, 16);
        for (int y = 0; y < 4; ++y) {
            for (int x = 0; x + y < 4; ++x) {
                CHECK(canvas.at(x, y) == static_cast<std::uint32_t>((1 + 48 * y) << 8 | (200 - 32 * x)));
                CHECK(canvas.depth.row(y)[x] == static_cast<std::uint32_t>(0x3fffffffll * (4 - x) / 4 >> 14));
            }
        }
    }
}

TEST_CASE("Pixels sampled at their corner read textures there", "[reference]") {
    constexpr int kSize = 32;
    Texture texture(kSize, kSize, [](int x, int y) { return grey(hash(x, y)); });
    texture.sampler.address_u = texture.sampler.address_v = Address::Clamp;
    texture.sampler.rule                                  = FilterRule::Cascade4;
    texture.sampler.linear                                = GENERATE(false, true);
    // Texels u0 + k * x, likewise v, at pixel (x, y).
    const auto drawn                                      = [&](float u0, float k, bool triangles) {
        Canvas canvas(kSize, kSize);
        canvas.grid       = {0, true};
        const float start = u0 / kSize, end = (u0 + 64 * k) / kSize;
        Rectangle r = rectangle(0, 0, 64, 64);
        r.uv[0]     = {start, start, end, end};
        Triangle t  = {vertex(0, 0), vertex(64, 0), vertex(0, 64)};
        t[0].uv[0]  = {start, start, 1};
        t[1].uv[0]  = {end, start, 1};
        t[2].uv[0]  = {start, end, 1};
        if (triangles)
            canvas.draw(texture_only(texture), {t});
        else
            canvas.draw(texture_only(texture), r);
        return canvas;
    };
    const bool triangles = GENERATE(false, true);

    SECTION("half a texel on, a copy is exact") {
        const Canvas canvas = drawn(0.5f, 1, triangles);
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x)
                if (x + y < kSize) CHECK(canvas.at(x, y) == grey(hash(x, y)));
    }
    SECTION("at texel corners, a halved picture is the mean of two by two, rounded down twice") {
        const Canvas canvas = drawn(1, 2, triangles);
        for (int y = 0; y < kSize / 2; ++y) {
            for (int x = 0; x < kSize / 2; ++x) {
                const int above = (hash(2 * x, 2 * y) + hash(2 * x + 1, 2 * y)) / 2;
                const int below = (hash(2 * x, 2 * y + 1) + hash(2 * x + 1, 2 * y + 1)) / 2;
                const int point = hash(2 * x + 1, 2 * y + 1);
                CHECK(canvas.at(x, y) == grey(texture.sampler.linear ? (above + below) / 2 : point));
            }
        }
    }
    SECTION("from texel 0 on, the halved picture is shifted by a texel") {
        const Canvas canvas = drawn(0, 2, triangles);
        for (int y = 1; y < kSize / 2; ++y) {
            for (int x = 1; x < kSize / 2; ++x) {
                const int above = (hash(2 * x - 1, 2 * y - 1) + hash(2 * x, 2 * y - 1)) / 2;
                const int below = (hash(2 * x - 1, 2 * y) + hash(2 * x, 2 * y)) / 2;
                CHECK(canvas.at(x, y) == grey(texture.sampler.linear ? (above + below) / 2 : hash(2 * x, 2 * y)));
            }
        }
    }
}

TEST_CASE("Texture coordinates of a rectangle start at its truncated edge", "[reference]") {
    // 32.9 sixteenths left of the target, or above it: 32 are whole pixels, 33 are not.
    Texture texture(16, 16, [](int x, int y) { return grey(hash(x, y)); });
    texture.sampler.linear = true;
    const bool across      = GENERATE(true, false);
    const auto drawn       = [&](bool truncate) {
        Canvas canvas(14, 14);
        canvas.grid = {8, truncate};
        Rectangle r = across ? rectangle(-32.9f / 16, 0, 14, 14) : rectangle(0, -32.9f / 16, 14, 14);
        (across ? r.uv[0].v1 : r.uv[0].u1) = 14.0f / 16;
        canvas.draw(texture_only(texture), r);
        int same = 0;
        for (int i = 0; i < 14; ++i) same += canvas.at(i, i) == grey(across ? hash(i + 2, i) : hash(i, i + 2));
        return same;
    };
    CHECK(drawn(true) == 14);
    CHECK(drawn(false) < 14);
}
