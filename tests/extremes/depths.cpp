// SPDX-License-Identifier: MIT
#include "tests/extremes/depths.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "pipeline/execute/execute.h"
#include "raster/fill_pass.h"
#include "tests/support/one_pass_frame.h"

namespace extremes {

using namespace pipeline;

namespace {

constexpr int kTarget = 64;

TargetFormat depth_format(int bits) {
    return bits == 16 ? TargetFormat::D16 : bits == 24 ? TargetFormat::D24 : TargetFormat::D32;
}

float in(std::mt19937& bits, double least, double greatest) {
    return static_cast<float>(least + (greatest - least) * (static_cast<double>(bits()) / 4294967296.0));
}

std::vector<std::uint32_t> square_indices(Again again) {
    switch (again) {
        case Again::Same:
            return {0, 1, 2, 0, 2, 3};
        case Again::WayRound:
            return {0, 2, 1, 0, 3, 2};
        case Again::FirstCorner:
            return {1, 2, 0, 2, 3, 0};
        case Again::Diagonal:
            return {1, 2, 3, 1, 3, 0};
    }
    return {};
}

}  // namespace

Ties depth_ties(int depth_bits, Size size, Again again) {
    Ties ties;
    std::mt19937 bits(7);
    for (int round = 0; round < 40; ++round) {
        Frame frame        = test_support::one_pass_frame(kTarget, kTarget, depth_format(depth_bits));
        // A parallelogram with its corners on a plane, up to rounding, of which the picture shows a part.
        const double reach = size == Size::Whole ? 1.0 : in(bits, 300.0, 3000.0);
        const Vec2 a(in(bits, 0.3, 1.0), in(bits, -0.2, 0.2)), b(in(bits, -0.2, 0.2), in(bits, 0.3, 1.0));
        const float slope_a = in(bits, -0.2, 0.2), slope_b = in(bits, -0.2, 0.2);
        for (const auto& [i, j] : {std::pair{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}}) {
            const auto r                           = static_cast<float>(reach);
            frame.vertices.emplace_back().position = {r * (i * a.x + j * b.x), r * (i * a.y + j * b.y),
                                                      0.5f + i * slope_a + j * slope_b};
        }
        frame.indices                           = square_indices(Again::Same);
        const std::vector<std::uint32_t> second = square_indices(again);
        frame.indices.insert(frame.indices.end(), second.begin(), second.end());
        Pass& pass       = frame.passes[0];
        pass.clear.depth = 1.0f;
        pass.state.depth = {CompareFunc::Always, true};
        pass.draws       = {DrawTriangles{.index_count = 6, .textures = {}}};
        for (const CompareFunc func : {CompareFunc::Equal, CompareFunc::LessEqual}) {
            Pass& tested       = frame.passes.emplace_back(Pass(frame.passes[0]));
            tested.clear       = {};
            tested.state.depth = {func, false};
            tested.draws       = {DrawTriangles{.first_index = 6, .index_count = 6, .textures = {}}};
        }
        const std::vector<PassCounts> counts = execute(frame).counts;
        ties.pixels += counts[1].covered;
        ties.not_equal += counts[1].covered - counts[1].depth_passed;
        ties.not_less_equal += counts[2].covered - counts[2].depth_passed;
    }
    return ties;
}

std::uint32_t first_corner_difference() {
    std::uint32_t greatest = 0;
    std::mt19937 bits(11);
    raster::Image depths[2]{raster::Image(128, 16), raster::Image(128, 16)};
    for (int round = 0; round < 400; ++round) {
        raster::Draw draw;
        draw.state.depth_write = true;
        // Around the picture, with sides from pixels to all there is.
        const double reach     = std::exp2(in(bits, 7.0, 14.0));
        for (const double angle : {0.3, 2.4, 4.5}) {
            raster::Vertex& vertex = draw.vertices.emplace_back();
            const double turned    = angle + in(bits, -0.3, 0.3);
            // Sines of their own: the C library's differ between machines.
            const double t = turned * 0.5, t2 = t * t;
            const double half_sine   = t - t * t2 / 6 + t * t2 * t2 / 120 - t * t2 * t2 * t2 / 5040;
            const double half_cosine = 1 - t2 / 2 + t2 * t2 / 24 - t2 * t2 * t2 / 720;
            vertex.x = std::clamp(static_cast<float>(64 + reach * (half_cosine * half_cosine - half_sine * half_sine)),
                                  -16384.0f, 16384.0f);
            vertex.y = std::clamp(static_cast<float>(8 + reach * 2 * half_sine * half_cosine), -16384.0f, 16384.0f);
            vertex.z = in(bits, 0.0, 1.0);
        }
        for (int i = 0; i < 2; ++i) {
            draw.triangles = {i == 0 ? raster::TriangleCorners{0, 1, 2} : raster::TriangleCorners{1, 2, 0}};
            raster::fill_pass({.depth       = &depths[i],
                               .depth_bits  = 32,
                               .scissor     = depths[i].bounds(),
                               .clear_depth = 0,
                               .draws       = {draw}});
        }
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 128; ++x) {
                const std::uint32_t a = depths[0].row(y)[x] >> 2, b = depths[1].row(y)[x] >> 2;
                greatest = std::max(greatest, a > b ? a - b : b - a);
            }
    }
    return greatest;
}

std::vector<Row> depth_rows() {
    std::vector<Row> rows;
    const auto add = [&](Size size, Again again, const std::string& what, const std::string& bound,
                         const std::string& end) {
        std::string worst;
        for (const int bits : {16, 24, 32}) {
            const Ties ties = depth_ties(bits, size, again);
            worst += (worst.empty() ? "" : "; ") + count_text(ties.not_equal) + ", " + count_text(ties.not_less_equal) +
                     (bits == 32 ? " of " + count_text(ties.pixels) : "");
        }
        rows.push_back({what, "D16; D24; D32: fail EQUAL, LESSEQUAL", bound, worst, end});
    };
    add(Size::Whole, Again::Same, "drawn again, the same", "none", "nowhere");
    add(Size::Cut, Again::Same, "drawn again, the same, cut", "none", "nowhere");
    add(Size::Whole, Again::WayRound, "corners the other way round", "none", "nowhere");
    add(Size::Whole, Again::FirstCorner, "another corner first", "no rule", "at the last bits: see below");
    add(Size::Whole, Again::Diagonal, "the other diagonal", "no rule",
        "corners are rounded, so that the plane is another");
    add(Size::Cut, Again::WayRound, "the other way round, cut", "no rule", "what is cut becomes other triangles");
    add(Size::Cut, Again::FirstCorner, "another corner first, cut", "no rule", "the same");
    rows.push_back({"depth, another corner first", "sides of 128 to 32,768 px",
                    std::to_string(kFirstCornerBound) + " * 2^-30",
                    std::to_string(first_corner_difference()) + " * 2^-30", "2 units of D24, 1 of D16"});
    return rows;
}

}  // namespace extremes
