// SPDX-License-Identifier: MIT
// Solid objects of a scene as triangles, counter-clockwise seen from outside. Lengths in metres, y up.
#pragma once

#include <cstdint>
#include <vector>

#include "demo/bake_light.h"
#include "demo/scene_data.h"

namespace demo {

// Before light: uv in metres (u along the surface, v downwards from y = 0), so that a texture's tile size scales it.
struct SolidVertex {
    Vec3 position, normal;
    Vec2 uv_m;
    float open_sky;  // 0..1: less in a tower's clefts
};
struct SolidMesh {
    std::vector<SolidVertex> vertices;
    std::vector<std::uint32_t> indices;
};

SolidMesh solid_mesh(const Solid& solid);

// The columns that stand for a solid when shadows are cast; none for one too thin to matter.
std::vector<ShadowColumn> shadow_columns(const Solid& solid);

}  // namespace demo
