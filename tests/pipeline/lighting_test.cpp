// SPDX-License-Identifier: MIT
#include "pipeline/execute/lighting.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <random>

#include "pipeline/execute/vector_math.h"

using namespace pipeline;

namespace {

class Random {
  public:
    explicit Random(std::uint32_t seed) : bits_(seed) {}
    std::uint32_t word() { return static_cast<std::uint32_t>(bits_()); }
    bool coin() { return word() & 0x10000; }
    float in(float least, float greatest) {
        return static_cast<float>(least + (greatest - least) * (word() / 4294967296.0));
    }
    Vec3 vector(float size) { return {in(-size, size), in(-size, size), in(-size, size)}; }
    Vec3 direction() {
        for (;;)
            if (const Vec3 v = vector(1.0f); length3(v) > 0.1 && length3(v) < 1.0) return normalize3(v);
    }

  private:
    std::mt19937 bits_;
};

// The same equation by other means: in double, with glm's own inverse, and std::pow.
struct Expected {
    glm::dvec4 diffuse{0.0};
    glm::dvec3 specular{0.0};
    bool near_a_threshold = false;  // a comparison that single precision may decide otherwise
};

glm::dvec4 bytes(Argb c) {
    return glm::dvec4((c.value >> 16) & 255, (c.value >> 8) & 255, c.value & 255, c.value >> 24) / 255.0;
}

Expected expected_colors(const LightingState& state, const Mat4& view, const Mat4& world, const Vertex& vertex) {
    const glm::dmat4 model_view = glm::dmat4(view) * glm::dmat4(world);
    const glm::dvec3 position(model_view * glm::dvec4(glm::dvec3(vertex.position), 1.0));
    glm::dvec3 normal = glm::transpose(glm::inverse(glm::dmat3(model_view))) * glm::dvec3(vertex.normal);
    if (state.normalize_normals && glm::length(normal) > 0.0) normal = glm::normalize(normal);

    const glm::dvec4 colors[] = {glm::dvec4(0.0), bytes(vertex.diffuse), bytes(vertex.specular)};
    const auto source         = [&](ColorSource from, const glm::dvec4& material) {
        return from == ColorSource::Material ? material : colors[static_cast<int>(from)];
    };
    const Material& m        = state.material;
    const glm::dvec4 diffuse = source(state.diffuse_source, m.diffuse);
    const glm::dvec3 ambient(source(state.ambient_source, Vec4(m.ambient, 0)));
    const glm::dvec3 specular(source(state.specular_source, Vec4(m.specular, 0)));
    const glm::dvec3 emissive(source(state.emissive_source, Vec4(m.emissive, 0)));

    Expected result;
    glm::dvec3 color = emissive + ambient * glm::dvec3(state.ambient), gleam(0.0);
    for (const Light& light : state.lights) {
        glm::dvec3 to_light = -glm::normalize(glm::dmat3(view) * glm::dvec3(light.direction));
        double attenuation  = 1.0;
        if (light.type == LightType::Point) {
            const glm::dvec3 path = glm::dvec3(view * Vec4(light.position, 1.0f)) - position;
            const double d        = glm::length(path);
            to_light              = path / d;
            const glm::dvec3 a(light.attenuation);
            attenuation = d <= light.range ? 1.0 / (a.x + a.y * d + a.z * d * d) : 0.0;
            if (std::abs(d - light.range) < 1e-3) result.near_a_threshold = true;
        }
        const glm::dvec3 to_viewer = state.local_viewer ? -glm::normalize(position) : glm::dvec3(0, 0, -1);
        const double n_l           = glm::dot(normal, to_light);
        const double n_h           = glm::dot(normal, glm::normalize(to_light + to_viewer));
        if (std::abs(n_l) < 1e-4 || std::abs(n_h) < 1e-4) result.near_a_threshold = true;
        color += attenuation * (ambient * glm::dvec3(light.ambient));
        color += attenuation * std::max(0.0, n_l) * (glm::dvec3(diffuse) * glm::dvec3(light.diffuse));
        if (state.specular_enable && n_l > 0.0 && n_h > 0.0)
            gleam += attenuation * std::pow(n_h, m.power) * (specular * glm::dvec3(light.specular));
    }
    result.diffuse  = glm::clamp(glm::dvec4(color, diffuse.a), 0.0, 1.0);
    result.specular = glm::clamp(gleam, 0.0, 1.0);
    return result;
}

Light random_light(Random& random) {
    Light light;
    light.type        = random.coin() ? LightType::Point : LightType::Directional;
    light.diffuse     = random.vector(1.0f);  // negative colours are among them
    light.specular    = random.vector(1.0f);
    light.ambient     = random.vector(0.3f);
    light.position    = random.vector(10.0f);
    light.direction   = random.vector(3.0f);
    light.range       = random.in(2.0f, 30.0f);
    light.attenuation = {random.in(0.2f, 1.0f), random.in(0.0f, 0.3f), random.in(0.0f, 0.1f)};
    return light;
}

LightingState random_lighting(Random& random) {
    const auto source = [&] { return static_cast<ColorSource>(random.word() % 3); };
    LightingState state;
    state.enabled           = true;
    state.specular_enable   = random.word() % 4 != 0;
    state.local_viewer      = random.coin();
    state.normalize_normals = random.coin();
    state.ambient           = random.vector(0.3f);
    state.diffuse_source    = source();
    state.ambient_source    = source();
    state.specular_source   = source();
    state.emissive_source   = source();
    state.material          = {.diffuse  = Vec4{random.vector(1.0f), random.in(0.0f, 1.0f)},
                               .ambient  = random.vector(1.0f),
                               .specular = random.vector(1.0f),
                               .emissive = random.vector(0.3f),
                               .power    = random.coin() ? random.in(0.5f, 60.0f) : 0.0f};
    state.lights.resize(random.word() % (kMaxLights + 1));
    for (Light& light : state.lights) light = random_light(random);
    return state;
}

Mat4 random_motion(Random& random) {
    const Vec3 offset = random.vector(5.0f), axis = random.direction();
    return glm::rotate(glm::translate(Mat4(1.0f), offset), random.in(-3.0f, 3.0f), axis);
}

Vertex vertex_at(const Vec3& position, const Vec3& normal) {
    Vertex vertex;
    vertex.position = position;
    vertex.normal   = normal;
    return vertex;
}

// Lit in a camera space that is the world, at `position`.
VertexColors lit(const LightingState& state, const Vertex& vertex) {
    return light_vertex(prepare_lighting(state, Mat4(1.0f), Mat4(1.0f)), vertex, vertex.position);
}

LightingState lit_state(std::vector<Light> lights) {
    LightingState state;
    state.enabled        = true;
    state.diffuse_source = ColorSource::Material;
    state.lights         = std::move(lights);
    return state;
}

}  // namespace

