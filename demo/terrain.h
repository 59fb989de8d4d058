// SPDX-License-Identifier: MIT
// The terrain of a scene: its height field, and its lit triangles in layers. The ground's texture lies level on all of
// it; walls get theirs projected along x and along z, laid over by the vertices' alpha, so that no texture is stretched
// and strata run level through every wall.
#pragma once

#include "demo/bake_light.h"
#include "demo/height_field.h"
#include "demo/scene_data.h"

namespace demo {

HeightField terrain_heights(const Terrain& terrain);

// Appends to `geometry` the vertices, indices, and textures of the terrain, and sets its ground, walls and variation.
void append_terrain(SceneGeometry& geometry, const Terrain& terrain, const HeightField& field,
                    const Surroundings& around, const cloud::Daylight& light);

}  // namespace demo
