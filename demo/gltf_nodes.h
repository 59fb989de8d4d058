// SPDX-License-Identifier: MIT
// The nodes of a glTF file's default scene (the first, if it names none; all nodes, if it has no scenes), and where
// they stand. Matrices are doubles made by + - * / and sqrt in a fixed order. Only gltf_*.cpp include this.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "demo/gltf_file.h"

namespace demo {

// What a node does to its children: a matrix, or scale, then rotation, then translation.
struct LocalTransform {
    glm::dvec3 translation = glm::dvec3(0.0);
    glm::dvec4 rotation    = glm::dvec4(0.0, 0.0, 0.0, 1.0);  // unit quaternion x, y, z, w
    glm::dvec3 scale       = glm::dvec3(1.0);
    std::optional<glm::dmat4> matrix;
};
glm::dmat4 matrix_of(const LocalTransform& transform);

struct SceneNode {
    int index  = 0;   // in the file
    int parent = -1;  // in the list of scene_nodes, before this one; -1: none
    LocalTransform rest;
};

// Parents stand before their children. SceneError for nodes that are not there, that have two parents or are their own
// ancestors, and for rotations of length 0.
std::vector<SceneNode> scene_nodes(const GltfFile& file);

// Nodes that are mega-particles by their name: "particle", "Particle.001".
bool is_particle(std::string_view name);

// For complaints: "node 'Cube.001'", or by its index if it has no name.
std::string node_name(const GltfFile& file, int index);

}  // namespace demo
