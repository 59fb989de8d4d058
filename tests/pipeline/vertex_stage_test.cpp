// SPDX-License-Identifier: MIT
#include "pipeline/execute/vertex_stage.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <random>

using namespace pipeline;

namespace {

constexpr PixelRect kViewport{10, 20, 110, 70};

// One pass with one draw and one camera; without matrices, positions are in clip space with w = 1.
struct Scene {
    Frame frame;
    DrawTriangles draw;
    VertexStageCounts counts;

    Scene() {
        frame.cameras.resize(1);
        frame.passes.resize(1);
        pass().camera = {0};
    }
    Pass& pass() { return frame.passes[0]; }
    PipelineState& state() { return pass().state; }
    Camera& camera() { return frame.cameras[0]; }

    std::uint32_t add(const Vec3& position, std::uint32_t diffuse = 0xffffffff) {
        Vertex vertex;
        vertex.position = position;
        vertex.diffuse  = {diffuse};
        frame.vertices.push_back(vertex);
        return static_cast<std::uint32_t>(frame.vertices.size() - 1);
    }
    void add_triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
        for (const Vec3& position : {a, b, c}) frame.indices.push_back(add(position));
    }
    std::vector<raster::Triangle> run(std::uint32_t first, std::uint32_t count) {
        raster::Draw staged;
        DrawTriangles part = draw;
        part.first_index   = first;
        part.index_count   = count;
        counts             = run_vertex_stage(frame, pass(), part, kViewport, staged);
        std::vector<raster::Triangle> out;
        for (const raster::TriangleCorners& corners : staged.triangles)
            out.push_back(raster::triangle_of(staged, corners));
        return out;
    }
    std::vector<raster::Triangle> run() { return run(0, static_cast<std::uint32_t>(frame.indices.size())); }
};

// clip = (x, y, z - near, z) * (any): depth 0 at z = 1, w = z.
Mat4 simple_perspective() {
    Mat4 m(1.0f);
    m[2] = Vec4(0, 0, 1, 1);
    m[3] = Vec4(0, 0, -1, 0);
    return m;
}

bool same(const raster::Vertex& a, const raster::Vertex& b) {
    const auto same_uv = [](const raster::TexCoord& p, const raster::TexCoord& q) {
        return p.s == q.s && p.t == q.t && p.q == q.q;
    };
    return a.x == b.x && a.y == b.y && a.z == b.z && a.rhw == b.rhw && a.diffuse == b.diffuse &&
           a.specular == b.specular && same_uv(a.uv[0], b.uv[0]) && same_uv(a.uv[1], b.uv[1]);
}
bool same(const std::vector<raster::Triangle>& a, const std::vector<raster::Triangle>& b) {
    const auto same_triangle = [](const raster::Triangle& p, const raster::Triangle& q) {
        return same(p[0], q[0]) && same(p[1], q[1]) && same(p[2], q[2]);
    };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_triangle);
}

// Twice the signed area, positive for clockwise.
double area(const raster::Triangle& t) {
    return (double{t[1].x} - t[0].x) * (double{t[2].y} - t[0].y) -
           (double{t[2].x} - t[0].x) * (double{t[1].y} - t[0].y);
}

bool within_guard_band(const raster::Vertex& v) {
    return v.x >= 10.0f - kGuardBand && v.x <= 110.0f + kGuardBand && v.y >= 20.0f - kGuardBand &&
           v.y <= 70.0f + kGuardBand && v.z >= 0.0f && v.z <= 1.0f && v.rhw > 0.0f && std::isfinite(v.rhw);
}

std::uint32_t fog_byte(const FogState& fog, const Vec3& position) {
    Scene scene;
    scene.camera().projection = glm::scale(Mat4(1.0f), Vec3(0.01f));
    scene.state().fog         = fog;
    scene.add_triangle(position, position + Vec3(40, 0, 0), position + Vec3(0, 40, 0));
    const auto out = scene.run();
    REQUIRE(out.size() == 1);
    return out[0][0].specular >> 24;
}

}  // namespace

