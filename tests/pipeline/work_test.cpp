// SPDX-License-Identifier: MIT
// What a frame takes, by hand for small ones; never less than is filled for random ones; and the limits.
#include "pipeline/validate/work.h"

#include "tests/support/random_frame.h"
#include "tests/support/small_frame.h"

using namespace pipeline;
using namespace test_support;

namespace {

std::uint64_t pixels_of(Frame frame, std::vector<Draw> draws) {
    frame.passes[0].draws = std::move(draws);
    return work_of(frame).pixels;
}

// A triangle with these corners in clip space.
DrawTriangles add_triangle(Frame& frame, const std::array<Vec3, 3>& corners) {
    DrawTriangles draw;
    draw.first_index = static_cast<std::uint32_t>(frame.indices.size());
    draw.index_count = 3;
    for (const Vec3& corner : corners) {
        frame.indices.push_back(static_cast<std::uint32_t>(frame.vertices.size()));
        frame.vertices.emplace_back().position = corner;
    }
    return draw;
}

}  // namespace

TEST_CASE("memory is that of targets, picture, textures, draws and triangles", "[work]") {
    Frame frame = small_frame(100, 10, TargetFormat::D16);
    CHECK(work_of(frame).bytes == 3 * 4 * 1000);
    add_texture(frame, TextureFormat::A8R8G8B8, 4, 2, std::vector<std::uint8_t>(32));
    CHECK(work_of(frame).bytes == 12000 + 32);
    // Texels as they are and copied, expanded to four bytes, and by fours with one more each way.
    add_texture(frame, TextureFormat::A8, 2, 2, std::vector<std::uint8_t>(5), 2);
    CHECK(work_of(frame).bytes == 12032 + 5 + 5 + 4 * 5 + 4 * (9 + 4));
    frame.passes[0].draws = {add_quad(frame, 0), rectangle({0, 0, 1, 1}, 0)};
    const Work work       = work_of(frame);
    CHECK(work.bytes == 12114 + 2 * kDrawBytes + 2 * kTriangleBytes);
    CHECK(work.triangles == 2);
}

TEST_CASE("clears fill what viewport and scissor leave, of colour and depth", "[work]") {
    Frame frame                    = small_frame(100, 10, TargetFormat::D16);
    frame.passes[0].clear          = {.color = Argb{0}, .depth = 1.0f};
    frame.passes[0].state.viewport = {10, 0, 90, 10};
    frame.passes[0].state.scissor  = {0, 2, 20, 10};
    CHECK(work_of(frame).pixels == 2 * 10 * 8);
}

TEST_CASE("draws fill the pixels around them, within target, viewport and scissor", "[work]") {
    Frame frame = small_frame(100, 100);
    CHECK(pixels_of(frame, {rectangle({10, 20, 30, 40}, 0)}) == 22 * 22);
    CHECK(pixels_of(frame, {rectangle({-500, 20, 9000, 40}, 0)}) == 100 * 22);
    CHECK(pixels_of(frame, {rectangle({200, 20, 300, 40}, 0)}) == 0);
    CHECK(pixels_of(frame, {CopyRectangle{.from = {5, 5, 10, 10}}}) == 25);
    CHECK(pixels_of(frame, {add_quad(frame, 0)}) == 2 * 100 * 100);
    CHECK(pixels_of(frame, {add_triangle(frame, {Vec3(0, 0, 0), Vec3(0.5f, 0, 0), Vec3(0, 0.5f, 0)})}) == 27 * 27);
    // All beyond one side; partly, which clipping leaves something of.
    CHECK(pixels_of(frame, {add_triangle(frame, {Vec3(2, 0, 0), Vec3(3, 0, 0), Vec3(2, 1, 0)})}) == 0);
    CHECK(pixels_of(frame, {add_triangle(frame, {Vec3(-9, -9, 0), Vec3(9, -9, 0), Vec3(0, 9, 0)})}) == 100 * 100);

    // Behind the eye and before it: anything may be left.
    Frame deep                    = frame;
    deep.cameras[0].projection[2] = Vec4(0.0f, 0.0f, 0.5f, 1.0f);  // w = z
    deep.cameras[0].projection[3] = Vec4(0.0f);
    CHECK(pixels_of(deep, {add_triangle(deep, {Vec3(0, 0, 1), Vec3(0.1f, 0, 1), Vec3(0, 0, -1)})}) == 100 * 100);

    frame.window_vertices.resize(3);
    frame.window_vertices[1].x = 8.0f;
    frame.window_vertices[2].y = 8.0f;
    frame.indices              = {0, 1, 2};
    CHECK(pixels_of(frame, {DrawWindowTriangles{.index_count = 3, .textures = {}}}) == 9 * 9);
}

TEST_CASE("no frame covers more than its work says, and rarely is it much less", "[work]") {
    std::uint64_t said = 0, done = 0;
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        INFO("seed " << seed);
        const Frame frame     = random_frame(seed);
        const Work work       = work_of(frame);
        std::uint64_t covered = 0, cleared = 0;
        for (const PassCounts& counts : execute(frame).counts) covered += counts.covered, cleared += counts.cleared;
        CHECK(work.pixels >= covered + cleared);
        said += work.pixels;
        done += covered + cleared;
    }
    CHECK(said < 3 * done);  // 1.92 times
}

TEST_CASE("what is beyond a limit is found, with the limit that would do", "[work]") {
    CHECK(check_work(kMostWork).empty());
    Work work = kMostWork;
    ++work.pixels;
    CHECK(check_work(work) == std::vector{Finding{"frame", "must fill at most 17179869184 pixels (got 17179869185)"}});
    CHECK(needed_limit(work) == 2);
    CHECK(check_work(work, 2).empty());
    work.bytes     = 60'000'000'000;
    work.triangles = kMostWork.triangles * 5;
    CHECK(check_work(work).size() == 3);
    CHECK(needed_limit(work) == 14);
    CHECK(check_work(work, 14).empty());
    CHECK(check_work(work, 13).size() == 1);
}

TEST_CASE("a short frame may take much", "[work]") {
    Frame frame = small_frame(kMaxTargetSize, kMaxTargetSize);
    frame.targets.resize(20, frame.targets[0]);
    CHECK(check_work(work_of(frame)).at(0).what == "must take at most 4294967296 bytes of memory (got 5637144576)");
    frame.targets.resize(1);
    frame.passes[0].draws.assign(257, rectangle({0, 0, kMaxTargetSize, kMaxTargetSize}, 0));
    CHECK(check_work(work_of(frame)).at(0).what == "must fill at most 17179869184 pixels (got 17246978048)");
    // Indices drawn over and over, which take too long to look at.
    frame.vertices.resize(3);
    frame.indices.assign(3'000'000, 0);
    frame.passes[0].draws.assign(10'000, DrawTriangles{.index_count = 3'000'000, .textures = {}});
    CHECK(check_work(work_of(frame)).at(1).what == "must draw at most 67108864 triangles (got 10000000000)");
}
