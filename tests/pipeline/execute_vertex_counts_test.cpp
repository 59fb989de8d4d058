// SPDX-License-Identifier: MIT
// What a pass says of its triangles and their vertices, counted by hand; and that passes are counted apart.
#include "tests/support/count_rows.h"

using namespace pipeline;
using namespace test_support;

namespace {

// A draw of one triangle with vertices of its own.
void add_triangle(Frame& frame, const std::array<Vec3, 3>& position) {
    DrawTriangles draw;
    draw.first_index = static_cast<std::uint32_t>(frame.indices.size());
    draw.index_count = 3;
    for (const Vec3& each : position) {
        frame.indices.push_back(static_cast<std::uint32_t>(frame.vertices.size()));
        frame.vertices.emplace_back().position = each;
    }
    frame.passes[0].draws.emplace_back(draw);
}

}  // namespace

TEST_CASE("counts: triangles before and after culling and clipping", "[execute][counts]") {
    Frame quad           = small_frame(8, 8);
    quad.passes[0].draws = {add_quad(quad, 0xffffffff)};
    const auto counts    = [](std::uint64_t vertices, std::uint64_t in, std::uint64_t drawn, std::uint64_t fragments) {
        return PassCounts{.vertices        = vertices,
                             .triangles_in    = in,
                             .triangles_drawn = drawn,
                             .covered         = fragments,
                             .depth_passed    = fragments,
                             .color_written   = fragments,
                             .bytes           = 4 * fragments};
    };
    check_rows(
        quad, {{"both", [](Frame&) {}, counts(4, 2, 2, 64)},
               {"the other side culled", [](Frame& f) { f.passes[0].state.cull = CullMode::CounterClockwise; },
                counts(4, 2, 2, 64)},
               {"this side culled", [](Frame& f) { f.passes[0].state.cull = CullMode::Clockwise; }, counts(4, 2, 0, 0)},
               {"beside the viewport",
                [](Frame& f) {
                    add_triangle(f, {Vec3(1.5f, 0, 0), Vec3(2, 0, 0), Vec3(2, -1, 0)});
                },
                counts(7, 3, 2, 64)},
               {"behind the far plane",
                [](Frame& f) {
                    add_triangle(f, {Vec3(-1, 1, 2), Vec3(1, 1, 2), Vec3(1, -1, 2)});
                },
                counts(7, 3, 2, 64)},
               {"without area",
                [](Frame& f) {
                    add_triangle(f, {Vec3(-1, 1, 0), Vec3(0, 0, 0), Vec3(1, -1, 0)});
                },
                counts(7, 3, 2, 64)},
               {"smaller than a pixel",
                [](Frame& f) {
                    add_triangle(f, {Vec3(0, 0, 0), Vec3(0.0625f, 0, 0), Vec3(0, -0.0625f, 0)});
                },
                counts(7, 3, 3, 64)},
               // Of the half below the diagonal, 28 pixels, depth is 0 along its middle: 6 pixels lie above, 22 below.
               {"cut to a triangle",
                [](Frame& f) {
                    f.passes[0].draws.clear();
                    add_triangle(f, {Vec3(-1, 1, 1), Vec3(1, -1, -1), Vec3(-1, -1, -1)});
                },
                counts(3, 1, 1, 6)},
               {"cut to a quadrangle",
                [](Frame& f) {
                    f.passes[0].draws.clear();
                    add_triangle(f, {Vec3(-1, 1, -1), Vec3(1, -1, 1), Vec3(-1, -1, 1)});
                },
                counts(3, 1, 2, 22)}});
}

TEST_CASE("counts: vertices are those that a draw refers to, each once", "[execute][counts]") {
    Frame quad           = small_frame(8, 8);
    quad.passes[0].draws = {add_quad(quad, 0xffffffff)};
    const auto add_draw  = [](Frame& frame, std::uint32_t first_index, std::uint32_t index_count) {
        DrawTriangles draw;
        draw.first_index = first_index;
        draw.index_count = index_count;
        frame.passes[0].draws.emplace_back(draw);
    };
    const auto vertices = [](Frame frame) {
        const PassCounts counts = draw_on_both(frame).execution.counts[0];
        return std::pair{counts.vertices, counts.triangles_in};
    };
    using Pair = std::pair<std::uint64_t, std::uint64_t>;

    Frame frame = quad;
    frame.vertices.resize(100);
    CHECK(vertices(frame) == Pair{4, 2});
    add_draw(frame, 0, 6);
    CHECK(vertices(frame) == Pair{8, 4});
    add_draw(frame, 3, 3);
    CHECK(vertices(frame) == Pair{11, 5});
    add_draw(frame, 6, 0);
    CHECK(vertices(frame) == Pair{11, 5});

    // A single vertex three times over, and three far apart.
    frame = quad;
    frame.passes[0].draws.clear();
    frame.vertices.resize(5000);
    frame.indices = {7, 7, 7, 4999, 0, 2500};
    add_draw(frame, 0, 3);
    CHECK(vertices(frame) == Pair{1, 1});
    add_draw(frame, 3, 3);
    CHECK(vertices(frame) == Pair{4, 2});

    // Long enough to be drawn in several parts, which share all vertices, or a few.
    frame = quad;
    frame.indices.clear();
    for (int i = 0; i < 3000; ++i) frame.indices.insert(frame.indices.end(), {0, 1, 2});
    std::get<DrawTriangles>(frame.passes[0].draws[0]).index_count = 9000;
    CHECK(vertices(frame) == Pair{3, 3000});
    frame.vertices.resize(3002);
    for (std::uint32_t i = 0; i < 3000; ++i)
        for (std::uint32_t corner = 0; corner < 3; ++corner) frame.indices[3 * i + corner] = i + corner;
    CHECK(vertices(frame) == Pair{3002, 3000});
}

TEST_CASE("counts: each pass has its own, in order", "[execute][counts]") {
    Frame frame           = small_frame(8, 8);
    frame.passes[0].draws = {rectangle({2, 2, 6, 6}, 0)};
    Pass second           = frame.passes[0];
    second.draws          = {add_quad(frame, 0)};
    second.clear.color    = Argb{0};
    frame.passes          = {frame.passes[0], second, frame.passes[0]};
    const PassCounts drawn{.rectangles = 1, .covered = 16, .depth_passed = 16, .color_written = 16, .bytes = 64};
    const PassCounts quad{.vertices        = 4,
                          .triangles_in    = 2,
                          .triangles_drawn = 2,
                          .covered         = 64,
                          .depth_passed    = 64,
                          .color_written   = 64,
                          .cleared         = 64,
                          .bytes           = 512};
    CHECK(draw_on_both(frame).execution.counts == std::vector<PassCounts>{drawn, quad, drawn});
}