TEST_CASE("the viewport maps clip space to pixels, y down", "[vertex_stage]") {
    Scene scene;
    scene.add_triangle({-1, 1, 0}, {1, -1, 1}, {-0.5f, 0, 0.25f});
    const auto out = scene.run();
    REQUIRE(out.size() == 1);
    CHECK((out[0][0].x == 10 && out[0][0].y == 20 && out[0][0].z == 0));
    CHECK((out[0][1].x == 110 && out[0][1].y == 70 && out[0][1].z == 1));
    CHECK((out[0][2].x == 35 && out[0][2].y == 45 && out[0][2].z == 0.25f));
    for (const raster::Vertex& vertex : out[0]) CHECK(vertex.rhw == 1);
}

TEST_CASE("a range is one of the frame's indices", "[vertex_stage]") {
    Scene scene;
    for (const float x : {0.0f, 0.25f, 0.5f, 0.75f}) scene.add_triangle({x, 1, 0}, {1, -1, 0}, {-1, 0, 0});
    scene.draw.first_index = 3;
    scene.draw.index_count = 9;
    const auto out         = scene.run(6, 6);
    REQUIRE(out.size() == 2);
    CHECK(out[0][0].x == 85);
    CHECK(out[1][0].x == 97.5f);
}

TEST_CASE("projection * view * world, and the division by w", "[vertex_stage]") {
    Scene scene;
    scene.draw.world          = glm::translate(Mat4(1.0f), Vec3(1, 0, 0));
    scene.camera().view       = glm::scale(Mat4(1.0f), Vec3(2, 1, 4));
    scene.camera().projection = simple_perspective();
    scene.add_triangle({0, -2, 1}, {0, 2, 1}, {-3, 0, 2});
    const auto out = scene.run();  // camera space (2, -2, 4), (2, 2, 4), (-4, 0, 8)
    REQUIRE(out.size() == 1);
    CHECK((out[0][0].x == 85 && out[0][0].y == 57.5f && out[0][0].z == 0.75f && out[0][0].rhw == 0.25f));
    CHECK((out[0][1].x == 85 && out[0][1].y == 32.5f && out[0][1].z == 0.75f && out[0][1].rhw == 0.25f));
    CHECK((out[0][2].x == 35 && out[0][2].y == 45 && out[0][2].z == 0.875f && out[0][2].rhw == 0.125f));
}

TEST_CASE("culling goes by the sign of the area on the screen", "[vertex_stage]") {
    Scene scene;
    const Vec3 a{0, 0.5f, 0}, b{0.5f, -0.5f, 0}, c{-0.5f, -0.5f, 0};
    scene.add_triangle(a, b, c);  // clockwise: top, right, left
    scene.add_triangle(a, c, b);
    scene.add_triangle(a, b, b);                                       // no area
    scene.add_triangle({0, 0, 0}, {0.0001f, 0, 0}, {0, 0.0001f, 0});   // none once snapped
    scene.add_triangle({-0.5f, 0, 0}, {0, 0.0001f, 0}, {0.5f, 0, 0});  // likewise
    const auto drawn = [&](CullMode mode) {
        scene.state().cull = mode;
        return scene.run();
    };
    CHECK(drawn(CullMode::None).size() == 2);
    CHECK(scene.counts.triangles_in == 5);
    CHECK(scene.counts.triangles_drawn == 2);
    REQUIRE(drawn(CullMode::Clockwise).size() == 1);
    CHECK(area(drawn(CullMode::Clockwise)[0]) < 0);
    REQUIRE(drawn(CullMode::CounterClockwise).size() == 1);
    CHECK(area(drawn(CullMode::CounterClockwise)[0]) > 0);

    scene.camera().projection = glm::translate(Mat4(1.0f), Vec3(0, 0, -0.125f));  // all behind the near plane
    CHECK(drawn(CullMode::None).empty());
    scene.camera().projection[0][2] = 0.5f;  // the right part of each before it
    for (const raster::Triangle& triangle : drawn(CullMode::Clockwise)) CHECK(area(triangle) < 0);
    for (const raster::Triangle& triangle : drawn(CullMode::CounterClockwise)) CHECK(area(triangle) > 0);
    CHECK(drawn(CullMode::None).size() == drawn(CullMode::Clockwise).size() + drawn(CullMode::CounterClockwise).size());
    CHECK(drawn(CullMode::Clockwise).size() > 0);
}

