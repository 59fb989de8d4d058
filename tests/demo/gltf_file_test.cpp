// SPDX-License-Identifier: MIT
// glTF files that are damaged, missing or odd: each has its complaint of one line, or loads. What sound ones hold,
// gltf_mesh_test.cpp and gltf_particles_test.cpp check.
#include "demo/gltf_file.h"

#include <catch2/catch.hpp>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "demo/gltf_mesh.h"
#include "demo/gltf_particles.h"
#include "tests/support/child_process.h"
#include "tests/support/glb_file.h"
#include "tests/support/random.h"

namespace {

using demo::FileReference;
using tests::GlbFile;
using tests::Json;
using tests::ScratchDirectory;

const std::string kNamedAt = "scenes/x.toml:12:8: cloud.particles";

// The complaint of what reads the file, or "" if it is read.
template <class Read>
std::string complaint(Read&& read) {
    try {
        read();
    } catch (const demo::SceneError& error) {
        return error.what();
    }
    return "";
}

// Both readers meet the same file; the first complaint counts.
std::string complaint_of(const std::string& bytes, const std::string& name = "cloud.glb") {
    const ScratchDirectory directory;
    tests::write_file(directory / name, bytes);
    const FileReference file{.path = directory / name, .named_at = kNamedAt};
    const std::string of_particles = complaint([&] { demo::ParticleFile(file).at(0.5); });
    const std::string of_mesh      = complaint([&] { demo::read_gltf_mesh(file); });
    const std::string line         = of_particles.empty() ? of_mesh : of_particles;
    if (line.empty()) return "";
    CHECK(line.find('\n') == std::string::npos);
    const std::string start = kNamedAt + ": " + file.path + ": ";
    CHECK(line.substr(0, start.size()) == start);
    return line.size() > start.size() ? line.substr(start.size()) : "no reason";
}

// A particle that moves, with a parent, and a triangle of its own.
GlbFile sample() {
    GlbFile file;
    const int positions = file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int normals   = file.floats("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1});
    const int indices   = file.integers(tests::kUnsignedShort, "SCALAR", {0, 1, 2});
    file.add("materials", {{"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.25, 1.0, 1.0}}}}});
    file.add("meshes", {{"primitives", Json::array({{{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}},
                                                     {"indices", indices},
                                                     {"material", 0}}})}});
    const int particle =
        file.add("nodes", {{"name", "particle"}, {"translation", {1, 2, 3}}, {"extras", {{"alpha", 0.5}}}});
    file.root({{"name", "Parent"}, {"children", Json::array({particle})}, {"rotation", {0, 0, 0, 1}}});
    file.root({{"name", "Triangle"}, {"mesh", 0}});
    file.animate(particle, "translation", "LINEAR", {0, 1}, {0, 0, 0, 4, 0, 0});
    return file;
}

}  // namespace

TEST_CASE("a sound glTF file is read, in both of its forms", "[demo][gltf]") {
    CHECK(complaint_of(sample().glb()) == "");
    CHECK(complaint_of(sample().gltf(), "cloud.gltf") == "");
    // By what is in it, not by its name.
    CHECK(complaint_of(sample().glb(), "cloud.gltf") == "");
}

TEST_CASE("a GLB that is cut off is refused at every length", "[demo][gltf]") {
    const std::string whole = sample().glb();
    REQUIRE(whole.size() < 4000);
    for (std::size_t length = 0; length < whole.size(); ++length) {
        INFO("length " << length);
        CHECK(complaint_of(whole.substr(0, length)) != "");
    }
    // Nor do chunks that are cut off behind a header that knows.
    for (std::size_t length = 12; length < whole.size(); ++length) {
        std::string cut = whole.substr(0, length);
        for (std::size_t i = 0; i < 4; ++i) cut[8 + i] = static_cast<char>(length >> (8 * i) & 255);
        INFO("length " << length);
        CHECK(complaint_of(cut) != "");
    }
}

TEST_CASE("a text that is cut off is refused at every length", "[demo][gltf]") {
    const std::string whole = sample().gltf();
    for (std::size_t length = 0; length < whole.size(); length += 3) {
        INFO("length " << length);
        CHECK(complaint_of(whole.substr(0, length), "cloud.gltf") != "");
    }
}

TEST_CASE("damaged bytes give a complaint or are read", "[demo][gltf]") {
    const std::string whole = sample().glb();
    test_support::Random random(7);
    int refused = 0;
    for (int i = 0; i < 1000; ++i) {
        std::string damaged = whole;
        for (int hits = 0; hits <= i % 3; ++hits) {
            damaged[random.below(damaged.size())] = static_cast<char>(random.from(0, 255));
        }
        refused += complaint_of(damaged).empty() ? 0 : 1;
    }
    CHECK(refused > 250);
    CHECK(refused < 1000);
}

TEST_CASE("each fault of a glTF file has its complaint", "[demo][gltf]") {
    struct Case {
        const char* complaint;
        std::function<void(Json&)> damage;
    };
    const std::vector<Case> faults = {
        // Types and ranges.
        Case{"bufferViews[0].byteOffset must be an integer from 0",
             [](Json& d) { d["bufferViews"][0]["byteOffset"] = -4; }},
        Case{"accessors[0].byteOffset must be an integer from 0",
             [](Json& d) { d["accessors"][0]["byteOffset"] = -12; }},
        Case{"accessors[0].byteOffset must be an integer from 0",
             [](Json& d) { d["accessors"][0]["byteOffset"] = 0.5; }},
        Case{"accessors[0].count must be an integer from 0", [](Json& d) { d["accessors"][0]["count"] = 4294967299; }},
        Case{"nodes[2].mesh must be an integer", [](Json& d) { d["nodes"][2]["mesh"] = 4294967296; }},
        Case{"nodes[0].translation must be 3 numbers",
             [](Json& d) {
                 d["nodes"][0]["translation"] = {1, 2};
             }},
        Case{"nodes[0].translation must be 3 numbers", [](Json& d) { d["nodes"][0]["translation"][1] = "2"; }},
        Case{"nodes[1].rotation must be 4 numbers", [](Json& d) { d["nodes"][1]["rotation"] = "none"; }},
        Case{"nodes[1].matrix must be 16 numbers", [](Json& d) { d["nodes"][1]["matrix"] = Json::array({1}); }},
        Case{"nodes must be", [](Json& d) { d["nodes"] = 3; }},
        Case{"meshes[0].primitives[0] must be an object", [](Json& d) { d["meshes"][0]["primitives"][0] = 1; }},
        Case{"meshes[0].primitives[0].attributes must be",
             [](Json& d) { d["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = "x"; }},
        Case{"version '1.0'", [](Json& d) { d["asset"]["version"] = "1.0"; }},
        Case{"version", [](Json& d) { d.erase("asset"); }},
        Case{"needs the extension 'KHR_draco_mesh_compression'",
             [](Json& d) { d["extensionsRequired"] = Json::array({"KHR_draco_mesh_compression"}); }},
        // Buffers.
        Case{"bufferViews[0] goes beyond its buffer", [](Json& d) { d["bufferViews"][0]["byteLength"] = 1000000; }},
        Case{"bufferViews[0] goes beyond its buffer", [](Json& d) { d["bufferViews"][0]["byteOffset"] = 2147483647; }},
        Case{"bufferViews[0].byteLength must be above 0", [](Json& d) { d["bufferViews"][0]["byteLength"] = 0; }},
        Case{"bufferViews[0].buffer names no buffer", [](Json& d) { d["bufferViews"][0]["buffer"] = 1; }},
        Case{"the accessor goes beyond its buffer view", [](Json& d) { d["accessors"][0]["count"] = 4; }},
        Case{"the accessor goes beyond its buffer view", [](Json& d) { d["accessors"][0]["count"] = 2147483647; }},
        Case{"the accessor goes beyond its buffer view", [](Json& d) { d["accessors"][0]["byteOffset"] = 4; }},
        Case{"the accessor goes beyond its buffer view", [](Json& d) { d["bufferViews"][0]["byteStride"] = 16; }},
        Case{"elements overlap", [](Json& d) { d["bufferViews"][0]["byteStride"] = 8; }},
        Case{"is empty", [](Json& d) { d["accessors"][0]["count"] = 0; }},
        Case{"there is no buffer view", [](Json& d) { d["accessors"][0].erase("bufferView"); }},
        Case{"there is no such accessor",
             [](Json& d) { d["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 99; }},
        Case{"sparse accessors are not supported",
             [](Json& d) {
                 d["accessors"][0]["sparse"] = {{"count", 1},
                                                {"indices", {{"bufferView", 2}, {"componentType", 5123}}},
                                                {"values", {{"bufferView", 0}}}};
             }},
        Case{"the buffers hold more than 256 MiB",
             [](Json& d) {
                 d["buffers"] = Json::array({{{"byteLength", 300000000}}});
             }},
        Case{"buffers[1] has no uri",
             [](Json& d) {
                 d["buffers"] = Json::array({{{"byteLength", 4}}, {{"byteLength", 4}}});
             }},
        Case{"no such file",
             [](Json& d) {
                 d["buffers"] = Json::array({{{"byteLength", 200}, {"uri", "absent.bin"}}});
             }},
        Case{"is a directory",
             [](Json& d) {
                 d["buffers"] = Json::array({{{"byteLength", 200}, {"uri", "../"}}});
             }},
        // Vertices.
        Case{"numbers of the wrong type", [](Json& d) { d["accessors"][0]["componentType"] = 5125; }},
        Case{"componentType", [](Json& d) { d["accessors"][0]["componentType"] = 99; }},
        Case{"has 2 components", [](Json& d) { d["accessors"][0]["type"] = "VEC2"; }},
        Case{"elements of the wrong type",
             [](Json& d) {
                 d["accessors"][0] = {{"bufferView", 0}, {"componentType", 5126}, {"count", 1}, {"type", "MAT2"}};
             }},
        Case{"not as many of each attribute", [](Json& d) { d["accessors"][1]["count"] = 2; }},
        Case{"are no unsigned integers", [](Json& d) { d["accessors"][2]["componentType"] = 5122; }},
        Case{"has not 3 corners", [](Json& d) { d["accessors"][2]["count"] = 2; }},
        Case{"has no POSITION", [](Json& d) { d["meshes"][0]["primitives"][0]["attributes"].erase("POSITION"); }},
        Case{"has a material that is not there", [](Json& d) { d["meshes"][0]["primitives"][0]["material"] = 1; }},
        Case{"has a mesh that is not there", [](Json& d) { d["nodes"][2]["mesh"] = 1; }},
        Case{"holds no triangles", [](Json& d) { d["meshes"][0]["primitives"][0]["mode"] = 1; }},
        Case{"there is no such mode", [](Json& d) { d["meshes"][0]["primitives"][0]["mode"] = 7; }},
        Case{"lies beyond 100000 m",
             [](Json& d) {
                 d["nodes"][2]["scale"] = {1e6, 1, 1};
             }},
        Case{"lies beyond 100000 m",
             [](Json& d) {
                 d["nodes"][2]["translation"] = {0, 1e300, 0};
             }},
        // Nodes.
        Case{"a node is its own ancestor",
             [](Json& d) {
                 d["nodes"][0]["children"] = Json::array({1});
                 d["scenes"][0]["nodes"]   = Json::array({2});
             }},
        Case{"a node is its own ancestor",
             [](Json& d) {
                 d["nodes"][2]["children"] = Json::array({2});
                 d["scenes"][0]["nodes"]   = Json::array({1});
             }},
        Case{"has a parent and is a scene's root",
             [](Json& d) {
                 d["scenes"][0]["nodes"] = {0, 1};
             }},
        Case{"has two parents", [](Json& d) { d["nodes"][2]["children"] = Json::array({0}); }},
        Case{"names no node", [](Json& d) { d["nodes"][2]["children"] = Json::array({17}); }},
        Case{"names no node", [](Json& d) { d["scenes"][0]["nodes"] = Json::array({3}); }},
        Case{"lists a node twice",
             [](Json& d) {
                 d["scenes"][0]["nodes"] = {1, 2, 1};
             }},
        Case{"scene names no scene", [](Json& d) { d["scene"] = 1; }},
        Case{"its rotation is no quaternion",
             [](Json& d) {
                 d["nodes"][1]["rotation"] = {0, 0, 0, 0};
             }},
        Case{"the last row of its matrix", [](Json& d) { d["nodes"][1]["matrix"] = std::vector<int>(16, 1); }},
        Case{"no node whose name starts with 'particle'", [](Json& d) { d["nodes"][0]["name"] = "cloud"; }},
        Case{"node 'particle': alpha must be a number from 0 to 1",
             [](Json& d) { d["nodes"][0]["extras"]["alpha"] = 1.5; }},
        Case{"node 'particle': alpha must be a number from 0 to 1",
             [](Json& d) { d["nodes"][0]["extras"]["alpha"] = "x"; }},
        Case{"glow must be one number or three", [](Json& d) { d["nodes"][0]["extras"]["glow"] = {1, 2}; }},
        Case{"glow must be a number from 0 to 100", [](Json& d) { d["nodes"][0]["extras"]["glow"] = {1, 2, -1}; }},
        Case{"reaches beyond 100000 m", [](Json& d) { d["nodes"][1]["scale"] = {1e6, 1e6, 1e6}; }},
        // Animations.
        Case{"moves a node that is not there",
             [](Json& d) { d["animations"][0]["channels"][0]["target"]["node"] = 5; }},
        Case{"has a sampler that is not there", [](Json& d) { d["animations"][0]["channels"][0]["sampler"] = 1; }},
        Case{"there is no interpolation 'SLOW'",
             [](Json& d) { d["animations"][0]["samplers"][0]["interpolation"] = "SLOW"; }},
        Case{"are not as many as their times",
             [](Json& d) { d["animations"][0]["samplers"][0]["interpolation"] = "CUBICSPLINE"; }},
        Case{"has a matrix and is animated",
             [](Json& d) { d["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}; }},
    };
    for (const Case& fault : faults) {
        GlbFile file = sample();
        fault.damage(file.document);
        CHECK_THAT(complaint_of(file.glb()), Catch::Contains(fault.complaint));
    }
}

TEST_CASE("numbers and indices that cannot be are refused", "[demo][gltf]") {
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    for (const float bad : {nan, infinity, -infinity}) {
        GlbFile file            = sample();
        const int bad_positions = file.floats("VEC3", {0, 0, 0, 1, 0, bad, 0, 1, 0});
        file.document["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = bad_positions;
        // A file may not say so in its least and greatest either: those are only asked for.
        file.document["accessors"][static_cast<std::size_t>(bad_positions)].erase("min");
        file.document["accessors"][static_cast<std::size_t>(bad_positions)].erase("max");
        CHECK_THAT(complaint_of(file.glb()), Catch::Contains("holds a number that is not finite"));
    }
    for (const int type : {tests::kUnsignedByte, tests::kUnsignedShort, tests::kUnsignedInt}) {
        GlbFile file                                           = sample();
        file.document["meshes"][0]["primitives"][0]["indices"] = file.integers(type, "SCALAR", {0, 3, 2});
        CHECK_THAT(complaint_of(file.glb()), Catch::Contains("go beyond its vertices"));
    }
    for (const std::vector<float>& times : {std::vector<float>{1, 1}, {1, 0.5}, {-1, 0}}) {
        GlbFile file = sample();
        file.document.erase("animations");
        file.animate(0, "scale", "STEP", times, {1, 1, 1, 2, 2, 2});
        CHECK_THAT(complaint_of(file.glb()), Catch::Contains("must start at 0 or later and ascend"));
    }
    GlbFile file = sample();
    file.animate(0, "rotation", "LINEAR", {0, 1}, {0, 0, 0, 1, 0, 0, 0, 0});
    CHECK_THAT(complaint_of(file.glb()), Catch::Contains("hold a rotation that is no quaternion"));
}

TEST_CASE("what is no glTF file is refused", "[demo][gltf]") {
    CHECK_THAT(complaint_of(""), Catch::Contains("the file is empty"));
    CHECK_THAT(complaint_of("a text"), Catch::Contains("malformed JSON at byte 1"));
    CHECK_THAT(complaint_of("[1, 2]"), Catch::Contains("the JSON is no object"));
    CHECK_THAT(complaint_of("{\"asset\": {\"version\": \"2.0\"}, \"x\": 1e999}"), Catch::Contains("too large"));
    CHECK_THAT(complaint_of("{}"), Catch::Contains("version"));
    // Neither the parser nor what takes the document apart may fall as deep as this.
    const std::string deep = "{\"asset\":{\"version\":\"2.0\"},\"extras\":";
    CHECK_THAT(complaint_of(deep + std::string(100000, '[')), Catch::Contains("nested too deeply"));
    CHECK_THAT(complaint_of(deep + std::string(100, '[') + std::string(100, ']') + "}"),
               Catch::Contains("nested too deeply"));
    std::string glb = tests::glb_bytes("{}", "");
    glb[4]          = 1;
    CHECK_THAT(complaint_of(glb), Catch::Contains("is glTF of version 1"));

    const ScratchDirectory directory;
    const auto complaint_at = [&](const std::string& path) {
        return complaint([&] { demo::GltfFile(FileReference{.path = path, .named_at = "here"}); });
    };
    CHECK(complaint_at("none.glb") == "here: none.glb: no such file");
    CHECK(complaint_at(directory.path()) == "here: " + directory.path() + ": is a directory");
    CHECK(complaint_at("/dev/null") == "here: /dev/null: is not a regular file");
}

TEST_CASE("a buffer beside the file is found by its name, with escapes", "[demo][gltf]") {
    const ScratchDirectory directory;
    GlbFile file             = sample();
    file.document["buffers"] = Json::array({{{"byteLength", file.binary.size()}, {"uri", "my%20cloud.bin"}}});
    tests::write_file(directory / "my cloud.bin", file.binary);
    tests::write_file(directory / "cloud.gltf", file.document.dump());
    const FileReference reference{.path = directory / "cloud.gltf", .named_at = "here"};
    CHECK(complaint([&] { demo::read_gltf_mesh(reference); }) == "");
    tests::write_file(directory / "my cloud.bin", file.binary + "more");
    CHECK_THAT(complaint([&] { demo::read_gltf_mesh(reference); }), Catch::Contains("size mismatch"));
}
