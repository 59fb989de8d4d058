// SPDX-License-Identifier: MIT
// What is set up and binned at a time is bounded; the rest waits for its turn, in order.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstddef>
#include <vector>

#include "raster/fill_pass.h"
#include "raster/special_programs.h"
#include "raster/thread_arena.h"
#include "tests/support/random.h"

namespace {

using namespace raster;
using test_support::Random;

constexpr int kWidth = 1024, kHeight = 512;  // 256 tiles

// Blended, so that each shows what it came after.
Draw blended_draw() {
    Draw draw;
    draw.state.blend.source = special::kSourceAlpha;
    draw.state.blend.dest   = special::kInvSourceAlpha;
    return draw;
}

Draw small_triangles(Random& random, std::uint32_t count) {
    Draw draw = blended_draw();
    for (std::uint32_t i = 0; i < count; ++i) {
        const float x = random.real(0.0f, kWidth), y = random.real(0.0f, kHeight);
        for (int corner = 0; corner < 3; ++corner) {
            Vertex vertex;
            vertex.x       = x + random.real(-9.0f, 9.0f);
            vertex.y       = y + random.real(-9.0f, 9.0f);
            vertex.diffuse = random.bits();
            draw.vertices.push_back(vertex);
        }
        draw.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return draw;
}

// Each in all tiles.
Draw large_rectangles(Random& random, int count) {
    Draw draw = blended_draw();
    for (int i = 0; i < count; ++i) {
        Rectangle rectangle{.x1 = kWidth, .y1 = kHeight, .uv = {}};
        rectangle.color = random.bits() & 0x03ffffff;  // what lies below still shows after all of them
        draw.rectangles.push_back(rectangle);
    }
    return draw;
}

// A few primitives of it at a time.
void fill_apart(const Draw& draw, Image& image) {
    constexpr std::size_t kFew = 100;
    PassFill pass{.color = &image, .scissor = image.bounds(), .draws = {draw}};
    const auto fill_parts = [&](auto& drawn, const auto& all) {
        for (std::size_t first = 0; first < all.size(); first += kFew) {
            drawn.assign(all.begin() + static_cast<std::ptrdiff_t>(first),
                         all.begin() + static_cast<std::ptrdiff_t>(std::min(first + kFew, all.size())));
            fill_pass(pass);
        }
    };
    fill_parts(pass.draws[0].triangles, draw.triangles);
    fill_parts(pass.draws[0].rectangles, draw.rectangles);
}

}  // namespace

TEST_CASE("more than is held at a time is drawn in turn", "[raster]") {
    Random random(3);
    // More triangles than are set up at a time, with rectangles between them that have too many entries in tiles.
    const std::array draws{small_triangles(random, 40'000), large_rectangles(random, 400),
                           small_triangles(random, 40'000), large_rectangles(random, 3)};
    Image wanted(kWidth, kHeight);
    for (const Draw& draw : draws) fill_apart(draw, wanted);
    for (const int threads : {1, 3}) {
        CAPTURE(threads);
        Image got(kWidth, kHeight);
        ThreadArena(threads).run([&] {
            PassFiller filler;
            for (int again = 0; again < 2; ++again) {  // with the memory of the first time
                fill_rect(got, got.bounds(), 0);
                const PassFill pass{
                    .color = &got, .scissor = got.bounds(), .draws = std::vector<Draw>(draws.begin(), draws.end())};
                filler.fill({&pass, 1}, {}, {.counts = false});
                bool is_same = true;
                for (int y = 0; y < kHeight; ++y)
                    is_same = is_same && std::equal(got.row(y), got.row(y) + kWidth, wanted.row(y));
                CHECK(is_same);
            }
        });
    }
}
