// SPDX-License-Identifier: MIT
// Which triangles of a terrain are drawn, in which layers, and that what is left out could not be seen.
#include "demo/terrain_blocks.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <tuple>
#include <variant>

#include "demo/camera_matrices.h"
#include "demo/right_triangles.h"
#include "demo/scene_build.h"
#include "demo/scene_data.h"
#include "demo/scene_file.h"
#include "pipeline/execute/execute.h"

namespace demo {
namespace {

const char* const kCanyon = R"(
[camera]
position = [0, 56, 158]
target = [0, 70, 0]
far = 3000
[camera.orbit]
degrees = 170
frames = 16
[fog]
start = 2500
end = 2900
[terrain]
generate = "canyon"
)";

const Scene& canyon() {
    static const Scene scene = build_scene(parse_scene(kCanyon, "x.toml", "x"));
    return scene;
}

using Position = std::tuple<float, float, float>;
Position position_of(const Scene& scene, std::uint32_t index) {
    const Vec3& p = scene.geometry.vertices[index].position;
    return {p.x, p.y, p.z};
}

std::set<std::array<Position, 3>> triangles_of(const Scene& scene, const std::vector<std::uint32_t>& indices) {
    std::set<std::array<Position, 3>> triangles;
    for (std::size_t i = 0; i < indices.size(); i += 3)
        triangles.insert(
            {position_of(scene, indices[i]), position_of(scene, indices[i + 1]), position_of(scene, indices[i + 2])});
    return triangles;
}

// The frame with all of the terrain, in the order of the blocks.
pipeline::Frame with_every_block(const Scene& scene, pipeline::Frame frame) {
    const auto replace = [&](pipeline::Pass& pass, std::vector<std::uint32_t> TerrainBlock::*layer) {
        REQUIRE(pass.draws.size() == 1);
        auto& draw       = std::get<pipeline::DrawTriangles>(pass.draws[0]);
        draw.first_index = static_cast<std::uint32_t>(frame.indices.size());
        for (const TerrainBlock& block : scene.geometry.terrain.blocks)
            frame.indices.insert(frame.indices.end(), (block.*layer).begin(), (block.*layer).end());
        draw.index_count = static_cast<std::uint32_t>(frame.indices.size()) - draw.first_index;
    };
    replace(frame.passes[0], &TerrainBlock::walls);
    replace(frame.passes[1], &TerrainBlock::ground);
    replace(frame.passes[2], &TerrainBlock::overlays);
    return frame;
}

std::size_t shown_from(const Vec3& eye, const Vec3& target) {
    return visible_blocks(canyon().geometry.terrain, eye, look_at(eye, target), perspective(45.0, 1.5, 0.5, 3000.0))
        .size();
}

}  // namespace

TEST_CASE("what is left out of the terrain could not be seen", "[demo][terrain]") {
    const Scene& scene    = canyon();
    std::uint64_t covered = 0, all_covered = 0;
    for (int index = 0; index < 16; index += 3) {
        const pipeline::Frame frame = scene_frame(scene, {320, 180}, index);
        const pipeline::Frame whole = with_every_block(scene, frame);
        const auto drawn = pipeline::execute(frame), all = pipeline::execute(whole);
        INFO("frame " << index);
        CHECK(drawn.output.pixels == all.output.pixels);
        for (std::size_t pass = 0; pass < 3; ++pass) {
            covered += drawn.counts[pass].covered;
            all_covered += all.counts[pass].covered;
        }
    }
    CHECK(covered < all_covered * 9 / 10);
}

TEST_CASE("terrain hides what lies behind it only from above and within", "[demo][terrain]") {
    const std::size_t low = shown_from({0.0f, 56.0f, 158.0f}, {0.0f, 56.0f, 0.0f});
    CHECK(low > 50);
    // The same view from beside the terrain, or from below, is not cut short by hills.
    CHECK(shown_from({0.0f, 56.0f, 1700.0f}, {0.0f, 56.0f, 0.0f}) > 2 * low);
    CHECK(shown_from({0.0f, -200.0f, 158.0f}, {0.0f, -200.0f, 0.0f}) > low);
    CHECK(shown_from({0.0f, 900.0f, 158.0f}, {0.0f, 2000.0f, 157.0f}) == 0);
}

