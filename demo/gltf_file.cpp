// SPDX-License-Identifier: MIT
#include "demo/gltf_file.h"

#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <new>
#include <stdexcept>
#include <utility>

#include "demo/gltf_check.h"

namespace demo {
namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "the numbers in a glTF file are little-endian");

// Throws std::runtime_error with the reason alone.
std::vector<unsigned char> read_whole_file(const std::string& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) throw std::runtime_error("no such file");
    if (fs::is_directory(status)) throw std::runtime_error("is a directory");
    if (!fs::is_regular_file(status)) throw std::runtime_error("is not a regular file");
    if (access(path.c_str(), R_OK) != 0) throw std::runtime_error(std::strerror(errno));
    const std::uintmax_t size = fs::file_size(path, error);
    if (error) throw std::runtime_error(error.message());
    if (size == 0) throw std::runtime_error("the file is empty");
    if (size > std::uintmax_t{kMaxGltfBytes}) {
        throw std::runtime_error("the file is too large: " + std::to_string(size) + " bytes (at most " +
                                 std::to_string(kMaxGltfBytes >> 20) + " MiB)");
    }
    std::vector<unsigned char> bytes(static_cast<std::size_t>(size));
    std::ifstream file(path, std::ios::binary);
    if (!file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size))) {
        throw std::runtime_error("cannot be read");
    }
    return bytes;
}

// What the library asks for: files of buffers. It looks for a file here and there; only the first place, beside the
// glTF file, is meant.
tinygltf::FsCallbacks file_callbacks() {
    return {
        .FileExists     = [](const std::string&, void*) { return true; },
        .ExpandFilePath = [](const std::string& path, void*) { return path; },
        .ReadWholeFile =
            [](std::vector<unsigned char>* bytes, std::string*, const std::string& path, void*) {
                try {
                    *bytes = read_whole_file(path);
                } catch (const std::runtime_error& error) {
                    throw std::runtime_error("its buffer " + in_quotes(path) + ": " + error.what());
                }
                return true;
            },
        .WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&,
                             void*) { return false; },
        .user_data      = nullptr,
    };
}

// Keeps a picture as it is in the file: gltf_image.h decodes those that are needed.
bool keep_image(tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes, int size,
                void*) {
    image->image.assign(bytes, bytes + size);
    image->as_is = true;
    return true;
}

// The library's complaints are lines, with words out of the file; the first tells.
std::string first_line(const std::string& text) {
    std::string line = text.substr(0, text.find('\n'));
    for (char& c : line)
        if (static_cast<unsigned char>(c) < ' ') c = ' ';
    return line.empty() ? "is not a glTF file" : line;
}

tinygltf::Model load(const std::string& path) {
    const std::vector<unsigned char> bytes = read_whole_file(path);
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    check_gltf(text);

    tinygltf::TinyGLTF library;
    library.SetFsCallbacks(file_callbacks());
    library.SetImageLoader(keep_image, nullptr);
    const std::string directory = fs::path(path).parent_path();
    const auto size             = static_cast<unsigned int>(bytes.size());
    tinygltf::Model model;
    std::string error, warning;
    const bool is_loaded = is_glb(text)
                               ? library.LoadBinaryFromMemory(&model, &error, &warning, bytes.data(), size, directory)
                               : library.LoadASCIIFromString(&model, &error, &warning, text.data(), size, directory);
    if (!is_loaded) throw std::runtime_error(first_line(error));
    return model;
}

// The formulas of glTF 2.0, section 3.6.2.2.
float number_at(const unsigned char* from, int component_type) {
    const auto as = [from](auto value) {
        std::memcpy(&value, from, sizeof value);
        return value;
    };
    switch (component_type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return std::max(static_cast<float>(as(std::int8_t{})) / 127.0f, -1.0f);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return static_cast<float>(as(std::uint8_t{})) / 255.0f;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return std::max(static_cast<float>(as(std::int16_t{})) / 32767.0f, -1.0f);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return static_cast<float>(as(std::uint16_t{})) / 65535.0f;
        default:
            return as(float{});
    }
}

}  // namespace

// Where an accessor's elements lie.
struct GltfFile::Elements {
    const unsigned char* first = nullptr;
    std::size_t count = 0, stride = 0, component_bytes = 0, components = 0;
    int component_type = 0;
    bool is_normalized = false;
};

GltfFile::GltfFile(FileReference file) : file_(std::move(file)) {
    try {
        model_ = load(file_.path);
    } catch (const std::bad_alloc&) {
        fail("does not fit into memory");
    } catch (const std::exception& error) {
        fail(error.what());
    }
}

