// SPDX-License-Identifier: MIT
#include "demo/gltf_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "demo/gltf_check.h"
#include "demo/gltf_file.h"
#include "demo/gltf_image.h"
#include "demo/gltf_nodes.h"

namespace demo {
namespace {

constexpr double kMaxCoordinate = 1e5;  // metres; and of uv

using Triangle = std::array<std::uint32_t, 3>;

// The corners of a strip's or fan's triangles turn as the first triangle's do (glTF 2.0, section 3.7.2.1).
std::vector<Triangle> triangles_of(const std::vector<std::uint32_t>& corners, int mode) {
    std::vector<Triangle> triangles;
    if (mode == TINYGLTF_MODE_TRIANGLES) {
        for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
            triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
        return triangles;
    }
    for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
        if (mode == TINYGLTF_MODE_TRIANGLE_FAN) {
            triangles.push_back({corners[i + 1], corners[i + 2], corners[0]});
        } else {
            triangles.push_back({corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]});
        }
    }
    return triangles;
}

// Unit length; up, where there is none to speak of.
Vec3 unit_or_up(const glm::dvec3& normal) {
    const double largest = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
    if (!(largest > 0.0) || !std::isfinite(largest)) return {0.0f, 1.0f, 0.0f};
    const glm::dvec3 scaled = normal / largest;  // its square neither vanishes nor overflows
    return scaled / std::sqrt(glm::dot(scaled, scaled));
}

class MeshReader {
  public:
    explicit MeshReader(GltfFile& file) : file_(file) {}

    void append(const tinygltf::Mesh& mesh, const std::string& name, const glm::dmat4& place) {
        for (const tinygltf::Primitive& primitive : mesh.primitives) {
            const bool is_surface =
                primitive.mode >= TINYGLTF_MODE_TRIANGLES && primitive.mode <= TINYGLTF_MODE_TRIANGLE_FAN;
            if (primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN) file_.fail(name + ": there is no such mode");
            if (is_surface) append(primitive, name, place);
        }
    }

    GltfMesh take() { return std::move(mesh_); }

  private:
    struct Surface {
        int texture = -1, uv_set = 0;
        Vec3 color = Vec3(1.0f);
    };

    // What the file has of a primitive's vertices. Empty where it has none.
    struct Attributes {
        GltfNumbers positions, normals, colors, uvs;
    };

