// SPDX-License-Identifier: MIT
// Which pixels the oracle covers, and the depth and colour it gives to them: answers known without it.
#include "raster/reference.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <utility>

#include "tests/raster/reference_scene.h"

using namespace raster;
using namespace reference_scene;

namespace {

int drawn_pixels(const Image& image, std::uint32_t color) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        count += static_cast<int>(std::count(image.row(y), image.row(y) + image.width(), color));
    return count;
}

// A whole number of subpixels, in pixels.
float subpixels(int count) {
    return static_cast<float>(count) / 16.0f;
}

// Triangles around a random point of a rectangle of 320 x 208 subpixels at (x, y), to random points on its outline.
// Each goes either way round.
std::vector<Triangle> random_fan(std::mt19937& random, int x, int y) {
    constexpr int kWidth = 320, kHeight = 208;
    std::vector<std::array<int, 2>> outline;
    const auto add_side = [&](std::array<int, 2> from, std::array<int, 2> to) {
        outline.push_back(from);
        const int length = std::abs(to[0] - from[0]) + std::abs(to[1] - from[1]);
        std::array<int, 2> stops{};
        for (int& stop : stops) stop = static_cast<int>(random() % (length + 1));
        std::sort(stops.begin(), stops.end());
        for (int stop : stops)
            outline.push_back(
                {from[0] + (to[0] - from[0]) * stop / length, from[1] + (to[1] - from[1]) * stop / length});
    };
    add_side({0, 0}, {kWidth, 0});
    add_side({kWidth, 0}, {kWidth, kHeight});
    add_side({kWidth, kHeight}, {0, kHeight});
    add_side({0, kHeight}, {0, 0});

    const int hub_x = static_cast<int>(random() % (kWidth + 1)), hub_y = static_cast<int>(random() % (kHeight + 1));
    std::vector<Triangle> fan;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const auto& a = outline[i];
        const auto& b = outline[(i + 1) % outline.size()];
        Triangle t    = {vertex(subpixels(x + hub_x), subpixels(y + hub_y), 0x01010101),
                         vertex(subpixels(x + a[0]), subpixels(y + a[1]), 0x01010101),
                         vertex(subpixels(x + b[0]), subpixels(y + b[1]), 0x01010101)};
        std::shuffle(t.begin(), t.end(), random);
        fan.push_back(t);
    }
    return fan;
}

}  // namespace

TEST_CASE("Edges through pixel centres belong to the top and the left", "[reference]") {
    // The example of the Direct3D manuals, whose pixel centres are at whole numbers, moved by half a pixel.
    SECTION("a rectangle of 5 by 5 covers 25 pixels") {
        Canvas canvas(8, 8);
        const FillCounts counts = canvas.draw({}, rectangle(0.5f, 0.5f, 5.5f, 5.5f));
        CHECK(counts.covered == 25);
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x) CHECK(canvas.at(x, y) == (x < 5 && y < 5 ? kWhite : 0));
    }
    SECTION("its two triangles cover 15 and 10") {
        Canvas canvas(8, 8);
        CHECK(canvas.draw(additive(), {triangle({{{0.5f, 0.5f}, {5.5f, 0.5f}, {5.5f, 5.5f}}}, 0x01010101)}).covered ==
              15);
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x) CHECK(canvas.at(x, y) == (y <= x && x < 5 ? 0x01010101 : 0));
        CHECK(canvas.draw(additive(), {triangle({{{0.5f, 5.5f}, {0.5f, 0.5f}, {5.5f, 5.5f}}}, 0x01010101)}).covered ==
              10);
        CHECK(drawn_pixels(canvas.color, 0x01010101) == 25);
    }
    SECTION("the other way round, they cover the same pixels") {
        Canvas canvas(8, 8);
        CHECK(canvas.draw({}, {triangle({{{0.5f, 0.5f}, {5.5f, 5.5f}, {5.5f, 0.5f}}})}).covered == 15);
        CHECK(canvas.draw({}, {triangle({{{0.5f, 5.5f}, {5.5f, 5.5f}, {0.5f, 0.5f}}})}).covered == 10);
    }
    SECTION("a lone corner at a centre is covered only where a top and a left edge meet") {
        Canvas canvas(3, 3);
        CHECK(canvas.draw({}, {triangle({{{1.5f, 1.5f}, {1.75f, 1.5f}, {1.5f, 1.75f}}})}).covered == 1);
        CHECK(canvas.draw({}, {triangle({{{1.5f, 1.5f}, {1.25f, 1.5f}, {1.5f, 1.25f}}})}).covered == 0);
        CHECK(canvas.draw({}, {triangle({{{1.5f, 1.5f}, {1.75f, 1.5f}, {1.5f, 1.25f}}})}).covered == 0);
        CHECK(canvas.draw({}, {triangle({{{1.5f, 1.5f}, {1.25f, 1.5f}, {1.5f, 1.75f}}})}).covered == 0);
    }
}

