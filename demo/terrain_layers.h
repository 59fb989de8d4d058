// SPDX-License-Identifier: MIT
// What covers a terrain, triangle by triangle. Level ground is sand; rock is projected along x or along z, whichever it
// faces, so that no texture is stretched and strata run level through every wall. A triangle whose corners agree is
// drawn once, opaque. Only where they differ, a second and rarely a third layer lies over the first by the vertices'
// alpha.
#pragma once

#include <vector>

#include "demo/height_field.h"
#include "demo/right_triangles.h"
#include "demo/terrain_blocks.h"
#include "pipeline/frame/frame.h"

namespace demo {

// A corner of the mesh. Lights are factors of the texture's colour.
struct TerrainPoint {
    int column, row;  // of the grid
    Vec3 position, normal;
    Vec3 ground_light, rock_light;
    float rock;    // share: 0 ground .. 1 rock
    bool faces_z;  // rather than x
};

// What the textures' tiles cover, in metres.
struct TerrainTiles {
    Vec2 ground_m, detail_m, rock_m;
};

// Appends the vertices and returns the blocks, without textures. The corners of the mesh's triangles are indices into
// `points`.
TerrainBlocks append_terrain_blocks(std::vector<pipeline::Vertex>& vertices, const HeightField& field,
                                    const TriangleMesh& mesh, const std::vector<TerrainPoint>& points,
                                    const TerrainTiles& tiles);

}  // namespace demo