TEST_CASE("what reaches into the guard band is not cut, what misses the viewport is dropped", "[vertex_stage]") {
    Scene scene;
    scene.add_triangle({-50, 0, 0}, {50, 100, 0}, {50, -100, 0});  // x 2500 pixels out, the band is 4096
    const auto whole = scene.run();
    REQUIRE(whole.size() == 1);
    CHECK((whole[0][0].x == 60 - 2500 && whole[0][0].y == 45));
    CHECK((whole[0][1].x == 60 + 2500 && whole[0][1].y == 45 - 2500));

    scene.frame.indices.clear();
    scene.add_triangle({1.5f, 0, 0}, {2, 1, 0}, {2, -1, 0});
    scene.add_triangle({0, 0, 1.5f}, {0, 1, 1.25f}, {1, 0, 1.125f});
    scene.add_triangle({0, 0, -1.5f}, {0, 1, -1.25f}, {1, 0, -1.125f});
    CHECK(scene.run().empty());

    scene.frame.indices.clear();
    scene.add_triangle({-500, -500, 0}, {0, 500, 0}, {500, -500, 0});
    double covered   = 0;
    const auto parts = scene.run();
    CHECK(parts.size() > 1);
    for (const raster::Triangle& triangle : parts) {
        CHECK(area(triangle) > 0);
        covered += area(triangle) / 2;
        for (const raster::Vertex& vertex : triangle) CHECK(within_guard_band(vertex));
    }
    // 500 half viewports are 25000 and 12500 pixels, so the sides pass |x| = 4146 at y = 8354 above the centre, beyond
    // the top of the guard band, 4121: all of it is covered.
    CHECK(covered == Approx((2.0 * 4146) * (2.0 * 4121)));
}

TEST_CASE("the near plane cuts, and colours follow as floats", "[vertex_stage]") {
    Scene scene;
    scene.camera().projection = simple_perspective();
    scene.frame.indices       = {scene.add({0, 0, 3}, 0xffff0000), scene.add({0, 1, 0}, 0x0000ff00),
                                 scene.add({1, 0, 0}, 0xff0000ff)};
    const auto out            = scene.run();  // one corner before, two behind: cut at 2/3 of the way
    REQUIRE(out.size() == 1);
    CHECK(out[0][0].z == Approx(2.0 / 3));
    CHECK(out[0][0].diffuse == 0xffff0000);
    CHECK(out[0][1].y == Approx(45 - 25 * 2.0 / 3));
    CHECK(out[0][1].z == 0.0f);
    CHECK(out[0][1].rhw == Approx(1));
    CHECK(out[0][1].diffuse == 0x5555aa00);
    CHECK(out[0][2].diffuse == 0xff5500aa);
}

TEST_CASE("flat shading keeps the first vertex's colours and fog through clipping", "[vertex_stage]") {
    Scene scene;
    scene.camera().projection        = simple_perspective();
    scene.state().shade              = ShadeMode::Flat;
    scene.state().fog                = {.mode = FogMode::Linear, .start = 0.0f, .end = 4.0f};
    scene.frame.indices              = {scene.add({0, 0, 0.5f}, 0x12345678), scene.add({0, 1, 3}, 0xff00ff00),
                                        scene.add({1, 0, 3}, 0xff0000ff)};
    scene.frame.vertices[0].specular = {0x00abcdef};
    const auto clipped               = scene.run();
    CHECK(clipped.size() == 2);
    scene.frame.vertices[0].position.z = 2;
    const auto whole                   = scene.run();
    CHECK(whole.size() == 1);
    for (const raster::Triangle& triangle : clipped)
        for (const raster::Vertex& vertex : triangle) {
            CHECK(vertex.diffuse == 0x12345678);
            CHECK(vertex.specular == 0xdfabcdef);  // 7/8: 223.125
        }
    for (const raster::Vertex& vertex : whole[0]) {
        CHECK(vertex.diffuse == 0x12345678);
        CHECK(vertex.specular == 0x80abcdef);  // 1/2: 127.5
    }
}