TEST_CASE("Coordinates snap before a pixel is covered", "[reference]") {
    const auto covers_centre_from = [](float x0) {
        Canvas canvas(1, 1);
        return canvas.draw({}, rectangle(x0, 0.0f, 2.0f, 1.0f)).covered == 1;
    };
    CHECK(covers_centre_from(0.5f));
    CHECK(covers_centre_from(0.5f + 1.0f / 32));        // 8.5 sixteenths, to 8
    CHECK_FALSE(covers_centre_from(0.5f + 1.1f / 32));  // to 9
    CHECK_FALSE(covers_centre_from(0.5f + 3.0f / 32));  // 9.5, to 10

    Canvas truncating(1, 1);
    truncating.grid = {8, true};
    CHECK(truncating.draw({}, rectangle(0.5f + 1.9f / 32, 0.0f, 2.0f, 1.0f)).covered == 1);  // 8.95, to 8
    CHECK(truncating.draw({}, rectangle(0.5f + 2.0f / 32, 0.0f, 2.0f, 1.0f)).covered == 0);
    const float left = 0.5f + 1.9f / 32;
    CHECK(truncating.draw({}, {triangle({{{left, 0.5f}, {2.5f, 0.5f}, {left, 2.5f}}})}).covered == 1);
}

TEST_CASE("Triangles that share edges cover each pixel exactly once", "[reference]") {
    const PixelGrid grid = GENERATE(PixelGrid{}, PixelGrid{0, true}, PixelGrid{9, false}, PixelGrid{15, false});
    CAPTURE(grid.center);
    std::mt19937 random(7);
    for (int phase = 0; phase < 256; ++phase) {
        const int x = 16 + phase % 16, y = 16 + phase / 16;
        CAPTURE(x, y);
        Canvas fan(24, 17), outline(24, 17);
        fan.grid = outline.grid = grid;
        fan.draw(additive(), random_fan(random, x, y));
        outline.draw({}, rectangle(subpixels(x), subpixels(y), subpixels(x + 320), subpixels(y + 208), 0x01010101));
        bool equal = true;
        for (int row = 0; row < 17; ++row)
            equal = equal && std::equal(fan.color.row(row), fan.color.row(row) + 24, outline.color.row(row));
        CHECK(equal);
        CHECK(drawn_pixels(outline.color, 0x01010101) == 20 * 13);
    }
}

TEST_CASE("What has no area draws nothing", "[reference]") {
    Canvas canvas(16, 16);
    CHECK(canvas.draw({}, {triangle({{{1.5f, 1.5f}, {1.5f, 1.5f}, {9.5f, 9.5f}}}),
                           triangle({{{1.5f, 1.5f}, {5.5f, 5.5f}, {9.5f, 9.5f}}}),
                           triangle({{{3.5f, 2.5f}, {3.5f, 2.5f}, {3.5f, 2.5f}}}),
                           triangle({{{2.0f, 8.5f}, {14.0f, 8.5f}, {7.0f, 8.51f}}})}) == FillCounts{});
    CHECK(canvas.draw({}, {},
                      {rectangle(3, 3, 3, 9), rectangle(3, 9, 9, 9), rectangle(9, 3, 3, 9), rectangle(3, 9, 9, 3)}) ==
          FillCounts{});
    CHECK(drawn_pixels(canvas.color, 0) == 256);
}

TEST_CASE("Nothing is drawn outside the scissor", "[reference]") {
    Image color(40, 20);
    const Rect scissor{5, 3, 23, 11};
    Draw draw;
    add_triangles(draw, {triangle({{{-16384.0f, -16384.0f}, {16384.0f, -16384.0f}, {-16384.0f, 16384.0f}}}),
                         triangle({{{16384.0f, -16384.0f}, {16384.0f, 16384.0f}, {-16384.0f, 16384.0f}}})});
    const auto once = static_cast<std::uint64_t>((scissor.x1 - scissor.x0) * (scissor.y1 - scissor.y0));
    PassFill pass;
    pass.color   = &color;
    pass.scissor = scissor;
    pass.draws   = {draw};
    CHECK(reference_fill_pass(pass).covered == once);
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 40; ++x) CHECK(color.row(y)[x] == (x >= 5 && x < 23 && y >= 3 && y < 11 ? kWhite : 0));
}