void GltfFile::fail(const std::string& reason) const {
    throw SceneError(file_.named_at + ": " + file_.path + ": " + reason);
}

GltfFile::Elements GltfFile::elements(int index, const std::string& what) {
    const tinygltf::Accessor& accessor = find(model_.accessors, index, what + ": there is no such accessor");
    if (accessor.sparse.isSparse) fail(what + ": sparse accessors are not supported");
    const tinygltf::BufferView& view =
        find(model_.bufferViews, accessor.bufferView, what + ": there is no buffer view");
    const tinygltf::Buffer& buffer = find(model_.buffers, view.buffer, what + ": there is no buffer");

    const int component_bytes = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType));
    const int components      = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
    const bool is_matrix      = accessor.type == TINYGLTF_TYPE_MAT2 || components > 4;
    if (component_bytes < 1 || components < 1 || is_matrix) fail(what + ": has elements of the wrong type");
    Elements found{.first           = nullptr,
                   .count           = accessor.count,
                   .stride          = view.byteStride,
                   .component_bytes = static_cast<std::size_t>(component_bytes),
                   .components      = static_cast<std::size_t>(components),
                   .component_type  = accessor.componentType,
                   .is_normalized   = accessor.normalized};
    const std::size_t element_bytes = found.component_bytes * found.components;
    if (found.stride == 0) found.stride = element_bytes;
    if (found.stride < element_bytes) fail(what + ": elements overlap");
    if (found.count < 1) fail(what + ": is empty");
    // All of these are below 2^31, and gltf_check.h has compared the view with its buffer.
    const std::size_t end = accessor.byteOffset + (found.count - 1) * found.stride + element_bytes;
    if (end > view.byteLength || view.byteOffset + view.byteLength > buffer.data.size()) {
        fail(what + ": the accessor goes beyond its buffer view");
    }
    if (found.count * found.components > may_read_) fail("holds too many numbers");
    may_read_ -= found.count * found.components;
    found.first = buffer.data.data() + view.byteOffset + accessor.byteOffset;
    return found;
}

GltfNumbers GltfFile::read_numbers(int accessor, const WantedNumbers& wanted) {
    const Elements from  = elements(accessor, wanted.what);
    const int components = static_cast<int>(from.components);
    if (components < wanted.least_components || components > wanted.most_components) {
        fail(wanted.what + ": has " + std::to_string(components) + " components");
    }
    const bool is_integer = from.component_type >= TINYGLTF_COMPONENT_TYPE_BYTE &&
                            from.component_type <= TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
    const bool is_float = from.component_type == TINYGLTF_COMPONENT_TYPE_FLOAT;
    if (!is_float && !(is_integer && from.is_normalized && wanted.or_normalized)) {
        fail(wanted.what + ": has numbers of the wrong type");
    }
    GltfNumbers numbers{.count = from.count, .components = from.components, .values = {}};
    numbers.values.reserve(from.count * from.components);
    for (std::size_t i = 0; i < from.count; ++i) {
        for (std::size_t component = 0; component < from.components; ++component) {
            const float number =
                number_at(from.first + i * from.stride + component * from.component_bytes, from.component_type);
            if (!std::isfinite(number)) fail(wanted.what + ": holds a number that is not finite");
            numbers.values.push_back(number);
        }
    }
    return numbers;
}

std::vector<std::uint32_t> GltfFile::read_indices(int accessor, const std::string& what) {
    const Elements from    = elements(accessor, what);
    const bool is_unsigned = from.component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                             from.component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                             from.component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    if (!is_unsigned || from.components != 1) fail(what + ": are no unsigned integers");
    std::vector<std::uint32_t> indices;
    indices.reserve(from.count);
    for (std::size_t i = 0; i < from.count; ++i) {
        std::uint32_t index = 0;
        std::memcpy(&index, from.first + i * from.stride, from.component_bytes);
        indices.push_back(index);
    }
    return indices;
}

std::string GltfFile::path_of(const std::string& uri) const {
    const auto digit = [](char c) {
        return c >= '0' && c <= '9'   ? c - '0'
               : c >= 'a' && c <= 'f' ? c - 'a' + 10
               : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                      : -1;
    };
    std::string name;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const bool is_escape = uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0;
        name += is_escape ? static_cast<char>(digit(uri[i + 1]) * 16 + digit(uri[i + 2])) : uri[i];
        if (is_escape) i += 2;
    }
    return fs::path(file_.path).parent_path() / name;
}

}  // namespace demo