TEST_CASE("lighting agrees with the equation in double precision", "[lighting]") {
    Random random(7);
    int compared = 0;
    for (int round = 0; round < 3000; ++round) {
        const LightingState state = random_lighting(random);
        const Mat4 view           = random_motion(random);
        const Mat4 motion         = random_motion(random);
        const Vec3 size{random.in(0.5f, 2.0f), random.in(0.5f, 2.0f), random.in(0.5f, 2.0f)};
        const Mat4 world = glm::scale(motion, size);
        const Vertex vertex{.position = random.vector(2.0f),
                            .normal   = random.direction(),
                            .diffuse  = {random.word()},
                            .specular = {random.word()}};
        const Expected want = expected_colors(state, view, world, vertex);
        if (want.near_a_threshold) continue;
        ++compared;

        const Vec3 position(glm::dmat4(view) * glm::dmat4(world) * glm::dvec4(glm::dvec3(vertex.position), 1.0));
        const VertexColors got = light_vertex(prepare_lighting(state, view, world), vertex, position);
        INFO("round " << round);
        for (int i = 0; i < 4; ++i) REQUIRE(got.diffuse[i] == Approx(want.diffuse[i]).margin(1e-4));
        for (int i = 0; i < 3; ++i) REQUIRE(got.specular[i] == Approx(want.specular[i]).margin(1e-4));
    }
    CHECK(compared > 2800);
}

TEST_CASE("with lighting off the vertex's own colours pass", "[lighting]") {
    const VertexColors colors = lit({}, {.diffuse = {0x80ff3300}, .specular = {0x12003366}});
    CHECK(colors.diffuse == Vec4(1.0f, 0.2f, 0.0f, 128.0f / 255.0f));
    CHECK(colors.specular == Vec3(0.0f, 0.2f, 0.4f));
}

