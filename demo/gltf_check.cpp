// SPDX-License-Identifier: MIT
#include "demo/gltf_check.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace demo {
namespace {

using nlohmann::json;

// tinygltf reads `extras` by recursion and keeps some 200 bytes for each value in them.
constexpr int kMaxDepth      = 64;
constexpr int kMaxJsonValues = 1 << 21;

[[noreturn]] void fail(const std::string& reason) {
    throw std::runtime_error(reason);
}

// GLB (glTF 2.0, section 4): "glTF", version, length; then chunks of length, type, bytes. All words little-endian.
constexpr std::size_t kHeaderBytes = 12, kChunkHeaderBytes = 8;
constexpr std::uint32_t kJsonChunk = 0x4e4f534a, kBinChunk = 0x004e4942;

std::uint32_t word_at(std::string_view bytes, std::size_t offset) {
    std::uint32_t word = 0;
    for (std::size_t i = 4; i-- > 0;) word = word << 8 | static_cast<unsigned char>(bytes[offset + i]);
    return word;
}

// The JSON chunk of a GLB.
std::string_view json_of_glb(std::string_view bytes) {
    if (bytes.size() < kHeaderBytes + kChunkHeaderBytes) fail("the file is cut off");
    if (word_at(bytes, 4) != 2) fail("is glTF of version " + std::to_string(word_at(bytes, 4)) + " (2 is known)");
    if (word_at(bytes, 8) != bytes.size()) {
        fail("the file has " + std::to_string(bytes.size()) + " bytes and says it has " +
             std::to_string(word_at(bytes, 8)));
    }
    std::string_view text;
    std::size_t offset = kHeaderBytes;
    for (int chunk = 0; offset < bytes.size(); ++chunk) {
        if (bytes.size() - offset < kChunkHeaderBytes) fail("the file is cut off");
        const std::size_t length = word_at(bytes, offset);
        const std::uint32_t type = word_at(bytes, offset + 4);
        offset += kChunkHeaderBytes;
        if (length > bytes.size() - offset) fail("a chunk is longer than the file");
        if (length % 4 != 0) fail("a chunk's length is no multiple of 4");
        if (chunk == 0 && type != kJsonChunk) fail("the first chunk is not JSON");
        if (chunk == 1 && type != kBinChunk) fail("the second chunk is not BIN");
        if (chunk == 0) text = bytes.substr(offset, length);
        offset += length;
    }
    return text;
}

json parse(std::string_view text) {
    int values      = 0;
    const auto look = [&](int depth, json::parse_event_t, json&) {
        if (depth > kMaxDepth) fail("the JSON is nested too deeply");
        if (++values > 2 * kMaxJsonValues) fail("the JSON holds too many values");
        return true;
    };
    try {
        return json::parse(text, look);
    } catch (const json::parse_error& error) {
        fail("is not a glTF file: malformed JSON at byte " + std::to_string(error.byte));
    } catch (const json::exception&) {
        fail("is not a glTF file: the JSON holds a number that is too large");
    }
}

enum class Kind : std::uint8_t { Integer, Integers, IntegerTable, Number3, Number4, Number16, Text };

// What is read, by where it stands: arrays on the way are walked through. A property may be absent; tinygltf tells
// where one must not be.
struct Property {
    const char *where, *key;
    Kind kind;
};
constexpr Property kProperties[] = {
    {"asset", "version", Kind::Text},
    {"", "scene", Kind::Integer},
    {"scenes", "nodes", Kind::Integers},
    {"nodes", "name", Kind::Text},
    {"nodes", "children", Kind::Integers},
    {"nodes", "mesh", Kind::Integer},
    {"nodes", "matrix", Kind::Number16},
    {"nodes", "translation", Kind::Number3},
    {"nodes", "rotation", Kind::Number4},
    {"nodes", "scale", Kind::Number3},
    {"meshes", "name", Kind::Text},
    {"meshes.primitives", "attributes", Kind::IntegerTable},
    {"meshes.primitives", "indices", Kind::Integer},
    {"meshes.primitives", "material", Kind::Integer},
    {"meshes.primitives", "mode", Kind::Integer},
    {"materials", "emissiveFactor", Kind::Number3},
    {"materials.pbrMetallicRoughness", "baseColorFactor", Kind::Number4},
    {"materials.pbrMetallicRoughness.baseColorTexture", "index", Kind::Integer},
    {"materials.pbrMetallicRoughness.baseColorTexture", "texCoord", Kind::Integer},
    {"textures", "source", Kind::Integer},
    {"images", "bufferView", Kind::Integer},
    {"images", "uri", Kind::Text},
    {"accessors", "bufferView", Kind::Integer},
    {"accessors", "byteOffset", Kind::Integer},
    {"accessors", "componentType", Kind::Integer},
    {"accessors", "count", Kind::Integer},
    {"bufferViews", "buffer", Kind::Integer},
    {"bufferViews", "byteOffset", Kind::Integer},
    {"bufferViews", "byteLength", Kind::Integer},
    {"bufferViews", "byteStride", Kind::Integer},
    {"buffers", "byteLength", Kind::Integer},
    {"buffers", "uri", Kind::Text},
    {"animations.channels", "sampler", Kind::Integer},
    {"animations.channels.target", "node", Kind::Integer},
    {"animations.channels.target", "path", Kind::Text},
    {"animations.samplers", "input", Kind::Integer},
    {"animations.samplers", "output", Kind::Integer},
    {"animations.samplers", "interpolation", Kind::Text},
};

bool is_index(const json& value) {
    return value.is_number_unsigned() &&
           value.get<std::uint64_t>() <= std::uint64_t{std::numeric_limits<std::int32_t>::max()};
}

bool are_numbers(const json& value, std::size_t count) {
    return value.is_array() && value.size() == count &&
           std::all_of(value.begin(), value.end(), [](const json& number) { return number.is_number(); });
}

// "" if the value is of its kind, or what it should be.
std::string fault_of(const json& value, Kind kind) {
    const auto all_are_indices = [&] { return std::all_of(value.begin(), value.end(), is_index); };
    switch (kind) {
        case Kind::Integer:
            return is_index(value) ? "" : "an integer from 0 to 2147483647";
        case Kind::Integers:
            return value.is_array() && all_are_indices() ? "" : "a list of integers from 0 to 2147483647";
        case Kind::IntegerTable:
            return value.is_object() && all_are_indices() ? "" : "an object of integers from 0 to 2147483647";
        case Kind::Number3:
            return are_numbers(value, 3) ? "" : "3 numbers";
        case Kind::Number4:
            return are_numbers(value, 4) ? "" : "4 numbers";
        case Kind::Number16:
            return are_numbers(value, 16) ? "" : "16 numbers";
        case Kind::Text:
            return value.is_string() ? "" : "a text";
    }
    return "";
}

// name: of `value`, for complaints: "meshes[2].primitives[0]".
void check_property(const json& value, const std::string& name, std::string_view where, const Property& property) {
    if (value.is_array()) {
        for (std::size_t i = 0; i < value.size(); ++i) {
            const std::string entry = name + "[" + std::to_string(i) + "]";
            if (!value[i].is_object()) fail(entry + " must be an object");
            check_property(value[i], entry, where, property);
        }
        return;
    }
    if (!value.is_object()) fail(name + " must be an object or a list of objects");
    const std::size_t end            = where.find('.');
    const std::string key            = where.empty() ? property.key : std::string(where.substr(0, end));
    const std::string inside         = name.empty() ? key : name + "." + key;
    const json::const_iterator found = value.find(key);
    if (found == value.end()) return;
    if (!where.empty()) {
        const bool is_last = end == std::string_view::npos;
        check_property(*found, inside, is_last ? std::string_view() : where.substr(end + 1), property);
    } else if (const std::string fault = fault_of(*found, property.kind); !fault.empty()) {
        fail(inside + " must be " + fault);
    }
}

std::int64_t integer(const json& object, const char* key, std::int64_t otherwise) {
    const json::const_iterator found = object.find(key);
    return found == object.end() ? otherwise : found->get<std::int64_t>();
}

const json& list(const json& document, const char* key) {
    static const json kNone          = json::array();
    const json::const_iterator found = document.find(key);
    return found == document.end() ? kNone : *found;
}

void check_buffers(const json& document, bool in_glb) {
    const json &buffers = list(document, "buffers"), &views = list(document, "bufferViews");
    std::int64_t total = 0;
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        const std::string name    = "buffers[" + std::to_string(i) + "]";
        const std::int64_t length = integer(buffers[i], "byteLength", 0);
        if (length < 1) fail(name + ".byteLength must be above 0");
        total += length;
        if (total > kMaxGltfBytes) fail("the buffers hold more than " + std::to_string(kMaxGltfBytes >> 20) + " MiB");
        if (!buffers[i].contains("uri") && !(in_glb && i == 0)) fail(name + " has no uri");
    }
    for (std::size_t i = 0; i < views.size(); ++i) {
        const std::string name    = "bufferViews[" + std::to_string(i) + "]";
        const std::int64_t buffer = integer(views[i], "buffer", -1);
        if (buffer < 0 || buffer >= static_cast<std::int64_t>(buffers.size())) {
            fail(name + ".buffer names no buffer");
        }
        const std::int64_t length = integer(views[i], "byteLength", 0);
        if (length < 1) fail(name + ".byteLength must be above 0");
        if (integer(views[i], "byteOffset", 0) + length >
            integer(buffers[static_cast<std::size_t>(buffer)], "byteLength", 0)) {
            fail(name + " goes beyond its buffer");
        }
    }
}

}  // namespace