TEST_CASE("Depth 0 and 1 are the least and the greatest value of every format", "[reference]") {
    const auto [bits, all_ones] =
        GENERATE(table<int, std::uint32_t>({{16, 0xffffu}, {24, 0xffffffu}, {32, 0xffffffffu}}));
    CAPTURE(bits);
    FillState state;
    state.depth_write = true;
    Canvas canvas(40, 8);
    for (auto& [z, expected] : {std::pair{1.0f, all_ones}, std::pair{0.0f, 0u}}) {
        canvas.draw(state, rectangle(0, 0, 40, 8, kWhite, z), bits);
        CHECK(drawn_pixels(canvas.depth, expected) == 320);
        canvas.draw(state, rectangle(0, 0, 40, 8, kWhite, 0.25f), bits);
        canvas.draw(state, {{vertex(-9, -9, kWhite, z), vertex(99, 0, kWhite, z), vertex(0, 99, kWhite, z)}}, {}, bits);
        CHECK(drawn_pixels(canvas.depth, expected) == 320);
    }
    // Half the range, rounded down to the format from 30 bits: 2^29 (a tie, to even).
    canvas.draw(state, rectangle(0, 0, 40, 8, kWhite, 0.5f), bits);
    const std::uint32_t half = (1u << (bits - 1)) + (bits == 32 ? 2 : 0);
    CHECK(canvas.depth.row(0)[0] == half);
}

TEST_CASE("Depth is a plane over the triangle", "[reference]") {
    FillState state;
    state.depth_write = true;
    Canvas canvas(128, 64);
    // z = x / 128 * 0.5 + y / 64 * 0.25 + 0.125, given at three corners outside the image.
    const auto z_at     = [](double x, double y) { return x / 256 + y / 256 + 0.125; };
    const auto corner   = [&](float x, float y) { return vertex(x, y, kWhite, static_cast<float>(z_at(x, y))); };
    const Triangle over = {corner(-16.0f, -8.0f), corner(160.0f, -8.0f), corner(-16.0f, 80.0f)};
    const auto covered  = canvas.draw(state, {over}, {}, 32).covered;
    std::uint64_t seen  = 0;
    double worst        = 0;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 128; ++x) {
            if (canvas.at(x, y) != kWhite) continue;
            ++seen;
            worst = std::max(worst, std::abs(canvas.depth.row(y)[x] - z_at(x + 0.5, y + 0.5) * 0xffffffffu));
        }
    }
    CHECK(seen == covered);
    CHECK(seen > 4000);
    // 8 of 30 bits for the rounded step, and less than 1 for everything else.
    CHECK(worst <= 4 * 9);
}

TEST_CASE("Depth and colour stay within their vertices on the thinnest triangles", "[reference]") {
    std::mt19937 random(11);
    FillState state;
    state.depth_write    = true;
    const auto in_format = [](float z) {
        const auto value = static_cast<std::uint32_t>(std::nearbyint(double{z} * 0x3fffffff));
        return value << 2 | value >> 28;
    };
    std::uint64_t covered = 0;
    for (int i = 0; i < 3000; ++i) {
        const auto near_line = [&random] { return static_cast<float>(static_cast<int>(random() % 8192) - 4096) / 16; };
        Triangle thin;
        const float slope = static_cast<float>(random() % 64) / 64;
        for (Vertex& v : thin) {
            v.x = near_line();
            v.y = std::nearbyint(v.x * slope * 16) / 16 + static_cast<float>(random() % 3) / 16 + 8;
            v.z = static_cast<float>(random() % 1024 + 512) / 2048;
        }
        thin[0].diffuse = 0x00ff0000;
        thin[1].diffuse = 0xff00ff00;
        thin[2].diffuse = 0x00ffff00;
        Canvas canvas(64, 48);
        covered += canvas.draw(state, {thin}, {}, 32).covered;
        const auto [least, greatest] = std::minmax({thin[0].z, thin[1].z, thin[2].z});
        for (int y = 0; y < 48; ++y) {
            for (int x = 0; x < 64; ++x) {
                if (canvas.depth.row(y)[x] == 0) continue;
                const std::uint32_t z = canvas.depth.row(y)[x];
                const bool in_range   = z >= in_format(least) && z <= in_format(greatest);
                // Blue is 0 at every vertex; red + green + ... would differ if a lane had wrapped around.
                const int red = channel(canvas.at(x, y), 2), green = channel(canvas.at(x, y), 1);
                if (!in_range || channel(canvas.at(x, y), 0) != 0 || red + green < 254) FAIL_CHECK(x << "," << y);
            }
        }
    }
    CHECK(covered > 2000);
}

