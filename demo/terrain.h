// SPDX-License-Identifier: MIT
// The terrain of a scene: its height field, and its triangles, lit, coloured and covered with textures.
#pragma once

#include "demo/bake_light.h"
#include "demo/height_field.h"
#include "demo/scene_data.h"

namespace demo {

HeightField terrain_heights(const Terrain& terrain);

// Appends to `geometry` the vertices and textures of the terrain, and sets its blocks.
void append_terrain(SceneGeometry& geometry, const Terrain& terrain, const HeightField& field,
                    const Surroundings& around, const cloud::Daylight& light);

}  // namespace demo
