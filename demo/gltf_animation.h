// SPDX-License-Identifier: MIT
// The animations of a glTF file: keys of its nodes' translation, rotation and scale over seconds. Before its first
// key a property has that key's value, after its last key that one's. All animations play at once, since Blender's
// exporter writes one for each moved object; where two move the same property, the first counts. Morph weights are
// left out.
//
// Rotations between keys are interpolated linearly and made unit again, not along the circle (slerp), as glTF asks:
// that needs sine and arc cosine, which differ between C libraries, and this is + - * / and sqrt. Both meet at the
// keys and half way. The difference is below 0.005 degrees where keys lie 15 degrees apart, 0.035 at 30 and 0.92 at
// 90; Blender bakes a key for each frame. Only gltf_*.cpp include this.
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <map>
#include <optional>
#include <vector>

#include "demo/gltf_file.h"
#include "demo/gltf_nodes.h"

namespace demo {

enum class Interpolation : std::uint8_t { Step, Linear, CubicSpline };

// One property of one node. values: x, y, z and, of quaternions, w; for CubicSpline three a key: the tangent that
// arrives, the value, the tangent that leaves.
struct Curve {
    Interpolation interpolation = Interpolation::Linear;
    bool is_rotation            = false;
    std::vector<double> times;  // seconds, ascending, at least one
    std::vector<glm::dvec4> values;

    glm::dvec4 at(double seconds) const;
};

struct NodeCurves {
    std::optional<Curve> translation, rotation, scale;

    void apply(LocalTransform& transform, double seconds) const;
    double duration() const;  // time of the last key
};

// By node of the file. SceneError for keys that make no sense.
std::map<int, NodeCurves> read_curves(GltfFile& file);

}  // namespace demo
