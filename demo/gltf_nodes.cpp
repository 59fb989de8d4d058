// SPDX-License-Identifier: MIT
#include "demo/gltf_nodes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <string>

#include "demo/gltf_check.h"

namespace demo {
namespace {

glm::dvec3 vec3_of(const std::vector<double>& numbers, const glm::dvec3& otherwise) {
    return numbers.empty() ? otherwise : glm::dvec3(numbers[0], numbers[1], numbers[2]);
}

LocalTransform rest_of(const GltfFile& file, int index) {
    const tinygltf::Node& node = file.model().nodes[static_cast<std::size_t>(index)];
    LocalTransform rest;
    if (!node.matrix.empty()) {
        rest.matrix.emplace();
        for (int i = 0; i < 16; ++i) (*rest.matrix)[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
        const glm::dmat4& matrix = *rest.matrix;
        const bool is_affine = matrix[0][3] == 0.0 && matrix[1][3] == 0.0 && matrix[2][3] == 0.0 && matrix[3][3] == 1.0;
        if (!is_affine) file.fail(node_name(file, index) + ": the last row of its matrix is not 0 0 0 1");
        return rest;
    }
    rest.translation = vec3_of(node.translation, rest.translation);
    rest.scale       = vec3_of(node.scale, rest.scale);
    if (!node.rotation.empty()) {
        const std::vector<double>& numbers = node.rotation;
        const glm::dvec4 rotation(numbers[0], numbers[1], numbers[2], numbers[3]);
        const double squared = glm::dot(rotation, rotation);
        if (!(squared > 1e-12 && squared < 1e12)) file.fail(node_name(file, index) + ": its rotation is no quaternion");
        rest.rotation = rotation / std::sqrt(squared);
    }
    return rest;
}

// The parent of each node of the file, -1 for none.
std::vector<int> parents_of(const GltfFile& file) {
    const std::vector<tinygltf::Node>& nodes = file.model().nodes;
    std::vector<int> parents(nodes.size(), -1);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (const int child : nodes[i].children) {
            const std::string name = "nodes[" + std::to_string(i) + "].children";
            file.find(nodes, child, name + " names no node");
            int& parent = parents[static_cast<std::size_t>(child)];
            if (parent >= 0) file.fail(node_name(file, child) + " has two parents");
            parent = static_cast<int>(i);
        }
    }
    return parents;
}

std::vector<int> roots_of(const GltfFile& file, const std::vector<int>& parents) {
    const tinygltf::Model& model = file.model();
    std::vector<int> roots;
    if (model.scenes.empty()) {
        for (std::size_t i = 0; i < parents.size(); ++i)
            if (parents[i] < 0) roots.push_back(static_cast<int>(i));
        return roots;
    }
    roots = file.find(model.scenes, std::max(model.defaultScene, 0), "scene names no scene").nodes;
    for (const int root : roots) {
        file.find(model.nodes, root, "a scene's list of nodes names no node");
        if (parents[static_cast<std::size_t>(root)] >= 0)
            file.fail(node_name(file, root) + " has a parent and is a scene's root");
    }
    std::vector<int> sorted = roots;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) file.fail("a scene lists a node twice");
    return roots;
}

// With one parent each, nodes that no parentless one leads to go round in a circle.
void check_no_cycle(const GltfFile& file, const std::vector<int>& parents) {
    std::vector<int> reached;
    for (std::size_t i = 0; i < parents.size(); ++i)
        if (parents[i] < 0) reached.push_back(static_cast<int>(i));
    for (std::size_t i = 0; i < reached.size(); ++i) {
        const std::vector<int>& children = file.model().nodes[static_cast<std::size_t>(reached[i])].children;
        reached.insert(reached.end(), children.begin(), children.end());
    }
    if (reached.size() < parents.size()) file.fail("a node is its own ancestor");
}

}  // namespace

glm::dmat4 matrix_of(const LocalTransform& transform) {
    if (transform.matrix) return *transform.matrix;
    const double x = transform.rotation.x, y = transform.rotation.y, z = transform.rotation.z, w = transform.rotation.w;
    const glm::dvec3 axis_x(1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + z * w), 2.0 * (x * z - y * w));
    const glm::dvec3 axis_y(2.0 * (x * y - z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + x * w));
    const glm::dvec3 axis_z(2.0 * (x * z + y * w), 2.0 * (y * z - x * w), 1.0 - 2.0 * (x * x + y * y));
    return {glm::dvec4(axis_x * transform.scale.x, 0.0), glm::dvec4(axis_y * transform.scale.y, 0.0),
            glm::dvec4(axis_z * transform.scale.z, 0.0), glm::dvec4(transform.translation, 1.0)};
}

std::vector<SceneNode> scene_nodes(const GltfFile& file) {
    const std::vector<int> parents = parents_of(file);
    check_no_cycle(file, parents);
    std::vector<SceneNode> nodes;
    for (const int root : roots_of(file, parents))
        nodes.push_back({.index = root, .parent = -1, .rest = rest_of(file, root)});
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (const int child : file.model().nodes[static_cast<std::size_t>(nodes[i].index)].children)
            nodes.push_back({.index = child, .parent = static_cast<int>(i), .rest = rest_of(file, child)});
    return nodes;
}

bool is_particle(std::string_view name) {
    constexpr std::string_view kStart = "particle";
    if (name.size() < kStart.size()) return false;
    return std::equal(kStart.begin(), kStart.end(), name.begin(), [](char wanted, char c) {
        return c == wanted || (c >= 'A' && c <= 'Z' && static_cast<char>(c - 'A' + 'a') == wanted);
    });
}

std::string node_name(const GltfFile& file, int index) {
    const std::string& name = file.model().nodes[static_cast<std::size_t>(index)].name;
    return name.empty() ? "nodes[" + std::to_string(index) + "]" : "node " + in_quotes(name);
}

}  // namespace demo
