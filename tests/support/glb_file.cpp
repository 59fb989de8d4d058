// SPDX-License-Identifier: MIT
#include "tests/support/glb_file.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace tests {
namespace {

std::string little_endian(std::uint32_t value, int bytes = 4) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 255);
    return text;
}

std::string padded(std::string bytes, char with) {
    bytes.append((4 - bytes.size() % 4) % 4, with);
    return bytes;
}

std::size_t components_of(const std::string& type) {
    return type == "SCALAR" ? 1 : static_cast<std::size_t>(type.back() - '0');
}

// RFC 4648.
std::string base64(const std::string& bytes) {
    static const char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t word      = 0;
        for (std::size_t k = 0; k < 3; ++k)
            word = word << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += k <= count ? kDigits[word >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

}  // namespace

GlbFile::GlbFile() {
    document["asset"]  = {{"generator", "Khronos glTF Blender I/O v3.6.28"}, {"version", "2.0"}};
    document["scene"]  = 0;
    document["scenes"] = Json::array({{{"name", "Scene"}, {"nodes", Json::array()}}});
}

int GlbFile::view(const std::string& bytes) {
    const std::size_t offset = binary.size();
    binary += padded(bytes, '\0');
    return add("bufferViews", {{"buffer", 0}, {"byteLength", bytes.size()}, {"byteOffset", offset}});
}

int GlbFile::floats(const std::string& type, const std::vector<float>& values) {
    const std::size_t components = components_of(type);
    std::vector<float> least(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(components));
    std::vector<float> greatest = least;
    for (std::size_t i = 0; i < values.size(); ++i) {
        least[i % components]    = std::min(least[i % components], values[i]);
        greatest[i % components] = std::max(greatest[i % components], values[i]);
    }
    const std::string bytes(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
    return add("accessors", {{"bufferView", view(bytes)},
                             {"componentType", kFloat},
                             {"count", values.size() / components},
                             {"max", greatest},
                             {"min", least},
                             {"type", type}});
}

int GlbFile::integers(int component_type, const std::string& type, const std::vector<std::uint32_t>& values,
                      bool is_normalized) {
    const int bytes_each = component_type == kUnsignedByte ? 1 : component_type == kUnsignedShort ? 2 : 4;
    std::string bytes;
    for (const std::uint32_t value : values) bytes += little_endian(value, bytes_each);
    Json accessor = {{"bufferView", view(bytes)},
                     {"componentType", component_type},
                     {"count", values.size() / components_of(type)},
                     {"type", type}};
    if (is_normalized) accessor["normalized"] = true;
    return add("accessors", accessor);
}

int GlbFile::add(const std::string& list, Json entry) {
    document[list].push_back(std::move(entry));
    return static_cast<int>(document[list].size()) - 1;
}

int GlbFile::root(Json node) {
    const int index = add("nodes", std::move(node));
    document["scenes"][0]["nodes"].push_back(index);
    return index;
}

void GlbFile::animate(int node, const std::string& path, const std::string& interpolation,
                      const std::vector<float>& times, const std::vector<float>& values) {
    const int input           = floats("SCALAR", times);
    const int output          = floats(path == "rotation" ? "VEC4" : "VEC3", values);
    // Built anew, since a reference into an ordered object does not outlive the next key.
    Json animation            = document.contains("animations") ? document["animations"][0] : Json{{"name", "Action"}};
    const std::size_t sampler = animation.contains("samplers") ? animation["samplers"].size() : 0;
    animation["channels"].push_back({{"sampler", sampler}, {"target", {{"node", node}, {"path", path}}}});
    animation["samplers"].push_back({{"input", input}, {"interpolation", interpolation}, {"output", output}});
    document["animations"] = Json::array({animation});
}

std::string GlbFile::glb() const {
    Json whole = document;
    if (!binary.empty() && !whole.contains("buffers")) whole["buffers"].push_back({{"byteLength", binary.size()}});
    return glb_bytes(whole.dump(), binary);
}

std::string GlbFile::gltf() const {
    Json whole = document;
    whole["buffers"].push_back(
        {{"byteLength", binary.size()}, {"uri", "data:application/octet-stream;base64," + base64(binary)}});
    return whole.dump();
}

std::string glb_bytes(const std::string& json, const std::string& binary) {
    const auto chunk = [](const std::string& type, const std::string& bytes) {
        return little_endian(static_cast<std::uint32_t>(bytes.size())) + type + bytes;
    };
    std::string chunks = chunk("JSON", padded(json, ' '));
    if (!binary.empty()) chunks += chunk(std::string("BIN\0", 4), padded(binary, '\0'));
    return "glTF" + little_endian(2) + little_endian(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

}  // namespace tests