TEST_CASE("colours pass through as the bytes they are", "[vertex_stage]") {
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        Scene scene;
        scene.add_triangle({0, 0.5f, 0}, {0.5f, 0, 0}, {0, 0, 0});
        for (Vertex& vertex : scene.frame.vertices) {
            vertex.diffuse  = {byte * 0x01010101};
            vertex.specular = {byte * 0x00010101};
        }
        const auto out = scene.run();
        REQUIRE(out.size() == 1);
        REQUIRE(out[0][2].diffuse == byte * 0x01010101);
        REQUIRE(out[0][2].specular == (0xff000000 | byte * 0x00010101));
    }
}

TEST_CASE("lighting reaches the vertex colours, rounded half up", "[vertex_stage]") {
    Scene scene;
    scene.add_triangle({0, 0.5f, 0.5f}, {0.5f, 0, 0.5f}, {0, 0, 0.5f});
    for (Vertex& vertex : scene.frame.vertices) vertex.normal = {0, 0, -1};
    LightingState& lighting   = scene.state().lighting;
    lighting.enabled          = true;
    lighting.diffuse_source   = ColorSource::Material;
    lighting.material.diffuse = {1, 1, 1, 0.5f};
    lighting.lights           = {{.diffuse = {0.5f, -1, 7}}};
    const auto out            = scene.run();
    REQUIRE(out.size() == 1);
    for (const raster::Vertex& vertex : out[0]) {
        CHECK(vertex.diffuse == 0x808000ff);
        CHECK(vertex.specular == 0xff000000);
    }
}

TEST_CASE("vertex fog", "[vertex_stage]") {
    const Vec3 p{3, 0, 4};
    CHECK(fog_byte({}, p) == 255);
    CHECK(fog_byte({.mode = FogMode::Linear, .start = 0, .end = 16}, p) == 191);                 // 12/16: 191.25
    CHECK(fog_byte({.mode = FogMode::Linear, .start = 0, .end = 10, .range = true}, p) == 128);  // 127.5
    CHECK(fog_byte({.mode = FogMode::Linear, .start = 4, .end = 8}, p) == 255);
    CHECK(fog_byte({.mode = FogMode::Linear, .start = 5, .end = 8}, p) == 255);
    CHECK(fog_byte({.mode = FogMode::Linear, .start = 1, .end = 3}, p) == 0);
    CHECK(fog_byte({.mode = FogMode::Linear, .start = 9, .end = 9}, p) == 0);
    CHECK(fog_byte({.mode = FogMode::Exp, .density = 0.25f}, p) == 94);                  // 255 / e = 93.81
    CHECK(fog_byte({.mode = FogMode::Exp, .density = 0.1f, .range = true}, p) == 155);   // 255 e^-0.5 = 154.67
    CHECK(fog_byte({.mode = FogMode::Exp2, .density = 0.125f}, p) == 199);               // 255 e^-0.25 = 198.59
    CHECK(fog_byte({.mode = FogMode::Exp2, .density = 0.1f, .range = true}, p) == 199);  // the same
    CHECK(fog_byte({.mode = FogMode::Exp2, .density = 1e30f}, p) == 0);
}

TEST_CASE("texture coordinates of the vertex and of camera space", "[vertex_stage]") {
    Scene scene;
    scene.camera().view                  = glm::translate(Mat4(1.0f), Vec3(0.25f, 0, 0));
    scene.state().stages[0].color_op     = TextureOp::Modulate;
    scene.state().stages[0].coords       = CoordSource::Vertex1;
    scene.state().stages[1].color_op     = TextureOp::Modulate;
    scene.state().stages[1].coords       = CoordSource::CameraPosition;
    scene.state().stages[1].transform    = glm::scale(Mat4(1.0f), Vec3(2, 4, 8));
    scene.state().stages[1].transform[3] = Vec4(0, 1, 0, 1);
    scene.add_triangle({0.25f, 0.5f, 0.5f}, {0.5f, 0, 0.5f}, {0, 0, 0.5f});
    scene.frame.vertices[0].uv0 = {5, 6};
    scene.frame.vertices[0].uv1 = {7, -8};
    const auto vertex           = scene.run().at(0)[0];
    CHECK((vertex.uv[0].s == 7 && vertex.uv[0].t == -8 && vertex.uv[0].q == 1));
    CHECK((vertex.uv[1].s == 1 && vertex.uv[1].t == 3 && vertex.uv[1].q == 4));
    scene.state().stages[0].coords = CoordSource::Vertex0;
    CHECK(scene.run().at(0)[0].uv[0].s == 5);
}

