// SPDX-License-Identifier: MIT
// Meshes whose vertices are worked out by hand.
#include "demo/gltf_mesh.h"

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "tests/support/child_process.h"
#include "tests/support/glb_file.h"
#include "tests/support/png_bytes.h"

namespace {

using demo::GltfMesh;
using demo::GltfPart;
using demo::Vec2;
using demo::Vec3;
using tests::GlbFile;
using tests::Json;
using tests::ScratchDirectory;
using namespace std::string_literals;
using Indices = std::vector<std::uint32_t>;

GltfMesh read(const GlbFile& file) {
    const ScratchDirectory directory;
    tests::write_file(directory / "mesh.glb", file.glb());
    return demo::read_gltf_mesh({.path = directory / "mesh.glb", .named_at = "here"});
}

// The one part of a file without pictures.
GltfPart read_part(const GlbFile& file) {
    GltfMesh mesh = read(file);
    REQUIRE(mesh.parts.size() == 1);
    return mesh.parts[0];
}

int add_mesh(GlbFile& file, const Json& attributes, const Json& rest = Json::object()) {
    Json primitive = {{"attributes", attributes}};
    primitive.update(rest);
    return file.add("meshes", {{"primitives", Json::array({primitive})}});
}

// In the plane z = 0, seen from +z counter-clockwise.
int triangle_positions(GlbFile& file) {
    return file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0});
}

std::vector<Vec3> positions_of(const GltfPart& part) {
    std::vector<Vec3> positions;
    for (const std::uint32_t index : part.indices) positions.push_back(part.vertices[index].position);
    return positions;
}

bool is_near(const Vec3& a, const Vec3& b) {
    return glm::length(a - b) < 1e-6f;
}

}  // namespace

TEST_CASE("nodes move meshes: scale, then rotation, then translation, then the parent's", "[demo][gltf]") {
    GlbFile file;
    const int mesh    = add_mesh(file, {{"POSITION", triangle_positions(file)}});
    // A quarter turn about y takes x to -z.
    const float half  = 0.70710678f;
    Json moved        = {{"mesh", mesh}, {"translation", {10, 0, 0}}, {"scale", {2, 3, 1}}};
    moved["rotation"] = {0, half, 0, half};
    const int child   = file.add("nodes", moved);
    file.root({{"children", Json::array({child})}, {"translation", {0, 5, 0}}, {"scale", {1, 2, 1}}});
    const GltfPart part = read_part(file);
    REQUIRE(part.indices == Indices{0, 1, 2});
    CHECK(is_near(part.vertices[0].position, Vec3(10, 5, 0)));
    CHECK(is_near(part.vertices[1].position, Vec3(10, 5, -2)));
    CHECK(is_near(part.vertices[2].position, Vec3(10, 11, 0)));
    // The front looked to +z, which is +x now.
    for (const demo::GltfVertex& vertex : part.vertices) CHECK(is_near(vertex.normal, Vec3(1, 0, 0)));
    CHECK(part.texture == -1);
    CHECK(part.vertices[0].color == Vec3(1.0f));
}

TEST_CASE("a node's matrix is column by column", "[demo][gltf]") {
    GlbFile file;
    const int mesh = add_mesh(file, {{"POSITION", triangle_positions(file)}});
    file.root({{"mesh", mesh}, {"matrix", {0, 2, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 7, 8, 9, 1}}});
    CHECK(positions_of(read_part(file)) == std::vector<Vec3>{{7, 8, 9}, {7, 10, 9}, {6, 8, 9}});
}

TEST_CASE("normals stand upright on what is scaled, and fronts stay fronts in a mirror", "[demo][gltf]") {
    GlbFile file;
    // A triangle on the slope x = y, with its normal (1, -1, 0); and the same, mirrored.
    const float s       = 0.70710678f;
    const int positions = file.floats("VEC3", {0, 0, 0, 1, 1, 0, 0, 0, 1});
    const int normals   = file.floats("VEC3", {s, -s, 0, s, -s, 0, s, -s, 0});
    const int mesh      = add_mesh(file, {{"POSITION", positions}, {"NORMAL", normals}});
    const float scale_x = GENERATE(3.0f, -3.0f);
    file.root({{"mesh", mesh}, {"scale", {scale_x, 1, 1}}});
    const GltfPart part        = read_part(file);
    // x = 3 y: the normal (1, -3, 0).
    const Vec3 normal          = glm::normalize(Vec3(scale_x > 0.0f ? 1.0f : -1.0f, -3.0f, 0.0f));
    const std::vector<Vec3> at = positions_of(part);
    for (const demo::GltfVertex& vertex : part.vertices) CHECK(is_near(vertex.normal, normal));
    CHECK(is_near(glm::normalize(glm::cross(at[1] - at[0], at[2] - at[0])), normal));
}