std::string in_quotes(std::string_view text) {
    constexpr std::size_t kMost = 60;
    std::string line            = "'";
    for (const char c : text.substr(0, kMost)) line += static_cast<unsigned char>(c) < ' ' || c == 0x7f ? ' ' : c;
    return line + (text.size() > kMost ? "...'" : "'");
}

bool is_glb(std::string_view bytes) {
    return bytes.starts_with("glTF");
}

void check_gltf(std::string_view bytes) {
    const json document = parse(is_glb(bytes) ? json_of_glb(bytes) : bytes);
    if (!document.is_object()) fail("is not a glTF file: the JSON is no object");
    for (const Property& property : kProperties) check_property(document, "", property.where, property);
    for (const char* key : {"buffers", "bufferViews", "accessors", "meshes", "nodes", "scenes", "materials", "textures",
                            "images", "animations"})
        if (!list(document, key).is_array()) fail(std::string(key) + " must be a list");
    check_buffers(document, is_glb(bytes));

    const std::string version = document.value(json::json_pointer("/asset/version"), "");
    if (!version.starts_with("2.")) fail("is glTF of version " + in_quotes(version) + " (2.0 is known)");
    const json& required = list(document, "extensionsRequired");
    if (!required.empty()) {
        const std::string name = required.is_array() && required[0].is_string() ? required[0].get<std::string>() : "";
        fail("needs the extension " + in_quotes(name) + " of glTF, and none is supported");
    }
}

}  // namespace demo
