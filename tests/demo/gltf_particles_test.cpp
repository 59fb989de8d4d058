// SPDX-License-Identifier: MIT
// Mega-particles from nodes, worked out by hand, still and moving.
#include "demo/gltf_particles.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "demo/gltf_animation.h"
#include "tests/support/child_process.h"
#include "tests/support/glb_file.h"

namespace {

using cloud::Particle;
using demo::Vec3;
using tests::GlbFile;
using tests::Json;
using tests::ScratchDirectory;

demo::ParticleFile read(const GlbFile& file) {
    const ScratchDirectory directory;
    tests::write_file(directory / "cloud.glb", file.glb());
    return demo::ParticleFile({.path = directory / "cloud.glb", .named_at = "here"});
}

Particle only_particle(const GlbFile& file, double seconds = 0.0) {
    const std::vector<Particle> particles = read(file).at(seconds);
    REQUIRE(particles.size() == 1);
    return particles[0];
}

bool is_near(const glm::mat3& a, const glm::mat3& b) {
    float most = 0.0f;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) most = std::max(most, std::abs(a[column][row] - b[column][row]));
    return most < 1e-6f;
}

bool is_near(const Vec3& a, const Vec3& b) {
    return glm::length(a - b) < 1e-5f;
}

glm::mat3 diagonal(float x, float y, float z) {
    return {x, 0, 0, 0, y, 0, 0, 0, z};
}

// x to y by `degrees`.
glm::mat3 turn_about_z(double degrees) {
    const double angle = degrees * 3.14159265358979323846 / 180.0;
    const auto c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
    return {c, s, 0, -s, c, 0, 0, 0, 1};
}

// As quaternion.
std::vector<float> about_z(double degrees) {
    const double half = degrees * 3.14159265358979323846 / 360.0;
    return {0, 0, static_cast<float>(std::sin(half)), static_cast<float>(std::cos(half))};
}

}  // namespace

TEST_CASE("an empty named particle is a sphere of its scale", "[demo][gltf]") {
    GlbFile file;
    file.root({{"name", "particle"}, {"translation", {1, 2, -3}}, {"scale", {7, 7, 7}}});
    const demo::ParticleFile particles = read(file);
    CHECK(particles.duration() == 0.0);
    REQUIRE(particles.at(5.0).size() == 1);
    const Particle particle = particles.at(5.0)[0];
    CHECK(particle.center == Vec3(1, 2, -3));
    CHECK(particle.radius == 7.0f);
    CHECK(particle.shape == glm::mat3(1.0f));
    CHECK(particle.color == Vec3(1.0f));
    CHECK(particle.alpha == 1.0f);
    CHECK(particle.glow == Vec3(0.0f));
    CHECK(particle.generation == 0);
}

TEST_CASE("particles are told by their names", "[demo][gltf]") {
    GlbFile file;
    int count = 0;
    for (const char* name : {"particle", "Particle.001", "PARTICLES of smoke", "partikel", "my particle", "", "part"}) {
        file.root({{"name", name}, {"translation", {count++, 0, 0}}});
    }
    file.root({{"translation", {9, 0, 0}}});
    std::vector<float> places;
    for (const Particle& particle : read(file).at(0.0)) places.push_back(particle.center.x);
    CHECK(places == std::vector<float>{0, 1, 2});
}

TEST_CASE("scale, rotation, shear and mirrors become the shape, with determinant 1", "[demo][gltf]") {
    GlbFile file;
    SECTION("an ellipsoid") {
        // 8 = 2^3: axes 4, 2, 1 over 2.
        file.root({{"name", "particle"}, {"scale", {4, 2, 1}}});
        CHECK(only_particle(file).radius == Approx(2.0));
        CHECK(is_near(only_particle(file).shape, diagonal(2.0f, 1.0f, 0.5f)));
    }
    SECTION("turned") {
        file.root({{"name", "particle"}, {"scale", {4, 2, 1}}, {"rotation", about_z(90)}});
        CHECK(is_near(only_particle(file).shape, turn_about_z(90) * diagonal(2.0f, 1.0f, 0.5f)));
    }
    SECTION("in a mirror") {
        file.root({{"name", "particle"}, {"scale", {-4, 2, 1}}});
        CHECK(only_particle(file).radius == Approx(2.0));
        CHECK(is_near(only_particle(file).shape, diagonal(2.0f, -1.0f, -0.5f)));
        CHECK(glm::determinant(only_particle(file).shape) == Approx(1.0));
    }
    SECTION("sheared by its parent") {
        const int child =
            file.add("nodes", {{"name", "particle"}, {"rotation", about_z(45)}, {"translation", {1, 1, 0}}});
        file.root({{"scale", {2, 1, 1}}, {"children", Json::array({child})}});
        const Particle particle = only_particle(file);
        CHECK(is_near(particle.center, Vec3(2, 1, 0)));
        const auto radius = static_cast<float>(std::cbrt(2.0));
        CHECK(particle.radius == Approx(radius));
        CHECK(is_near(particle.shape * radius, diagonal(2, 1, 1) * turn_about_z(45)));
    }
}

