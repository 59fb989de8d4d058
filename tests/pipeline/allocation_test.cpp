// SPDX-License-Identifier: MIT
// Drawing a frame again takes no memory for its vertices, triangles, pixels and tiles: the allocations of a frame are
// few, and as many for a large one as for a small one. Counts what this program asks of operator new.
#include <atomic>
#include <cstdlib>
#include <new>

#include "tests/support/small_frame.h"

namespace {
std::atomic<std::size_t> allocations = 0, allocated_bytes = 0;
}

void* operator new(std::size_t size) {
    ++allocations;
    allocated_bytes += size;
    if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace {

using namespace pipeline;
using namespace test_support;

// Two passes with depth and a blit; a mesh of 2 * cells^2 triangles that share their vertices, some of it clipped.
Frame mesh_frame(int size, std::uint32_t cells) {
    Frame frame         = small_frame(size, size, TargetFormat::D24);
    Pass& pass          = frame.passes[0];
    pass.clear          = {.color = Argb{0xff102030}, .depth = 1.0f};
    pass.state.depth    = {CompareFunc::LessEqual, true};
    pass.state.fog.mode = FogMode::Linear;
    DrawTriangles mesh;
    for (std::uint32_t y = 0; y <= cells; ++y)
        for (std::uint32_t x = 0; x <= cells; ++x) {
            Vertex& vertex  = frame.vertices.emplace_back();
            const auto seen = [&](std::uint32_t i) {
                return 2.2f * static_cast<float>(i) / static_cast<float>(cells) - 1.1f;
            };
            vertex.position = {seen(x), seen(y),
                               0.9f * static_cast<float>((x ^ y) & 1) + 0.2f * static_cast<float>(y == cells)};
            vertex.diffuse  = {0xff000000 | x * 37 | y * 1361};
        }
    for (std::uint32_t y = 0; y < cells; ++y)
        for (std::uint32_t x = 0; x < cells; ++x) {
            const std::uint32_t a = y * (cells + 1) + x, below = a + cells + 1;
            frame.indices.insert(frame.indices.end(), {a, below, a + 1, a + 1, below, below + 1});
        }
    mesh.index_count = static_cast<std::uint32_t>(frame.indices.size());
    pass.draws       = {mesh};
    Pass second      = pass;
    second.clear     = {};
    second.draws     = {mesh, rectangle({0, 0, size / 2, size}, 0xff00ff00, 0.25f)};
    frame.passes.push_back(second);
    return frame;
}

std::size_t allocations_of_frame(const Frame& frame) {
    Executor executor;
    Execution execution;
    const ExecuteOptions options{.threads = 1};
    for (int warm_up = 0; warm_up < 2; ++warm_up) executor.execute(frame, execution, options);
    const std::size_t before = allocations;
    executor.execute(frame, execution, options);
    const std::size_t after = allocations;
    CHECK(execution.counts[0].triangles_drawn > 0);
    return after - before;
}

}  // namespace

TEST_CASE("a frame drawn again allocates little, whatever its size", "[execute]") {
    const std::size_t small = allocations_of_frame(mesh_frame(32, 4));
    const std::size_t large = allocations_of_frame(mesh_frame(640, 90));
    CHECK(small > 0);  // they are counted
    CHECK(small <= 60);
    CHECK(large == small);
}

TEST_CASE("triangles whose vertices are far apart take memory for their own vertices alone", "[execute]") {
    constexpr std::uint32_t kVertices = 10000, kDraws = 100;
    Frame frame = small_frame(4, 4);
    frame.vertices.resize(kVertices);
    frame.window_vertices.resize(kVertices);
    frame.indices             = {0, kVertices - 1, 1};
    Pass& pass                = frame.passes[0];
    const bool is_window_kind = GENERATE(false, true);
    for (std::uint32_t i = 0; i < kDraws; ++i)
        if (is_window_kind)
            pass.draws.emplace_back(DrawWindowTriangles{.index_count = 3, .textures = {}});
        else
            pass.draws.emplace_back(DrawTriangles{.index_count = 3, .textures = {}});
    const std::size_t before = allocated_bytes;
    draw(frame, {.threads = 1});
    // Were all between them copied for each draw, it would be 64 MB.
    CHECK(allocated_bytes - before < 8'000'000);
}