TEST_CASE("indices of all sizes, strips and fans", "[demo][gltf]") {
    struct Case {
        int mode;
        Indices indices, triangles;
    };
    const Case shape =
        GENERATE(Case{4, {0, 1, 2, 2, 1, 3}, {0, 1, 2, 2, 1, 3}}, Case{5, {0, 1, 2, 3, 4}, {0, 1, 2, 1, 3, 2, 2, 3, 4}},
                 Case{6, {0, 1, 2, 3, 4}, {1, 2, 0, 2, 3, 0, 3, 4, 0}});
    const int type = GENERATE(0, tests::kUnsignedByte, tests::kUnsignedShort, tests::kUnsignedInt);
    GlbFile file;
    const int positions = file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0});
    const int normals   = file.floats("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    Json rest           = {{"mode", shape.mode}};
    if (type == 0 && shape.mode == 4) return;  // five vertices are no triangles
    if (type != 0) rest["indices"] = file.integers(type, "SCALAR", shape.indices);
    file.root({{"mesh", add_mesh(file, {{"POSITION", positions}, {"NORMAL", normals}}, rest)}});
    CHECK(read_part(file).indices == shape.triangles);
}

TEST_CASE("triangles without normals are flat", "[demo][gltf]") {
    GlbFile file;
    const int positions = file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
    const int indices   = file.integers(tests::kUnsignedShort, "SCALAR", {0, 1, 2, 0, 2, 3, 1, 1, 1});
    file.root({{"mesh", add_mesh(file, {{"POSITION", positions}}, {{"indices", indices}})}});
    const GltfPart part = read_part(file);
    REQUIRE(part.vertices.size() == 9);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(part.vertices[i].normal == Vec3(0, 0, 1));
        CHECK(part.vertices[3 + i].normal == Vec3(1, 0, 0));
        CHECK(part.vertices[6 + i].normal == Vec3(0, 1, 0));  // of no area
    }
}

