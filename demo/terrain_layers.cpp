// SPDX-License-Identifier: MIT
#include "demo/terrain_layers.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <glm/common.hpp>

#include "demo/terrain_mesh.h"
#include "demo/texture_pyramid.h"

namespace demo {
namespace {

enum Layer { Ground, RockAlongX, RockAlongZ, kLayers };

// Which layers a triangle shows: one opaque, the others over it, in order.
struct Cover {
    Layer base;
    bool along_x_over = false, along_z_over = false;
};

Cover cover_of(const TerrainPoint& a, const TerrainPoint& b, const TerrainPoint& c) {
    bool all_rock = true, along_x = false, along_z = false;
    for (const TerrainPoint* point : {&a, &b, &c}) {
        all_rock = all_rock && point->rock >= 1.0f;
        if (point->rock > 0.0f) (point->faces_z ? along_z : along_x) = true;
    }
    if (!all_rock) return {Ground, along_x, along_z};
    if (!along_x) return {RockAlongZ};
    return {RockAlongX, false, along_z};
}

// A layer's weight at a point over the layers below it. Rock along x is whole below whole rock along z, so that no
// ground shows through where the two meet.
float weight(Layer layer, const TerrainPoint& point) {
    switch (layer) {
        case RockAlongX:
            return point.faces_z && point.rock < 1.0f ? 0.0f : point.rock;
        case RockAlongZ:
            return point.faces_z ? point.rock : 0.0f;
        default:
            return 1.0f;
    }
}

using Triangle = std::array<std::uint32_t, 3>;

class BlockBuilder {
  public:
    BlockBuilder(std::vector<pipeline::Vertex>& vertices, const std::vector<TerrainPoint>& points,
                 const TerrainTiles& tiles)
        : vertices_(vertices), points_(points), tiles_(tiles), copies_(points.size() * kLayers, 0) {}

    TerrainBlock build(const std::vector<Triangle>& triangles) {
        first_vertex_ = static_cast<std::uint32_t>(vertices_.size());
        std::vector<std::uint32_t> over_rock;
        TerrainBlock block;
        block.low = block.high = points_[triangles[0][0]].position;
        for (const Triangle& triangle : triangles) {
            for (const std::uint32_t corner : triangle) {
                block.low  = glm::min(block.low, points_[corner].position);
                block.high = glm::max(block.high, points_[corner].position);
            }
            const Cover cover = cover_of(points_[triangle[0]], points_[triangle[1]], points_[triangle[2]]);
            add(triangle, cover.base, cover.base == Ground ? block.ground : block.walls);
            if (cover.along_x_over) add(triangle, RockAlongX, block.overlays);
            if (cover.along_z_over) add(triangle, RockAlongZ, over_rock);
        }
        block.overlays.insert(block.overlays.end(), over_rock.begin(), over_rock.end());
        return block;
    }

  private:
    void add(const Triangle& triangle, Layer layer, std::vector<std::uint32_t>& indices) {
        for (const std::uint32_t corner : triangle) indices.push_back(copy(corner, layer));
    }

    // Vertices are shared within a block and not beyond, so that a block's vertices lie together.
    std::uint32_t copy(std::uint32_t point, Layer layer) {
        std::uint32_t& known = copies_[point * kLayers + layer];
        if (known <= first_vertex_) {
            vertices_.push_back(vertex(points_[point], layer));
            known = static_cast<std::uint32_t>(vertices_.size());
        }
        return known - 1;
    }

    pipeline::Vertex vertex(const TerrainPoint& point, Layer layer) const {
        const Vec3& p = point.position;
        pipeline::Vertex vertex;
        vertex.position = p;
        vertex.normal   = point.normal;
        vertex.diffuse  = to_argb(layer == Ground ? point.ground_light : point.rock_light, weight(layer, point));
        if (layer == Ground) {
            // Turned by atan(1/2), so that the two tiles' edges never line up.
            constexpr float kCosine = 0.89442719f, kSine = 0.44721360f;
            vertex.uv0 = Vec2(p.x, p.z) / tiles_.ground_m;
            vertex.uv1 = Vec2(kCosine * p.x + kSine * p.z, kCosine * p.z - kSine * p.x) / tiles_.detail_m;
        } else {
            vertex.uv0 = Vec2(layer == RockAlongZ ? p.x : p.z, -p.y) / tiles_.rock_m;  // y runs up, v down
        }
        return vertex;
    }