TEST_CASE("near blocks come before those they may hide", "[demo][terrain]") {
    const TerrainBlocks& terrain = canyon().geometry.terrain;
    const Vec3 eye(310.0f, 700.0f, -120.0f);
    const auto blocks =
        visible_blocks(terrain, eye, look_at(eye, {0.0f, 0.0f, 0.0f}), perspective(80.0, 1.5, 0.5, 3000.0));
    REQUIRE(blocks.size() > 100);
    // Along a row or column away from the eye's, distances grow.
    std::map<std::ptrdiff_t, float> farthest_in_row;
    for (const TerrainBlock* block : blocks) {
        const std::ptrdiff_t index = block - terrain.blocks.data();
        if (block->low.x < eye.x) continue;
        const auto [row, is_first] = farthest_in_row.try_emplace(index / TerrainBlocks::kBlocks, block->low.x);
        CHECK((is_first || block->low.x > row->second));
        row->second = block->low.x;
    }
}

TEST_CASE("each triangle of the terrain is drawn opaque once, and overlays lie exactly on some", "[demo][terrain]") {
    const Scene& scene = canyon();
    double area        = 0.0;
    std::size_t base = 0, over = 0;
    for (const TerrainBlock& block : scene.geometry.terrain.blocks) {
        const auto ground = triangles_of(scene, block.ground), walls = triangles_of(scene, block.walls);
        REQUIRE(ground.size() * 3 == block.ground.size());
        REQUIRE(walls.size() * 3 == block.walls.size());
        for (const auto* triangles : {&ground, &walls})
            for (const auto& [a, b, c] : *triangles) {
                const auto [ax, ay, az] = a;
                const auto [bx, by, bz] = b;
                const auto [cx, cy, cz] = c;
                area += 0.5 * ((static_cast<double>(bz) - az) * (static_cast<double>(cx) - ax) -
                               (static_cast<double>(cz) - az) * (static_cast<double>(bx) - ax));
            }
        for (const auto& triangle : triangles_of(scene, block.overlays))
            REQUIRE((ground.count(triangle) == 1) != (walls.count(triangle) == 1));
        base += ground.size() + walls.size();
        over += block.overlays.size() / 3;
        for (const auto* indices : {&block.ground, &block.walls, &block.overlays})
            for (const std::uint32_t index : *indices) {
                const Vec3& p = scene.geometry.vertices[index].position;
                for (int axis = 0; axis < 3; ++axis)
                    REQUIRE((p[axis] >= block.low[axis] && p[axis] <= block.high[axis]));
            }
    }
    CHECK(area == Approx(3200.0 * 3200.0).epsilon(1e-5));
    CHECK(over > 100);
    CHECK(over < base / 2);
}

// Where an overlay ends within rock, it must have become what lies beside it; where it ends on the ground, nothing.
TEST_CASE("overlays begin and end without a step", "[demo][terrain]") {
    const Scene& scene  = canyon();
    const auto alpha_of = [&](std::uint32_t index) { return scene.geometry.vertices[index].diffuse.value >> 24; };
    std::size_t whole = 0, none = 0;
    for (const TerrainBlock& block : scene.geometry.terrain.blocks) {
        std::set<Position> on_ground_only, on_rock_only;
        const auto overlays = triangles_of(scene, block.overlays);
        const auto add      = [&](const std::vector<std::uint32_t>& indices, std::set<Position>& alone) {
            for (std::size_t i = 0; i < indices.size(); i += 3) {
                const std::array<Position, 3> triangle{position_of(scene, indices[i]),
                                                       position_of(scene, indices[i + 1]),
                                                       position_of(scene, indices[i + 2])};
                if (overlays.count(triangle) == 0) alone.insert(triangle.begin(), triangle.end());
            }
        };
        add(block.ground, on_ground_only);
        add(block.walls, on_rock_only);
        std::map<Position, std::uint32_t> strongest;
        for (const std::uint32_t index : block.overlays) {
            std::uint32_t& alpha = strongest[position_of(scene, index)];
            alpha                = std::max(alpha, alpha_of(index));
        }
        for (const auto& [p, alpha] : strongest) {
            if (on_ground_only.count(p) == 0) continue;
            REQUIRE(alpha == 0);
            ++none;
        }
        const auto ground = triangles_of(scene, block.ground);
        for (std::size_t i = 0; i < block.overlays.size(); i += 3) {
            const std::array<Position, 3> triangle{position_of(scene, block.overlays[i]),
                                                   position_of(scene, block.overlays[i + 1]),
                                                   position_of(scene, block.overlays[i + 2])};
            if (ground.count(triangle) == 0) continue;
            for (const Position& p : triangle)
                if (on_rock_only.count(p) == 1) {
                    REQUIRE(strongest[p] == 255);
                    ++whole;
                }
        }
    }
    CHECK(whole > 100);
    CHECK(none > 100);
}