TEST_CASE("any split of a draw gives the same triangles, from near or scattered indices", "[vertex_stage]") {
    Scene scene;
    std::mt19937 random(2);
    const auto in = [&](float least, float greatest) {
        return static_cast<float>(least + (greatest - least) * (static_cast<double>(random()) / 4294967296.0));
    };
    for (int i = 0; i < 60; ++i) scene.add({in(-3, 3), in(-3, 3), in(-1, 4)}, static_cast<std::uint32_t>(random()));
    scene.camera().projection = simple_perspective();
    for (int i = 0; i < 3 * 200; ++i) scene.frame.indices.push_back(static_cast<std::uint32_t>(random() % 60));
    scene.draw.first_index = 6;
    scene.draw.index_count = 594;
    const auto whole       = scene.run(6, 594);
    CHECK(whole.size() > 100);
    CHECK(scene.counts.triangles_drawn == whole.size());

    auto parts      = scene.run(6, 270);
    const auto rest = scene.run(276, 324);
    parts.insert(parts.end(), rest.begin(), rest.end());
    CHECK(same(whole, parts));

    Scene scattered = scene;
    scattered.frame.vertices.assign(60 * 5000, Vertex{});
    for (std::size_t i = 0; i < 60; ++i) scattered.frame.vertices[(59 - i) * 5000 + 7] = scene.frame.vertices[i];
    for (std::uint32_t& index : scattered.frame.indices) index = (59 - index) * 5000 + 7;
    CHECK(same(whole, scattered.run(6, 594)));
    CHECK(scene.run(0, 0).empty());
}

TEST_CASE("huge and overflowing coordinates give triangles within bounds, or none", "[vertex_stage]") {
    std::mt19937 random(4);
    const auto in = [&](float size) {
        return static_cast<float>(size * (2.0 * static_cast<double>(random()) / 4294967296.0 - 1.0));
    };
    Scene scene;
    scene.camera().projection = simple_perspective();
    for (int i = 0; i < 6000; ++i) {
        const float size = std::ldexp(1.0f, i / 30 - 72);
        scene.frame.indices.push_back(scene.add({in(size), in(size), in(size)}));
    }
    scene.state().stages[0].color_op = TextureOp::Modulate;
    scene.state().stages[0].coords   = CoordSource::CameraPosition;
    const auto out                   = scene.run();
    CHECK(out.size() > 300);
    for (const raster::Triangle& triangle : out)
        for (const raster::Vertex& vertex : triangle) {
            REQUIRE(within_guard_band(vertex));
            REQUIRE(std::abs(vertex.uv[0].s * vertex.rhw) < 0x1p40f);
        }

    const float most = std::numeric_limits<float>::max();
    Scene overflow;
    overflow.add_triangle({0, 0.5f, 0}, {most, 0, 0}, {0, 0, 0});
    CHECK(overflow.run().size() > 0);
    overflow.draw.world = glm::scale(Mat4(1.0f), Vec3(2, 1, 1));
    CHECK(overflow.run().empty());
    overflow.draw.world = glm::scale(Mat4(1.0f), Vec3(0.0f));
    CHECK(overflow.run().empty());

    Scene texture;
    texture.add_triangle({0, 0.5f, 0}, {0.5f, 0, 0}, {0, 0, 0});
    texture.frame.vertices[1].uv0 = {0x1p40f, 0};
    CHECK(texture.run().size() == 1);  // not read
    texture.state().stages[0].color_op = TextureOp::Modulate;
    CHECK(texture.run().empty());
    texture.frame.vertices[1].uv0.x = 0x1p39f;
    CHECK(texture.run().size() == 1);
}