TEST_CASE("colours of vertices times the material's", "[demo][gltf]") {
    GlbFile file;
    const int positions = triangle_positions(file);
    const int kind      = GENERATE(0, 1, 2, 3);
    const int colors =
        kind == 0   ? file.floats("VEC3", {1, 0, 0, 0, 0.5f, 0, 0, 0, 8})
        : kind == 1 ? file.floats("VEC4", {1, 0, 0, 0, 0, 0.5f, 0, 0, 0, 0, 8, 0})
        : kind == 2
            ? file.integers(tests::kUnsignedByte, "VEC4", {255, 0, 0, 9, 0, 51, 0, 9, 0, 0, 255, 9}, true)
            : file.integers(tests::kUnsignedShort, "VEC4", {65535, 0, 0, 9, 0, 13107, 0, 9, 0, 0, 65535, 9}, true);
    file.add("materials", {{"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.5, 1.0, 1.0}}}}});
    file.root({{"mesh", add_mesh(file, {{"POSITION", positions}, {"COLOR_0", colors}}, {{"material", 0}})}});
    const GltfPart part = read_part(file);
    CHECK(part.vertices[0].color == Vec3(0.5f, 0.0f, 0.0f));
    CHECK(part.vertices[1].color.y == Approx(kind < 2 ? 0.25f : 0.1f));
    CHECK(part.vertices[2].color == Vec3(0.0f, 0.0f, 1.0f));
}

TEST_CASE("interleaved vertices are read by their stride", "[demo][gltf]") {
    GlbFile file;
    // Position and normal by turns.
    const std::vector<float> both = {0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1};
    const int view = file.view({reinterpret_cast<const char*>(both.data()), both.size() * sizeof(float)});
    file.document["bufferViews"][static_cast<std::size_t>(view)]["byteStride"] = 24;
    const Json accessor = {{"bufferView", view}, {"componentType", tests::kFloat}, {"count", 3}, {"type", "VEC3"}};
    const int positions = file.add("accessors", accessor), normals = file.add("accessors", accessor);
    file.document["accessors"][static_cast<std::size_t>(normals)]["byteOffset"] = 12;
    file.root({{"mesh", add_mesh(file, {{"POSITION", positions}, {"NORMAL", normals}})}});
    const GltfPart part = read_part(file);
    CHECK(positions_of(part) == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    for (const demo::GltfVertex& vertex : part.vertices) CHECK(vertex.normal == Vec3(0, 0, 1));
}

TEST_CASE("particles, other scenes, points and lines are no scene geometry", "[demo][gltf]") {
    GlbFile file;
    const int positions = triangle_positions(file);
    const int mesh      = add_mesh(file, {{"POSITION", positions}});
    const int lines     = add_mesh(file, {{"POSITION", positions}}, {{"mode", 1}});
    file.root({{"name", "Particle.003"}, {"mesh", mesh}});
    file.root({{"name", "Lines"}, {"mesh", lines}});
    file.root({{"name", "Camera"}, {"camera", 0}});
    file.add("nodes", {{"name", "Elsewhere"}, {"mesh", mesh}});
    file.root({{"name", "Ground"}, {"mesh", mesh}, {"translation", {0, 0, 4}}});
    CHECK(positions_of(read_part(file)) == std::vector<Vec3>{{0, 0, 4}, {1, 0, 4}, {0, 1, 4}});
}

TEST_CASE("pictures in the file and beside it become textures", "[demo][gltf]") {
    const std::string png =
        tests::png_bytes(2, 2, {6, 8}, {"\x01\x02\x03\xff\xfe\xfd\xfc\x80"s, "\x04\x05\x06\xff\x07\x08\x09\xff"s});
    const bool is_inside = GENERATE(true, false);
    GlbFile file;
    const int positions = triangle_positions(file);
    const int uv0 = file.floats("VEC2", {0, 0, 0, 0, 0, 0}), uv1 = file.floats("VEC2", {0, 0, 1, 0.25f, 0, -3});
    file.add("images", is_inside ? Json{{"bufferView", file.view(png)}, {"mimeType", "image/png"}}
                                 : Json{{"uri", "base%20colour.png"}});
    file.add("textures", {{"source", 0}});
    file.add("textures", {{"source", 0}});
    for (const int texture : {0, 1})
        file.add("materials",
                 {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}, {"texCoord", 1}}}}}});
    const Json attributes = {{"POSITION", positions}, {"TEXCOORD_0", uv0}, {"TEXCOORD_1", uv1}};
    const int plain       = add_mesh(file, attributes);
    const int one = add_mesh(file, attributes, {{"material", 0}}), two = add_mesh(file, attributes, {{"material", 1}});
    for (const int mesh : {one, plain, two}) file.root({{"mesh", mesh}});

    const ScratchDirectory directory;
    const std::string path = directory / "mesh.glb";
    tests::write_file(path, file.glb());
    if (!is_inside) tests::write_file(directory / "base colour.png", png);
    const GltfMesh mesh = demo::read_gltf_mesh({.path = path, .named_at = "here"});
    REQUIRE(mesh.textures.size() == 1);
    CHECK(mesh.textures[0].name == path + "#0");
    CHECK(mesh.textures[0].width == 2);
    CHECK(mesh.textures[0].levels == 2);
    // B, G, R, A of each texel, rows from the top.
    const std::vector<std::uint8_t> base(mesh.textures[0].texels.begin(), mesh.textures[0].texels.begin() + 16);
    CHECK(base == std::vector<std::uint8_t>{3, 2, 1, 255, 0xfc, 0xfd, 0xfe, 0x80, 6, 5, 4, 255, 9, 8, 7, 255});
    REQUIRE(mesh.parts.size() == 2);
    CHECK(mesh.parts[0].texture == 0);
    CHECK(mesh.parts[0].vertices.size() == 6);
    CHECK(mesh.parts[0].vertices[1].uv == Vec2(1.0f, 0.25f));
    CHECK(mesh.parts[0].vertices[2].uv == Vec2(0.0f, -3.0f));
    CHECK(mesh.parts[1].texture == -1);
}

TEST_CASE("a picture that cannot be read has its complaint", "[demo][gltf]") {
    GlbFile file;
    const int positions  = triangle_positions(file);
    const bool is_inside = GENERATE(true, false);
    file.add("images", is_inside ? Json{{"bufferView", file.view("no picture")}, {"mimeType", "image/png"}}
                                 : Json{{"uri", "absent.png"}});
    file.add("textures", {{"source", 0}});
    file.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    file.root({{"mesh", add_mesh(file, {{"POSITION", positions}}, {{"material", 0}})}});
    CHECK_THROWS_WITH(read(file), Catch::StartsWith("here: ") && Catch::Contains("mesh.glb: images[0]: ") &&
                                      Catch::Contains(is_inside ? "not an image" : "absent.png: no such file") &&
                                      !Catch::Contains("/proc/"));
    file.document["textures"][0]["source"] = 4;
    CHECK_THROWS_WITH(read(file), Catch::Contains("textures[0].source names no image"));
    file.document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 4;
    CHECK_THROWS_WITH(read(file), Catch::Contains("a material has a texture that is not there"));
}