TEST_CASE("a mesh gives a particle its size and its colours", "[demo][gltf]") {
    GlbFile file;
    // Half of the largest side is 3; where the mesh lies about its origin does not matter.
    const int positions = file.floats("VEC3", {-1, 0, 0, 5, 0, 0, 0, 2, 1});
    file.add("materials", {{"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.25, 1.0, 0.75}}}},
                           {"emissiveFactor", {0, 0.5, 1}}});
    const Json attributes = {{"POSITION", positions}};
    file.add("meshes", {{"primitives", Json::array({{{"attributes", attributes}, {"material", 0}}})}});
    file.root({{"name", "particle"}, {"mesh", 0}, {"scale", {2, 2, 2}}, {"translation", {0, 10, 0}}});
    const Particle particle = only_particle(file);
    CHECK(particle.center == Vec3(0, 10, 0));
    CHECK(particle.radius == 6.0f);
    CHECK(particle.color == Vec3(0.5f, 0.25f, 1.0f));
    CHECK(particle.alpha == 0.75f);
    CHECK(particle.glow == Vec3(0.0f, 0.5f, 1.0f));

    file.document["nodes"][0]["extras"] = {{"alpha", 0.5}, {"glow", {3, 2.5, 0}}, {"other", "text"}};
    CHECK(only_particle(file).alpha == 0.5f);
    CHECK(only_particle(file).glow == Vec3(3.0f, 2.5f, 0.0f));
    CHECK(only_particle(file).color == Vec3(0.5f, 0.25f, 1.0f));
    file.document["nodes"][0]["extras"] = {{"glow", 2}};
    CHECK(only_particle(file).alpha == 0.75f);
    CHECK(only_particle(file).glow == Vec3(2.0f));
}

TEST_CASE("keys move particles, and their parents do", "[demo][gltf]") {
    GlbFile file;
    const int particle = file.add("nodes", {{"name", "particle"}, {"translation", {1, 0, 0}}});
    const int parent   = file.root({{"children", Json::array({particle})}, {"translation", {0, 7, 0}}});
    file.animate(particle, "scale", "LINEAR", {1, 3}, {1, 1, 1, 2, 2, 2});
    file.animate(particle, "translation", "STEP", {0, 2, 4}, {0, 0, 0, 10, 0, 0, 20, 0, 0});
    file.animate(parent, "rotation", "LINEAR", {0, 1}, {0, 0, 0, 1, 0, 0, 1, 0});
    const demo::ParticleFile particles = read(file);
    CHECK(particles.duration() == 4.0);
    const auto at = [&](double seconds) { return particles.at(seconds).at(0); };
    // Before, at and after keys.
    CHECK(at(-1.0).radius == 1.0f);
    CHECK(at(1.0).radius == 1.0f);
    CHECK(at(2.0).radius == Approx(1.5));
    CHECK(at(2.5).radius == Approx(1.75));
    CHECK(at(99.0).radius == Approx(2.0));
    // The parent has turned x to -x at 1 s; half way, to y.
    CHECK(is_near(at(0.0).center, Vec3(0, 7, 0)));
    CHECK(is_near(at(1.99).center, Vec3(0, 7, 0)));
    CHECK(is_near(at(2.0).center, Vec3(-10, 7, 0)));
    CHECK(is_near(at(3.99).center, Vec3(-10, 7, 0)));
    CHECK(is_near(at(4.0).center, Vec3(-20, 7, 0)));
    CHECK(is_near(at(0.5).shape, turn_about_z(90)));
}

TEST_CASE("a cubic spline is Hermite's", "[demo][gltf]") {
    GlbFile file;
    const int particle = file.root({{"name", "particle"}});
    // x: 2 s^2 from 0 to 2 s has the slopes 0 and 8; y: straight.
    file.animate(particle, "translation", "CUBICSPLINE", {0, 2},
                 {9, 9, 9, 0, 0, 0, 0, 1, 0, 8, 1, 0, 8, 2, 0, 9, 9, 9});
    const demo::ParticleFile particles = read(file);
    for (const double seconds : {0.0, 0.25, 0.5, 1.0, 1.75, 2.0}) {
        const Vec3 center = particles.at(seconds).at(0).center;
        CHECK(center.x == Approx(2.0 * seconds * seconds).margin(1e-6));
        CHECK(center.y == Approx(seconds).margin(1e-6));
        CHECK(center.z == 0.0f);
    }
    CHECK(particles.at(5.0).at(0).center == Vec3(8, 2, 0));
}

TEST_CASE("a cubic spline of rotations stays a rotation", "[demo][gltf]") {
    GlbFile file;
    const int particle           = file.root({{"name", "particle"}});
    const std::vector<float> end = about_z(90);
    file.animate(particle, "rotation", "CUBICSPLINE", {0, 1},
                 {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 3, 0, 0, 0, 3, 0, end[0], end[1], end[2], end[3], 0, 0, 0, 0});
    for (const double seconds : {0.0, 0.3, 0.5, 0.9, 1.0}) {
        const Particle at = only_particle(file, seconds);
        CHECK(at.radius == Approx(1.0).epsilon(1e-6));
        CHECK(is_near(at.shape * glm::transpose(at.shape), glm::mat3(1.0f)));
    }
    CHECK(is_near(only_particle(file, 1.0).shape, turn_about_z(90)));
}

TEST_CASE("rotations between keys are as near to the circle as is said", "[demo][gltf]") {
    struct Case {
        double apart, most;
    };
    const Case keys       = GENERATE(Case{15, 0.005}, Case{30, 0.035}, Case{90, 0.92});
    // The second key as -q: the same rotation, and not the long way round.
    const double sign     = GENERATE(1.0, -1.0);
    const auto quaternion = [](double degrees) {
        const double half = degrees * 3.14159265358979323846 / 360.0;
        return glm::dvec4(0.0, 0.0, std::sin(half), std::cos(half));
    };
    const demo::Curve curve{.interpolation = demo::Interpolation::Linear,
                            .is_rotation   = true,
                            .times         = {0.0, 1.0},
                            .values        = {quaternion(0.0), sign * quaternion(keys.apart)}};
    double worst = 0.0;
    for (int i = 0; i <= 100; ++i) {
        const glm::dvec4 at = curve.at(i / 100.0);
        CHECK(glm::length(at) == Approx(1.0).epsilon(1e-14));
        const double degrees = 2.0 * std::atan2(std::abs(at.z), std::abs(at.w)) * 180.0 / 3.14159265358979323846;
        worst                = std::max(worst, std::abs(degrees - keys.apart * i / 100.0));
    }
    CHECK(worst < keys.most);
    CHECK(worst > 0.8 * keys.most);
}

TEST_CASE("a particle without volume is left out while it has none", "[demo][gltf]") {
    GlbFile file;
    const int particle = file.root({{"name", "particle"}});
    file.root({{"name", "particle.001"}});
    file.animate(particle, "scale", "LINEAR", {0, 1, 2}, {0, 0, 0, 1, 1, 1, 1, 0, 1});
    const demo::ParticleFile particles = read(file);
    CHECK(particles.at(0.0).size() == 1);
    CHECK(particles.at(0.5).size() == 2);
    CHECK(particles.at(1.0).size() == 2);
    CHECK(particles.at(2.0).size() == 1);
    for (const Particle& at : particles.at(1.5)) CHECK(glm::determinant(at.shape) == Approx(1.0));
}

TEST_CASE("a particle may not leave the world, nor be one of too many", "[demo][gltf]") {
    GlbFile file;
    const int particle = file.root({{"name", "particle"}});
    file.animate(particle, "translation", "LINEAR", {0, 1}, {0, 0, 0, 1e6f, 0, 0});
    const demo::ParticleFile particles = read(file);
    CHECK(particles.at(0.05).size() == 1);
    CHECK_THROWS_WITH(particles.at(0.5), Catch::StartsWith("here: ") &&
                                             Catch::Contains("cloud.glb: node 'particle': reaches beyond 100000 m"));
    GlbFile many;
    for (int i = 0; i < demo::kMaxParticlesPerCloud; ++i) many.root({{"name", "particle"}});
    CHECK(read(many).at(0.0).size() == demo::kMaxParticlesPerCloud);
    many.root({{"name", "particle"}});
    CHECK_THROWS_WITH(read(many), Catch::Contains("has 2001 particles (at most 2000)"));
}

TEST_CASE("of several animations all play, and the first of a property counts", "[demo][gltf]") {
    GlbFile file;
    const int particle = file.root({{"name", "particle"}});
    file.animate(particle, "translation", "LINEAR", {0, 1}, {0, 0, 0, 1, 0, 0});
    const Json first = file.document["animations"][0];
    file.document.erase("animations");
    file.animate(particle, "translation", "LINEAR", {0, 1}, {0, 0, 0, 5, 0, 0});
    file.animate(particle, "scale", "LINEAR", {0, 2}, {1, 1, 1, 3, 3, 3});
    file.animate(particle, "weights", "LINEAR", {0, 9}, {1, 1, 1, 3, 3, 3});
    const Json second           = file.document["animations"][0];
    file.document["animations"] = Json::array({first, second});
    CHECK(only_particle(file, 1.0).center == Vec3(1, 0, 0));
    CHECK(only_particle(file, 1.0).radius == Approx(2.0));
    CHECK(read(file).duration() == 2.0);
}