TEST_CASE("Depth stays within its vertices where its step is rounded", "[reference]") {
    // Depths a float's last bit apart, 64 units of 30 bits: the rounded step is wrong by up to 8 at a block's end.
    std::mt19937 random(13);
    FillState state;
    state.depth_write = true;
    for (int i = 0; i < 200; ++i) {
        Triangle t;
        const bool upper = random() % 2 == 0;
        for (int k = 0; k < 3; ++k) {
            t[k]   = vertex(static_cast<float>(random() % 48) + 0.5f, static_cast<float>(random() % 32) + 0.5f);
            t[k].z = 0.75f + ((k == 0) == upper ? 0x1p-24f : 0.0f);
        }
        Canvas canvas(48, 32);
        canvas.draw(state, {t}, {}, 32);
        constexpr std::uint32_t kLeast = (3u << 28) - 1, kGreatest = kLeast + 64;
        int outside = 0;
        for (int y = 0; y < 32; ++y) {
            for (int x = 0; x < 48; ++x) {
                const std::uint32_t value = canvas.depth.row(y)[x] >> 2;
                if (canvas.at(x, y) == kWhite && (value < kLeast || value > kGreatest)) ++outside;
            }
        }
        CHECK(outside == 0);
    }
}

TEST_CASE("Gouraud colours lie on the plane of the vertices", "[reference]") {
    Canvas canvas(300, 200);
    const std::array<std::uint32_t, 3> colors         = {0xff0080ff, 0x00ff4020, 0x80c0ff00};
    const std::array<std::array<float, 2>, 3> corners = {{{10.5f, 20.5f}, {280.5f, 3.5f}, {100.5f, 190.5f}}};
    Triangle t;
    for (int i = 0; i < 3; ++i) t[i] = vertex(corners[i][0], corners[i][1], colors[i]);

    // Weights of the vertices at a pixel, in double precision.
    const auto weights = [&](double x, double y) {
        const auto area = [](double ax, double ay, double bx, double by, double cx, double cy) {
            return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
        };
        const auto& p      = corners;
        const double whole = area(p[0][0], p[0][1], p[1][0], p[1][1], p[2][0], p[2][1]);
        return std::array{area(x, y, p[1][0], p[1][1], p[2][0], p[2][1]) / whole,
                          area(p[0][0], p[0][1], x, y, p[2][0], p[2][1]) / whole,
                          area(p[0][0], p[0][1], p[1][0], p[1][1], x, y) / whole};
    };
    canvas.draw({}, {t});
    double worst = 0;
    int inside   = 0;
    for (int y = 0; y < 200; ++y) {
        for (int x = 0; x < 300; ++x) {
            const auto w = weights(x + 0.5, y + 0.5);
            if (std::min({w[0], w[1], w[2]}) < 1e-6) continue;
            ++inside;
            for (int c = 0; c < 4; ++c) {
                const double exact =
                    w[0] * channel(colors[0], c) + w[1] * channel(colors[1], c) + w[2] * channel(colors[2], c);
                worst = std::max(worst, std::abs(channel(canvas.at(x, y), c) - exact));
            }
        }
    }
    CHECK(inside > 20000);
    CHECK(worst < 0.5 + 8.5 / 128);  // rounding to a byte, and that of the step over a block

    // Each vertex is at a pixel's centre: the pixel next to it, towards the middle, is at most one step away.
    const std::array<std::array<int, 2>, 3> next_to = {{{12, 21}, {277, 5}, {101, 187}}};
    for (int i = 0; i < 3; ++i)
        for (int c = 0; c < 4; ++c)
            CHECK(std::abs(channel(canvas.at(next_to[i][0], next_to[i][1]), c) - channel(colors[i], c)) <= 6);
}