TEST_CASE("a light facing the surface, by hand", "[lighting]") {
    const Vertex vertex     = vertex_at({0, 0, 4}, {0, 0, -1});
    LightingState state     = lit_state({{.diffuse = {0.5f, 1.0f, 2.0f}, .direction = {0, 0, 8}}});
    state.material.diffuse  = {0.5f, 0.25f, 0.75f, 0.375f};
    state.material.emissive = {0.125f, 0, 0};
    SECTION("diffuse and emissive, clamped after the sum; alpha is the material's") {
        CHECK(lit(state, vertex).diffuse == Vec4(0.375f, 0.25f, 1.0f, 0.375f));
    }
    SECTION("from behind, nothing") {
        state.lights[0].direction = {0, 0, -1};
        CHECK(lit(state, vertex).diffuse == Vec4(0.125f, 0, 0, 0.375f));
    }
    SECTION("a point light fades, and ends after its range") {
        state.lights[0].type        = LightType::Point;
        state.lights[0].position    = {0, 0, 2};
        state.lights[0].attenuation = {0, 1, 0.5f};  // 1 / (2 + 2)
        state.lights[0].range       = 2.0f;
        CHECK(lit(state, vertex).diffuse == Vec4(0.1875f, 0.0625f, 0.375f, 0.375f));
        state.lights[0].range = 1.9375f;
        CHECK(lit(state, vertex).diffuse == Vec4(0.125f, 0, 0, 0.375f));
    }
    SECTION("attenuation of nothing at all saturates, and leaves a black channel black") {
        state.lights[0] = {
            .type = LightType::Point, .diffuse = {1, 0, 0}, .position = {0, 0, 2}, .attenuation = {0, 0, 0}};
        CHECK(lit(state, vertex).diffuse == Vec4(1.0f, 0, 0, 0.375f));
    }
    SECTION("a vertex without a normal gets ambient and emissive light only") {
        state.ambient          = {0, 0.5f, 0};
        state.material.ambient = {1, 0.5f, 1};
        CHECK(lit(state, vertex_at({0, 0, 4}, Vec3(0.0f))).diffuse == Vec4(0.125f, 0.25f, 0, 0.375f));
    }
}

TEST_CASE("the specular power and the two viewers", "[lighting]") {
    LightingState state     = lit_state({{.specular = Vec3(1.0f), .direction = {0, 0, 1}}});
    state.specular_enable   = true;
    state.specular_source   = ColorSource::Material;
    state.material.specular = {0.5f, 0.25f, 1.0f};
    const Vertex aside      = vertex_at({3, 0, 4}, {0, 0, -1});
    SECTION("power 0 is a factor of 1") {
        CHECK(lit(state, aside).specular == state.material.specular);
    }
    SECTION("infinitely far viewer: the half vector is the normal") {
        state.material.power = 1000.0f;
        state.local_viewer   = false;
        CHECK(lit(state, aside).specular == state.material.specular);
    }
    SECTION("local viewer: the half vector lies between (0, 0, -1) and (-3, 0, -4) / 5, at cosine sqrt(0.9)") {
        state.material.power = 4.0f;
        CHECK(lit(state, aside).specular.z == Approx(0.81));
    }
    SECTION("specular disabled is black") {
        state.specular_enable = false;
        CHECK(lit(state, aside).specular == Vec3(0.0f));
    }
}

TEST_CASE("two opposite lights, one negative, wrap the light around", "[lighting]") {
    LightingState state =
        lit_state({{.diffuse = Vec3(0.5f), .direction = {0, 0, 1}}, {.diffuse = Vec3(-0.5f), .direction = {0, 0, -1}}});
    state.ambient = Vec3(0.5f);
    for (int degrees = 0; degrees <= 180; degrees += 5) {
        const double angle  = degrees * 3.14159265358979 / 180;
        const Vec3 normal   = {static_cast<float>(std::sin(angle)), 0.0f, -static_cast<float>(std::cos(angle))};
        const Vec4 diffuse  = lit(state, vertex_at({0, 0, 1}, normal)).diffuse;
        const double wanted = (1.0 + std::cos(angle)) / 2.0;
        CHECK(diffuse.r == Approx(wanted).margin(1e-6));
    }
}

TEST_CASE("normals keep to the surface under any scale, and length follows it unless normalised", "[lighting]") {
    LightingState state = lit_state({{.diffuse = Vec3(1.0f), .direction = {0, 0, 1}}});
    const Vertex vertex = vertex_at(Vec3(0.0f), {0, 0, -0.5f});
    const auto red      = [&](float scale) {
        const Mat4 world = glm::scale(Mat4(1.0f), Vec3(scale));
        return light_vertex(prepare_lighting(state, Mat4(1.0f), world), vertex, Vec3(0.0f)).diffuse.r;
    };
    CHECK(red(1.0f) == 0.5f);
    CHECK(red(2.0f) == 0.25f);
    CHECK(red(0.0f) == 0.0f);
    state.normalize_normals = true;
    for (const float scale : {1e-30f, 0.1f, 1.0f, 3.0f, 1e30f}) CHECK(red(scale) == 1.0f);
}