    // Where a node puts things. The columns of its cofactors are what normals are multiplied by, but for a length and
    // the sign of the determinant.
    struct Placement {
        glm::dmat4 place;
        glm::dmat3 cofactors;
        bool is_mirrored;
    };
    static Placement placement_of(const glm::dmat4& place) {
        const glm::dvec3 x(place[0]), y(place[1]), z(place[2]);
        const glm::dmat3 cofactors(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
        return {.place = place, .cofactors = cofactors, .is_mirrored = glm::dot(x, cofactors[0]) < 0.0};
    }

    void append(const tinygltf::Primitive& primitive, const std::string& name, const glm::dmat4& place) {
        const Surface surface       = surface_of(primitive, name);
        const Attributes attributes = attributes_of(primitive, surface, name);
        std::vector<Triangle> triangles =
            triangles_of(corners_of(primitive, name, attributes.positions.count), primitive.mode);
        if (triangles.empty()) return;
        triangle_count_ += triangles.size();
        if (triangle_count_ > kMaxGltfTriangles) {
            file_.fail("has more than " + std::to_string(kMaxGltfTriangles) + " triangles");
        }
        const Placement placement = placement_of(place);
        if (placement.is_mirrored)
            for (Triangle& triangle : triangles) std::swap(triangle[1], triangle[2]);
        std::vector<GltfVertex> vertices;
        vertices.reserve(attributes.positions.count);
        for (std::size_t i = 0; i < attributes.positions.count; ++i)
            vertices.push_back(vertex_of(attributes, i, surface, placement, name));

        GltfPart& part = part_with(surface.texture);
        if (attributes.normals.count != 0) {
            append_smooth(part, vertices, triangles);
        } else {
            append_flat(part, vertices, triangles);
        }
    }

    Attributes attributes_of(const tinygltf::Primitive& primitive, const Surface& surface, const std::string& name) {
        const WantedNumbers three{.what = {}, .least_components = 3, .most_components = 3};
        const WantedNumbers color{.what = {}, .least_components = 3, .most_components = 4, .or_normalized = true};
        const WantedNumbers uv{.what = {}, .least_components = 2, .most_components = 2, .or_normalized = true};
        Attributes attributes{.positions = numbers(primitive, "POSITION", name, three),
                              .normals   = numbers(primitive, "NORMAL", name, three),
                              .colors    = numbers(primitive, "COLOR_0", name, color),
                              .uvs       = {}};
        if (surface.texture >= 0) {
            attributes.uvs = numbers(primitive, "TEXCOORD_" + std::to_string(surface.uv_set), name, uv);
        }
        const std::size_t count = attributes.positions.count;
        if (count == 0) file_.fail(name + ": has no POSITION");
        for (const GltfNumbers* other : {&attributes.normals, &attributes.colors, &attributes.uvs})
            if (other->count != 0 && other->count != count)
                file_.fail(name + ": its vertices have not as many of each attribute");
        return attributes;
    }

    GltfVertex vertex_of(const Attributes& from, std::size_t i, const Surface& surface, const Placement& placement,
                         const std::string& name) const {
        GltfVertex vertex{.position = {}, .normal = {}, .uv = {}, .color = surface.color};
        const GltfNumbers& positions = from.positions;
        const glm::dvec3 at(placement.place *
                            glm::dvec4(positions.at(i, 0), positions.at(i, 1), positions.at(i, 2), 1.0));
        for (int axis = 0; axis < 3; ++axis)
            if (!(std::abs(at[axis]) <= kMaxCoordinate)) file_.fail(name + ": lies beyond 100000 m");
        vertex.position = at;
        if (from.normals.count != 0) {
            const glm::dvec3 own(from.normals.at(i, 0), from.normals.at(i, 1), from.normals.at(i, 2));
            const glm::dvec3 normal = placement.cofactors * own;
            vertex.normal           = unit_or_up(placement.is_mirrored ? -normal : normal);
        }
        if (from.colors.count != 0)
            vertex.color *= Vec3(from.colors.at(i, 0), from.colors.at(i, 1), from.colors.at(i, 2));
        for (int channel = 0; channel < 3; ++channel)
            vertex.color[channel] = std::clamp(vertex.color[channel], 0.0f, 1.0f);
        if (from.uvs.count != 0) vertex.uv = Vec2(from.uvs.at(i, 0), from.uvs.at(i, 1));
        if (std::abs(vertex.uv.x) > kMaxCoordinate || std::abs(vertex.uv.y) > kMaxCoordinate) {
            file_.fail(name + ": has texture coordinates beyond 100000");
        }
        return vertex;
    }

    // Empty where the primitive has no such attribute.
    GltfNumbers numbers(const tinygltf::Primitive& primitive, const std::string& attribute, const std::string& name,
                        WantedNumbers wanted) {
        const auto found = primitive.attributes.find(attribute);
        if (found == primitive.attributes.end()) return {};
        wanted.what = attribute + " of " + name;
        return file_.read_numbers(found->second, wanted);
    }

    std::vector<std::uint32_t> corners_of(const tinygltf::Primitive& primitive, const std::string& name,
                                          std::size_t vertex_count) {
        std::vector<std::uint32_t> corners;
        if (primitive.indices >= 0) {
            corners = file_.read_indices(primitive.indices, "the indices of " + name);
            for (const std::uint32_t corner : corners)
                if (corner >= vertex_count) file_.fail("the indices of " + name + ": go beyond its vertices");
        } else {
            for (std::size_t i = 0; i < vertex_count; ++i) corners.push_back(static_cast<std::uint32_t>(i));
        }
        if (primitive.mode == TINYGLTF_MODE_TRIANGLES && corners.size() % 3 != 0)
            file_.fail(name + ": its last triangle has not 3 corners");
        return corners;
    }

    Surface surface_of(const tinygltf::Primitive& primitive, const std::string& name) {
        if (primitive.material < 0) return {};
        const tinygltf::PbrMetallicRoughness& material =
            file_.find(file_.model().materials, primitive.material, name + " has a material that is not there")
                .pbrMetallicRoughness;
        const std::vector<double>& factor = material.baseColorFactor;
        Surface surface{.texture = -1,
                        .uv_set  = material.baseColorTexture.texCoord,
                        .color   = glm::dvec3(factor[0], factor[1], factor[2])};
        if (material.baseColorTexture.index >= 0) surface.texture = texture_with(material.baseColorTexture.index);
        return surface;
    }

    // The place in mesh_.textures of one of the file's textures. Several may show one picture.
    int texture_with(int index) {
        const int picture =
            file_.find(file_.model().textures, index, "a material has a texture that is not there").source;
        const auto known = texture_of_picture_.find(picture);
        if (known != texture_of_picture_.end()) return known->second;
        mesh_.textures.push_back(read_gltf_texture(file_, index));
        const int added = static_cast<int>(mesh_.textures.size()) - 1;
        texture_of_picture_.emplace(picture, added);
        return added;
    }

    GltfPart& part_with(int texture) {
        for (GltfPart& part : mesh_.parts)
            if (part.texture == texture) return part;
        mesh_.parts.emplace_back().texture = texture;
        return mesh_.parts.back();
    }

    static void append_smooth(GltfPart& part, const std::vector<GltfVertex>& vertices,
                              const std::vector<Triangle>& triangles) {
        const auto first = static_cast<std::uint32_t>(part.vertices.size());
        part.vertices.insert(part.vertices.end(), vertices.begin(), vertices.end());
        for (const Triangle& triangle : triangles)
            for (const std::uint32_t corner : triangle) part.indices.push_back(first + corner);
    }

    // Each triangle has corners of its own, with its own normal.
    static void append_flat(GltfPart& part, const std::vector<GltfVertex>& vertices,
                            const std::vector<Triangle>& triangles) {
        for (const Triangle& triangle : triangles) {
            const glm::dvec3 a = vertices[triangle[0]].position, b = vertices[triangle[1]].position,
                             c = vertices[triangle[2]].position;
            const Vec3 normal  = unit_or_up(glm::cross(b - a, c - a));
            for (const std::uint32_t corner : triangle) {
                part.indices.push_back(static_cast<std::uint32_t>(part.vertices.size()));
                part.vertices.push_back(vertices[corner]);
                part.vertices.back().normal = normal;
            }
        }
    }

    GltfFile& file_;
    GltfMesh mesh_;
    std::map<int, int> texture_of_picture_;
    std::size_t triangle_count_ = 0;
};

}  // namespace

GltfMesh read_gltf_mesh(const FileReference& reference) {
    GltfFile file(reference);
    MeshReader reader(file);
    const std::vector<SceneNode> nodes = scene_nodes(file);
    std::vector<glm::dmat4> places;
    places.reserve(nodes.size());
    for (const SceneNode& node : nodes) {
        const glm::dmat4 local = matrix_of(node.rest);
        places.push_back(node.parent < 0 ? local : places[static_cast<std::size_t>(node.parent)] * local);
        const tinygltf::Node& from = file.model().nodes[static_cast<std::size_t>(node.index)];
        if (from.mesh < 0 || is_particle(from.name)) continue;
        const std::string name     = node_name(file, node.index);
        const tinygltf::Mesh& mesh = file.find(file.model().meshes, from.mesh, name + " has a mesh that is not there");
        reader.append(mesh, name, places.back());
    }
    GltfMesh mesh = reader.take();
    if (mesh.parts.empty()) file.fail("holds no triangles");
    return mesh;
}

}  // namespace demo