TEST_CASE("A colour half-way between two bytes takes the greater", "[reference]") {
    // From 0 to 1 over sixteen pixels, from centre to centre: a half at the ninth.
    const auto left = [](float y) { return vertex(0.5f, y, 0); };
    Canvas canvas(16, 1);
    canvas.draw({}, {{left(0.0f), vertex(16.5f, 0.0f, 0x01010101), left(16.0f)}});
    for (int x = 0; x < 16; ++x) CHECK(canvas.at(x, 0) == (x < 8 ? 0 : 0x01010101));
}

TEST_CASE("Floored colours are the byte below", "[reference]") {
    // From 0 to 8 over sixteen pixels, from centre to centre: half a byte a pixel, exactly.
    const auto left = [](float y) { return vertex(0.5f, y, 0); };
    FillState state;
    state.floor_colors = GENERATE(false, true);
    Canvas canvas(16, 1);
    canvas.draw(state, {{left(0.0f), vertex(16.5f, 0.0f, 0x08080808), left(16.0f)}});
    for (int x = 0; x < 16; ++x) CHECK(canvas.at(x, 0) == grey(state.floor_colors ? x / 2 : (x + 1) / 2));
    // And so is the factor of fog.
    Triangle fogged = {left(0.0f), vertex(16.5f, 0.0f, 0), left(16.0f)};
    for (Vertex& v : fogged) v.specular = 0;
    fogged[1].specular = 0x08000000;
    state.fog          = true;
    state.fog_color    = 0x00ffffff;
    canvas.draw(state, {fogged});
    for (int x = 0; x < 16; ++x)
        CHECK(canvas.at(x, 0) == (grey(255 - (state.floor_colors ? x / 2 : (x + 1) / 2)) & 0xffffff));
}

TEST_CASE("A floored colour below 0 is 0", "[reference]") {
    // From 1 to 0 over 200 pixels: a step of -128/200, rounded to -1. The block at 192 starts at 128 * 8 / 200, rounded
    // to 5, so that values from pixel 198 on are negative.
    Canvas canvas(208, 1);
    FillState state;
    state.floor_colors = true;
    canvas.draw(state, {{vertex(0.5f, 0.0f, grey(1)), vertex(200.5f, 0.0f, 0), vertex(0.5f, 200.0f, grey(1))}});
    CHECK(canvas.at(0, 0) == grey(1));
    for (int x = 1; x < 200; ++x) CHECK(canvas.at(x, 0) == 0);
}

TEST_CASE("A vertex at a covered centre gives its own colour", "[reference]") {
    std::mt19937 random(3);
    for (int i = 0; i < 500; ++i) {
        const int x = static_cast<int>(random() % 40), y = static_cast<int>(random() % 40);
        // The corner where a top and a left edge meet, so that the centre is covered.
        Triangle t = {vertex(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, random_color(random)),
                      vertex(static_cast<float>(x) + 0.5f + subpixels(static_cast<int>(random() % 900 + 100)),
                             static_cast<float>(y) + 0.5f, random_color(random)),
                      vertex(static_cast<float>(x) + 0.5f,
                             static_cast<float>(y) + 0.5f + subpixels(static_cast<int>(random() % 900 + 100)),
                             random_color(random))};
        const std::uint32_t expected = t[0].diffuse;
        std::shuffle(t.begin(), t.end(), random);
        Canvas canvas(40, 40);
        canvas.draw({}, {t});
        for (int c = 0; c < 4; ++c) CHECK(std::abs(channel(canvas.at(x, y), c) - channel(expected, c)) <= 1);
    }
}

TEST_CASE("Triangles are drawn before rectangles, and draws in their order", "[reference]") {
    Image color(4, 4);
    Draw first, second;
    first.rectangles = {rectangle(0, 0, 4, 4, 0x11111111), rectangle(0, 0, 1, 4, 0x22222222)};
    add_triangles(first, {triangle({{{-9, -9}, {99, -9}, {-9, 99}}}, 0x33333333)});
    add_triangles(second, {triangle({{{0, 0}, {8, 0}, {0, 2}}}, 0x44444444)});
    PassFill pass;
    pass.color              = &color;
    pass.scissor            = color.bounds();
    pass.draws              = {first, second};
    const FillCounts counts = reference_fill_pass(pass);
    CHECK(color.row(3)[0] == 0x22222222);
    CHECK(color.row(3)[3] == 0x11111111);
    CHECK(color.row(0)[0] == 0x44444444);
    CHECK(static_cast<int>(counts.covered) == 16 + 16 + 4 + drawn_pixels(color, 0x44444444));
}
