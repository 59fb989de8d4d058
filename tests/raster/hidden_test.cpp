// SPDX-License-Identifier: MIT
// Without counts the same pixels are drawn, though hidden primitives are left out and some are filled in reverse: beside the
// reference, on every instruction set, where depths differ by a unit or not at all and many layers lie on each other.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdint>

#include "raster/fill_pass.h"
#include "raster/reference.h"
#include "raster/settled_pixels.h"
#include "tests/support/random.h"
#include "tests/support/simd_targets.h"

namespace {

using namespace raster;
using test_support::Random;

constexpr int kWidth = 100, kHeight = 70;

struct Targets {
    Image color{kWidth, kHeight}, depth{kWidth, kHeight};

    bool operator==(const Targets& other) const {
        for (int y = 0; y < kHeight; ++y)
            if (!std::equal(color.row(y), color.row(y) + kWidth, other.color.row(y)) ||
                !std::equal(depth.row(y), depth.row(y) + kWidth, other.depth.row(y)))
                return false;
        return true;
    }
};

// A few units of 16 bits about the middle, so that equal ones meet.
constexpr int kDepths = 6;
std::uint32_t stored_depth(int level, int depth_bits) {
    return to_depth_format((32768u + static_cast<std::uint32_t>(level)) << (kDepthBits - 16), depth_bits);
}
float vertex_depth(int level) {
    return static_cast<float>(32768 + level) / 65536.0f;
}

// The same from a seed; in blocks of 8 pixels by 8, so that small triangles lie wholly before or behind.
Targets random_targets(std::uint32_t seed, int depth_bits) {
    Targets targets;
    Random random(seed);
    std::array<int, (kWidth / 8 + 1) * (kHeight / 8 + 1)> levels;
    for (int& level : levels) level = random.from(0, kDepths);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            targets.color.row(y)[x] = random.bits();
            targets.depth.row(y)[x] = stored_depth(levels[(y / 8) * (kWidth / 8 + 1) + x / 8], depth_bits);
        }
    return targets;
}

Draw random_draw(Random& random, Compare func, bool write) {
    Draw draw;
    draw.state.depth_func  = func;
    draw.state.depth_write = write;
    if (random.chance(25)) {
        draw.state.blend.source = {BlendFactor::Operand::Source, true};
        draw.state.blend.dest   = {BlendFactor::Operand::Source, true, true};
    }
    const int count = random.one_of({1, 2, 40});
    for (int i = 0; i < count; ++i) {
        const float size = random.one_of({4.0f, 10.0f, 60.0f});
        const float x = random.real(0.0f, kWidth), y = random.real(0.0f, kHeight);
        const int level  = random.from(0, kDepths);
        const auto first = static_cast<std::uint32_t>(draw.vertices.size());
        for (int k = 0; k < 3; ++k) {
            Vertex v;
            v.x       = x + random.real(-size, size);
            v.y       = y + random.real(-size, size);
            v.z       = vertex_depth(random.chance(80) ? level : random.from(0, kDepths));
            v.diffuse = random.bits();
            draw.vertices.push_back(v);
        }
        draw.triangles.push_back({first, first + 1, first + 2});
    }
    return draw;
}

}  // namespace

TEST_CASE("what is hidden is left out to the same pixels", "[raster][agreement]") {
    for (std::uint32_t seed = 0; seed < 150; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const int depth_bits = random.one_of({16, 24, 32});
        Targets wanted       = random_targets(seed, depth_bits);
        PassFill pass{.color      = &wanted.color,
                      .depth      = &wanted.depth,
                      .depth_bits = depth_bits,
                      .scissor    = {random.from(0, 9), random.from(0, 9), kWidth - random.from(0, 9), kHeight}};
        for (int i = 0; i < 6; ++i)
            pass.draws.push_back(random_draw(
                random, random.one_of({Compare::LessEqual, Compare::Less, Compare::Greater, Compare::Always}),
                random.chance(40)));
        reference_fill_pass(pass);
        REQUIRE_FALSE(wanted == random_targets(seed, depth_bits));
        test_support::for_each_simd_target([&] {
            Targets got = random_targets(seed, depth_bits);
            pass.color  = &got.color;
            pass.depth  = &got.depth;
            PassFiller().fill({&pass, 1}, {}, {.tile_order_seed = seed, .counts = false});
            CHECK(got == wanted);
        });
    }
}

TEST_CASE("settled pixels are those that were added", "[raster]") {
    SettledPixels settled;
    const Rect all{64, 32, 128, 64}, some{70, 40, 100, 50};
    CHECK_FALSE(settled.has(some));
    for (int y = 40; y < 50; ++y)
        for (int x = 64; x < 112; x += kBlockWidth) settled.add(x, y, x == 64 ? 0xffc0 : x == 96 ? 0x000f : 0xffff);
    CHECK(settled.block(64, 40) == 0xffc0);
    CHECK(settled.block(96, 49) == 0x000f);
    CHECK(settled.block(96, 50) == 0);
    CHECK(settled.has(some));
    CHECK_FALSE(settled.has({69, 40, 100, 50}));
    CHECK_FALSE(settled.has({70, 40, 101, 50}));
    CHECK_FALSE(settled.has({70, 39, 100, 50}));
    CHECK_FALSE(settled.has({70, 40, 100, 51}));
    for (int y = 32; y < 64; ++y)
        for (int x = 64; x < 128; x += kBlockWidth) settled.add(x, y, 0xffff);
    CHECK(settled.has(all));
    settled.clear();
    CHECK_FALSE(settled.has(some));
}