    std::vector<pipeline::Vertex>& vertices_;
    const std::vector<TerrainPoint>& points_;
    const TerrainTiles& tiles_;
    std::vector<std::uint32_t> copies_;  // of each point in each layer: 1 + the vertex; older ones are another block's
    std::uint32_t first_vertex_ = 0;
};

// Sets the mesh's height at the grid points of some rows, from the first triangle to the last.
void set_heights(const std::vector<Triangle>& triangles, const std::vector<TerrainPoint>& points, int first_row,
                 int last_row, std::vector<float>& heights) {
    for (const Triangle& triangle : triangles) {
        const TerrainPoint &a = points[triangle[0]], &b = points[triangle[1]], &c = points[triangle[2]];
        // Twice the area that p makes with each side, whole numbers; the corners run counter-clockwise, rows downwards.
        const auto area = [](int px, int py, const TerrainPoint& from, const TerrainPoint& to) {
            return (px - from.column) * (to.row - from.row) - (py - from.row) * (to.column - from.column);
        };
        const auto [west, east]   = std::minmax({a.column, b.column, c.column});
        const auto [north, south] = std::minmax({a.row, b.row, c.row});
        if (south < first_row || north > last_row) continue;
        const auto whole = static_cast<float>(area(c.column, c.row, a, b));
        for (int row = std::max(north, first_row); row <= std::min(south, last_row); ++row)
            for (int column = west; column <= east; ++column) {
                const int at_a = area(column, row, b, c), at_b = area(column, row, c, a),
                          at_c = area(column, row, a, b);
                if (at_a < 0 || at_b < 0 || at_c < 0) continue;
                heights[row * HeightField::kPoints + column] =
                    (static_cast<float>(at_a) * a.position.y + static_cast<float>(at_b) * b.position.y +
                     static_cast<float>(at_c) * c.position.y) /
                    whole;
            }
    }
}

// Height of the mesh at every grid point, which is the field's only where the mesh has a corner.
std::vector<float> mesh_heights(const std::vector<Triangle>& triangles, const std::vector<TerrainPoint>& points) {
    constexpr int kPoints = HeightField::kPoints, kBands = 4;
    std::vector<float> heights(kPoints * kPoints, 0.0f);
    tbb::parallel_for(0, kBands, [&](int band) {
        set_heights(triangles, points, band * kPoints / kBands, (band + 1) * kPoints / kBands - 1, heights);
    });
    return heights;
}

// Between neighbouring grid points on a line the surface is straight: its edges run along the grid or across its cells
// at 45 degrees. So it is lowest and highest at grid points.
void bound_heights(TerrainBlocks& terrain, const std::vector<float>& heights) {
    constexpr int kStep = HeightField::kCells / TerrainBlocks::kSteps, kPoints = HeightField::kPoints;
    constexpr float kRounding  = 0.01f;
    const auto lowest_on_ridge = [&](int first, int step) {
        float low = heights[first];
        for (int i = 1; i <= 2 * kStep; ++i) low = std::min(low, heights[first + i * step]);
        return low - kRounding;
    };
    for (int line = 0; line < kPoints; line += 2 * kStep)
        for (int i = 0; i < TerrainBlocks::kRidges; ++i) {
            terrain.along_x.push_back(lowest_on_ridge(line * kPoints + i * kStep, 1));
            terrain.along_z.push_back(lowest_on_ridge(i * kStep * kPoints + line, kPoints));
        }
    for (int row = 0; row + kStep < kPoints; row += kStep)
        for (int column = 0; column + kStep < kPoints; column += kStep) {
            float high = heights[row * kPoints + column];
            for (int j = row; j <= row + kStep; ++j)
                for (int i = column; i <= column + kStep; ++i) high = std::max(high, heights[j * kPoints + i]);
            terrain.highest.push_back(high + kRounding);
        }
}

}  // namespace

TerrainBlocks append_terrain_blocks(std::vector<pipeline::Vertex>& vertices, const HeightField& field,
                                    const TriangleMesh& mesh, const std::vector<TerrainPoint>& points,
                                    const TerrainTiles& tiles) {
    constexpr int kBlocks = TerrainBlocks::kBlocks, kBlockCells = HeightField::kCells / kBlocks;
    static_assert(kBlockCells % kLongestEdge == 0);
    std::vector<std::vector<Triangle>> triangles(kBlocks * kBlocks);
    for (const Triangle& triangle : mesh.triangles) {
        // The corners' mean never lies on a line between blocks.
        int column = 0, row = 0;
        for (const std::uint32_t corner : triangle) {
            column += points[corner].column;
            row += points[corner].row;
        }
        triangles[row / (3 * kBlockCells) * kBlocks + column / (3 * kBlockCells)].push_back(triangle);
    }
    TerrainBlocks terrain;
    for (int line = 0; line <= HeightField::kCells; line += HeightField::kCells / TerrainBlocks::kSteps) {
        terrain.x_lines.push_back(field.x_at(line));
        terrain.z_lines.push_back(field.z_at(line));
    }
    BlockBuilder builder(vertices, points, tiles);
    tbb::parallel_invoke([&] { bound_heights(terrain, mesh_heights(mesh.triangles, points)); },
                         [&] {
                             for (const auto& block : triangles) terrain.blocks.push_back(builder.build(block));
                         });
    return terrain;
}

}  // namespace demo
