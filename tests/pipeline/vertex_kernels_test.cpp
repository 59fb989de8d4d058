// SPDX-License-Identifier: MIT
// The vertex stage's kernels against the same in scalar code, to the bit, on every instruction set.
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "pipeline/execute/clip.h"
#include "pipeline/execute/vertex_stage.h"
#include "tests/support/random.h"
#include "tests/support/random_frame.h"
#include "tests/support/simd_targets.h"

using namespace pipeline;
using test_support::Random;

namespace {

bool same_bits(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

bool same(const raster::Vertex& a, const raster::Vertex& b) {
    bool equal = same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z) && same_bits(a.rhw, b.rhw) &&
                 a.diffuse == b.diffuse && a.specular == b.specular;
    for (std::size_t i = 0; i < a.uv.size(); ++i)
        equal = equal && same_bits(a.uv[i].s, b.uv[i].s) && same_bits(a.uv[i].t, b.uv[i].t) &&
                same_bits(a.uv[i].q, b.uv[i].q);
    return equal;
}

// The number of triangles, or 0 if they differ.
std::size_t triangles_if_same(const raster::Draw& a, const raster::Draw& b) {
    if (a.triangles != b.triangles || a.flat != b.flat) return 0;
    for (const raster::TriangleCorners& corners : a.triangles)
        for (const std::uint32_t corner : corners)
            if (!same(a.vertices[corner], b.vertices[corner])) return 0;
    return a.triangles.size();
}

// Coordinates about w and the guard band, which the comparisons of a block have to tell apart.
Vec4 random_clip_position(Random& random) {
    const float w         = random.chance(10) ? random.one_of({0.0f, kLeastW, -1.0f, 0x1p-33f, 3e38f})
                                              : std::ldexp(random.real(0.5f, 1.0f), random.from(-20, 20));
    const auto coordinate = [&] {
        switch (random.from(0, 5)) {
            case 0:
                return random.one_of({w, -w, 0.0f, -0.0f});
            case 1:
                return std::nextafter(random.chance(50) ? w : -w, random.one_of({0.0f, 1e30f, -1e30f}));
            case 2:
                return static_cast<float>(w * (1.0 + 2.0 * kGuardBand / 100)) * random.one_of({1.0f, -1.0f});
            case 3:
                return random.one_of({std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN(),
                                      std::numeric_limits<float>::max(), -std::numeric_limits<float>::max()});
            default:
                return w * random.real(-2.0f, 2.0f);
        }
    };
    return {coordinate(), coordinate(), random.chance(60) ? w * random.real(0.0f, 1.0f) : coordinate(), w};
}

bool is_finite(const Vec4& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

}  // namespace

TEST_CASE("shading by blocks and one by one gives the same bits", "[vertex_stage][agreement]") {
    std::size_t triangles = 0, draws = 0;
    for (std::uint32_t seed = 0; seed < 400; ++seed) {
        const Frame frame = test_support::random_frame(seed);
        for (const Pass& pass : frame.passes)
            for (const Draw& each : pass.draws) {
                const auto* draw = std::get_if<DrawTriangles>(&each);
                if (draw == nullptr) continue;
                const PixelRect viewport{3, 5, 3 + 77, 5 + 50};
                raster::Draw wanted;
                const VertexStageCounts counts =
                    run_vertex_stage(frame, pass, *draw, viewport, wanted, ShadingPath::Scalar);
                test_support::for_each_simd_target([&] {
                    raster::Draw got;
                    const VertexStageCounts got_counts = run_vertex_stage(frame, pass, *draw, viewport, got);
                    INFO("seed " << seed);
                    REQUIRE(got_counts.vertices == counts.vertices);
                    REQUIRE(got_counts.triangles_drawn == counts.triangles_drawn);
                    REQUIRE(triangles_if_same(got, wanted) == wanted.triangles.size());
                });
                triangles += wanted.triangles.size();
                ++draws;
            }
    }
    CHECK(draws > 200);
    CHECK(triangles > 2 * draws);
}

TEST_CASE("placing by blocks tells the sides of the clip volumes apart", "[vertex_stage][agreement]") {
    for (const bool truncate : {false, true}) {
        const PixelRect viewport{10, 20, 110, 70};
        const Window window(viewport, {.center = 8, .truncate = truncate}, kGuardBand);
        test_support::for_each_simd_target([&] {
            Random random(3);
            int placed_count = 0;
            for (int round = 0; round < 2000; ++round) {
                raster::Points4 clip{};
                std::array<Vec4, raster::kVertexBlock> positions;
                for (int i = 0; i < raster::kVertexBlock; ++i) {
                    const Vec4 p = positions[static_cast<std::size_t>(i)] = random_clip_position(random);
                    clip.x[i] = p.x, clip.y[i] = p.y, clip.z[i] = p.z, clip.w[i] = p.w;
                }
                raster::PlacedVertices placed;
                raster::Points4 in_window;
                raster::vertex_kernels().place(window.transform(), clip, raster::kVertexBlock, placed);
                raster::vertex_kernels().to_window(window.transform(), clip, raster::kVertexBlock, in_window);
                for (int i = 0; i < raster::kVertexBlock; ++i) {
                    const Vec4& p = positions[static_cast<std::size_t>(i)];
                    REQUIRE(((placed.flags[i] & raster::kNotFinite) == 0) == is_finite(p));
                    if (!is_finite(p)) continue;
                    REQUIRE((placed.flags[i] & raster::kOutsideViewport) == outcode({}, p));
                    REQUIRE(((placed.flags[i] & raster::kOutsideBand) != 0) == (outcode(window.guard_band(), p) != 0));
                    if (placed.flags[i] & raster::kOutsideBand) continue;
                    raster::Vertex wanted;
                    window.place(p, wanted);
                    const raster::Subpixel snapped = window.snap(wanted);
                    REQUIRE((placed.x[i] == snapped.x && placed.y[i] == snapped.y));
                    REQUIRE((same_bits(in_window.x[i], wanted.x) && same_bits(in_window.y[i], wanted.y)));
                    REQUIRE((same_bits(in_window.z[i], wanted.z) && same_bits(in_window.w[i], wanted.rhw)));
                    ++placed_count;
                }
            }
            CHECK(placed_count > 1000);
        });
    }
}