TEST_CASE("a closed grid is split alike at its seam", "[demo][terrain]") {
    // A bump on the last column only: the first must be split as well.
    const auto error = [](GridPoint, GridPoint, GridPoint m) { return m.column == 8 && m.row == 3 ? 5.0f : 0.0f; };
    for (const bool closed : {false, true}) {
        const TriangleMesh mesh = halve_right_triangles(8, closed, error);
        std::set<int> first, last;
        for (const std::uint32_t point : mesh.points) {
            const int column = static_cast<int>(point) % 9, row = static_cast<int>(point) / 9;
            if (column == 0) first.insert(row);
            if (column == 8) last.insert(row);
        }
        CHECK(last.count(3) == 1);
        CHECK((first == last) == closed);
    }
    CHECK(halve_right_triangles(8, false, [](GridPoint, GridPoint, GridPoint) { return 0.0f; }).triangles.size() == 2);
    CHECK(halve_right_triangles(8, true, [](GridPoint, GridPoint, GridPoint) { return 2.0f; }).triangles.size() == 128);
}

// A middle is needed if it is too far off, or if the middle of a half of one of its triangles is.
TEST_CASE("a grid keeps the middles that are too far off, and those that they need", "[demo][terrain]") {
    constexpr int kCells = 16, kPoints = kCells + 1;
    const bool closed = GENERATE(false, true);
    std::mt19937 random(GENERATE(1, 2, 3, 4, 5, 6));
    std::vector<float> errors(kPoints * kPoints, 0.0f);
    for (float& error : errors) error = random() % 25 == 0 ? 1.5f : 0.5f;
    const auto index = [](GridPoint p) { return p.row * kPoints + p.column; };

    std::set<int> needed;
    std::size_t before = 1;
    // Whether its middle is needed.
    const auto visit   = [&](auto&& self, GridPoint a, GridPoint b, GridPoint c) -> bool {
        if (std::abs(a.column - c.column) + std::abs(a.row - c.row) <= 1) return false;
        const GridPoint m{(a.column + b.column) / 2, (a.row + b.row) / 2};
        const bool left = self(self, c, a, m), right = self(self, b, c, m);
        const GridPoint seam{kCells - m.column, m.row};
        const bool at_seam = closed && (m.column == 0 || m.column == kCells);
        if (left || right || errors[index(m)] > 1.0f ||
            (at_seam && (errors[index(seam)] > 1.0f || needed.count(index(seam)) > 0)))
            needed.insert(index(m));
        return needed.count(index(m)) > 0;
    };
    while (before != needed.size()) {
        before = needed.size();
        visit(visit, {0, 0}, {kCells, kCells}, {kCells, 0});
        visit(visit, {kCells, kCells}, {0, 0}, {0, kCells});
    }
    for (const GridPoint corner : {GridPoint{0, 0}, {kCells, 0}, {0, kCells}, {kCells, kCells}})
        needed.insert(index(corner));

    const TriangleMesh mesh = halve_right_triangles(
        kCells, closed, [&](GridPoint, GridPoint, GridPoint middle) { return errors[index(middle)]; });
    CHECK(std::set<int>(mesh.points.begin(), mesh.points.end()) == needed);
    CHECK(needed.size() < errors.size());
}

}  // namespace demo
