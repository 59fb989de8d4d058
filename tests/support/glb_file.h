// SPDX-License-Identifier: MIT
// A small glTF 2.0 file made by hand, as Blender's exporter writes it: one buffer, a view for each accessor, nodes with
// quaternions x, y, z, w. What it holds may be wrong: the document is there to be damaged.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace tests {

using Json = nlohmann::ordered_json;

// Component types of accessors.
inline constexpr int kUnsignedByte = 5121, kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126;

struct GlbFile {
    Json document;  // asset, and a scene without nodes
    std::string binary;

    GlbFile();

    // Each returns the index of what it adds.
    int view(const std::string& bytes);
    int floats(const std::string& type, const std::vector<float>& values);  // with least and greatest, as exporters do
    int integers(int component_type, const std::string& type, const std::vector<std::uint32_t>& values,
                 bool is_normalized = false);
    int add(const std::string& list, Json entry);
    int root(Json node);  // a node of the scene
    // A channel of the first animation.
    void animate(int node, const std::string& path, const std::string& interpolation, const std::vector<float>& times,
                 const std::vector<float>& values);

    std::string glb() const;
    std::string gltf() const;  // with its buffer in a data URI
};

// The two chunks, padded, behind their headers. No BIN chunk, if binary is empty.
std::string glb_bytes(const std::string& json, const std::string& binary);

}  // namespace tests
