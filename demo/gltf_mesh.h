// SPDX-License-Identifier: MIT
// Scene geometry from a glTF file: the triangles of all meshes of its default scene, where its nodes put them at
// rest. Lengths in metres, y up, triangles counter-clockwise seen from outside (mirrored nodes too).
//
// Read: TRIANGLES, TRIANGLE_STRIP and TRIANGLE_FAN, with or without indices; POSITION, NORMAL (flat triangles where
// there is none), COLOR_0, the base colour's factor and picture, and the TEXCOORD set that the picture asks for. Left
// out: points and lines, nodes that are mega-particles by their name (gltf_particles.h), skins (meshes keep their
// bind pose), morph targets, animations, cameras, lights, alpha modes, all other properties of materials. Factors are
// taken as they are, although glTF's are linear light and its pictures are not.
#pragma once

#include <cstdint>
#include <vector>

#include "demo/scene_data.h"

namespace demo {

inline constexpr std::size_t kMaxGltfTriangles = std::size_t{1} << 20;

// uv: 0..1 spans the texture, v downwards. color: the material's factor times the vertex's colour; clamped to 0..1.
struct GltfVertex {
    Vec3 position = Vec3(0.0f), normal = Vec3(0.0f, 1.0f, 0.0f);
    Vec2 uv    = Vec2(0.0f);
    Vec3 color = Vec3(1.0f);
};

// What shares a texture: an index into GltfMesh::textures, -1 for none.
struct GltfPart {
    std::vector<GltfVertex> vertices;
    std::vector<std::uint32_t> indices;  // three a triangle, into vertices
    int texture = -1;
};

struct GltfMesh {
    std::vector<pipeline::Texture> textures;
    std::vector<GltfPart> parts;  // none is empty
};

// SceneError for a file that cannot be used: also for one without a triangle, and for coordinates beyond 1e5 m.
GltfMesh read_gltf_mesh(const FileReference& file);

}  // namespace demo
