// SPDX-License-Identifier: MIT
#include "demo/terrain.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "demo/bake_light.h"
#include "demo/camera_matrices.h"
#include "demo/canyon.h"
#include "demo/desert_floor.h"
#include "demo/noise.h"
#include "demo/rock_texture.h"
#include "demo/scene_build.h"
#include "demo/scene_file.h"
#include "demo/solids.h"
#include "demo/terrain_mesh.h"
#include "demo/texture_pyramid.h"
#include "demo/trigonometry.h"
#include "pipeline/validate/validate.h"

namespace demo {
namespace {

HeightField canyon_field(std::uint32_t seed = 1) {
    Terrain terrain;
    terrain.seed = seed;
    return terrain_heights(terrain);
}

std::vector<float> flat_shade() {
    return std::vector<float>(HeightField::kPoints * HeightField::kPoints, 0.5f);
}

// How often each edge is walked from its first to its second corner.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed_edges(const TriangleMesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& triangle : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) ++edges[{triangle[i], triangle[(i + 1) % 3]}];
    return edges;
}

bool same_geometry(const SceneGeometry& a, const SceneGeometry& b) {
    if (a.terrain.blocks.size() != b.terrain.blocks.size()) return false;
    for (std::size_t i = 0; i < a.terrain.blocks.size(); ++i) {
        const TerrainBlock &block = a.terrain.blocks[i], &other = b.terrain.blocks[i];
        if (block.ground != other.ground || block.walls != other.walls || block.overlays != other.overlays)
            return false;
    }
    return a.vertices == b.vertices && a.indices == b.indices && a.textures == b.textures;
}

const char* const kSmallScene = R"(
[terrain]
generate = "canyon"
[[solid]]
kind = "spire"
from = [8, -4, -40]
to = [26, 90, 6]
[[solid]]
kind = "box"
from = [40, 0, 0]
to = [60, 30, 20]
front = true
)";

}  // namespace

TEST_CASE("sine, cosine and tangent are right to the last digits", "[demo][terrain]") {
    for (int i = -4000; i <= 4000; ++i) {
        const double x = 0.0171 * i;
        CHECK(std::abs(sine(x) - std::sin(x)) < 1e-14);
        CHECK(std::abs(cosine(x) - std::cos(x)) < 1e-14);
    }
    CHECK(sine(0.0) == 0.0);
    CHECK(cosine(0.0) == 1.0);
    CHECK(tangent(radians(22.5)) == Approx(std::tan(radians(22.5))).epsilon(1e-14));
}

TEST_CASE("noise stays within bounds, has mean 0, and repeats with its period", "[demo][terrain]") {
    double sum = 0.0;
    for (int i = 0; i < 200; ++i) {
        for (int j = 0; j < 200; ++j) {
            const float x = 0.173f * static_cast<float>(i) - 11.0f, y = 0.291f * static_cast<float>(j) - 17.0f;
            const float value = noise(x, y, 5);
            sum += value;
            REQUIRE(std::abs(value) <= 1.2f);
            REQUIRE(ridged_noise(x, y, 2, 5) <= 1.0f);
        }
    }
    CHECK(std::abs(sum / 40000.0) < 0.03);
    CHECK(noise(0.25f, 3.5f, 7, {4, 6}) == noise(4.25f, 9.5f, 7, {4, 6}));
    CHECK(noise(0.25f, 3.5f, 7, {4, 6}) == noise(-3.75f, -2.5f, 7, {4, 6}));
    CHECK(noise(0.25f, 3.5f, 7) != noise(0.25f, 3.5f, 8));
}

TEST_CASE("the canyon is finite, within its heights, the same each time, and another for another seed",
          "[demo][terrain]") {
    const HeightField first = canyon_field(), again = canyon_field(), other = canyon_field(2);
    int differing = 0;
    for (int row = 0; row < HeightField::kPoints; ++row) {
        for (int column = 0; column < HeightField::kPoints; ++column) {
            REQUIRE(std::isfinite(first.height(column, row)));
            REQUIRE(first.height(column, row) == again.height(column, row));
            differing += first.height(column, row) != other.height(column, row);
        }
    }
    CHECK(first.min_height() > -12.0f);
    CHECK(first.max_height() > 140.0f);
    CHECK(first.max_height() < 190.0f);
    CHECK(differing > HeightField::kPoints * HeightField::kPoints / 2);
}

TEST_CASE("the floor between the camera's path and the cloud lies low", "[demo][terrain]") {
    for (float x = -160.0f; x <= 160.0f; x += 5.0f)
        for (float z = 20.0f; z <= 190.0f; z += 5.0f) REQUIRE(canyon_height({}, x, z) < 40.0f);
}

TEST_CASE("a height field gives back its points, and its border beyond them", "[demo][terrain]") {
    const HeightField field({10.0f, -20.0f}, {300.0f, 150.0f}, [](float x, float z) { return 0.5f * x - 0.25f * z; });
    CHECK(field.x_at(0) == 10.0f - 300.0f);
    CHECK(field.x_at(HeightField::kCells) == 10.0f + 300.0f);
    CHECK(field.z_at(HeightField::kCells) == -20.0f + 150.0f);
    for (int i = 1; i < HeightField::kPoints; ++i) REQUIRE(field.x_at(i) > field.x_at(i - 1));
    for (const int i : {0, 1, 100, 255, 256, 257, 400, 511, 512})
        CHECK(field.height_at(field.x_at(i), field.z_at(i)) == Approx(field.height(i, i)).margin(0.02));
    CHECK(field.height_at(47.0f, -31.0f) == Approx(0.5f * 47.0f + 0.25f * 31.0f).margin(0.05));
    CHECK(field.height_at(1e6f, -20.0f) == Approx(0.5f * 310.0f + 5.0f).margin(0.05));
    const Vec3 normal = field.normal(200, 300);
    CHECK(glm::length(normal) == Approx(1.0f));
    CHECK(normal.x / normal.y == Approx(-0.5f).margin(0.001));
}

TEST_CASE("the terrain mesh has no cracks and faces up", "[demo][terrain]") {
    const HeightField field = canyon_field();
    const TriangleMesh mesh = triangulate(field, flat_shade(), 1.2f, 0.2f);
    CHECK(mesh.triangles.size() > 5000);
    CHECK(mesh.triangles.size() < 60000);

    const auto on_border = [&](std::uint32_t vertex) {
        const int column = static_cast<int>(mesh.points[vertex]) % HeightField::kPoints;
        const int row    = static_cast<int>(mesh.points[vertex]) / HeightField::kPoints;
        return std::array<bool, 4>{column == 0, column == HeightField::kCells, row == 0, row == HeightField::kCells};
    };
    const auto edges = directed_edges(mesh);
    for (const auto& [edge, times] : edges) {
        REQUIRE(times == 1);
        if (edges.count({edge.second, edge.first}) == 1) continue;
        // Walked one way only: then both ends lie on the same side of the rectangle.
        const auto a = on_border(edge.first), b = on_border(edge.second);
        REQUIRE(((a[0] && b[0]) || (a[1] && b[1]) || (a[2] && b[2]) || (a[3] && b[3])));
    }
    double area = 0.0;
    for (const auto& triangle : mesh.triangles) {
        Vec2 corner[3];
        for (std::size_t i = 0; i < 3; ++i)
            corner[i] = {field.x_at(static_cast<int>(mesh.points[triangle[i]]) % HeightField::kPoints),
                         field.z_at(static_cast<int>(mesh.points[triangle[i]]) / HeightField::kPoints)};
        const Vec2 u = corner[1] - corner[0], v = corner[2] - corner[0];
        const double up = 0.5 * (static_cast<double>(u.y) * v.x - static_cast<double>(u.x) * v.y);
        REQUIRE(up > 0.0);
        area += up;
    }
    CHECK(area == Approx(3200.0 * 3200.0).epsilon(1e-5));
}

TEST_CASE("a smaller tolerance makes a finer mesh, and a plane needs few triangles", "[demo][terrain]") {
    const HeightField canyon = canyon_field();
    const HeightField plane({0.0f, 0.0f}, {100.0f, 100.0f}, [](float, float) { return 3.0f; });
    const std::size_t coarse = triangulate(canyon, flat_shade(), 4.0f, 1.0f).triangles.size();
    const std::size_t fine   = triangulate(canyon, flat_shade(), 0.5f, 1.0f).triangles.size();
    CHECK(fine > 2 * coarse);
    CHECK(triangulate(plane, flat_shade(), 0.5f, 0.1f).triangles.size() == 2u * 32u * 32u);
}

TEST_CASE("solids and clouds cast shadows along the sun's rays only", "[demo][terrain]") {
    const HeightField plane({0.0f, 0.0f}, {500.0f, 500.0f}, [](float, float) { return 0.0f; });
    const Vec3 to_sun = glm::normalize(Vec3(1.0f, 1.0f, 0.0f));
    cloud::Cloud cloud;
    cloud.particles = {
        {.center = {0.0f, 60.0f, 100.0f}, .radius = 15.0f, .color = Vec3(1.0f), .alpha = 1.0f, .generation = 0}};
    const Surroundings around{&plane, {{{0.0f, 0.0f, 0.0f}, 40.0f, 5.0f, 5.0f}}, {ShadowCloud(cloud)}};
    CHECK(sun_past_solids(around, {-20.0f, 0.1f, 0.0f}, to_sun) == 0.0f);
    CHECK(sun_past_solids(around, {20.0f, 0.1f, 0.0f}, to_sun) == 1.0f);
    CHECK(sun_past_solids(around, {-60.0f, 0.1f, 0.0f}, to_sun) == 1.0f);
    CHECK(sun_past_solids(around, {-20.0f, 0.1f, 9.0f}, to_sun) == 1.0f);
    CHECK(sun_past_clouds(around, {-60.0f, 0.1f, 100.0f}, to_sun) < 0.8f);
    CHECK(sun_past_clouds(around, {60.0f, 0.1f, 100.0f}, to_sun) == 1.0f);

    const HeightField wall({0.0f, 0.0f}, {500.0f, 500.0f}, [](float x, float) { return x > 0.0f ? 50.0f : 0.0f; });
    const Surroundings behind_wall{&wall, {}, {}};
    CHECK(sun_past_solids(behind_wall, {-20.0f, 0.1f, 0.0f}, to_sun) == 0.0f);
    CHECK(sun_past_solids(behind_wall, {-90.0f, 0.1f, 0.0f}, to_sun) == 1.0f);
    CHECK(open_sky(plane, {0.0f, 0.0f, 0.0f}) == 1.0f);
    CHECK(open_sky(wall, {-5.0f, 0.0f, 0.0f}) < 0.75f);
}

TEST_CASE("solids are closed, face outwards, and keep within their box", "[demo][terrain]") {
    for (const Solid::Kind kind : {Solid::Kind::Box, Solid::Kind::Spire, Solid::Kind::Cylinder}) {
        Solid solid;
        solid.kind   = kind;
        solid.from   = {-4.0f, 1.0f, -3.0f};
        solid.to     = kind == Solid::Kind::Cylinder ? Vec3(4.0f, 11.0f, 3.0f) : Vec3(5.0f, 30.0f, 6.0f);
        solid.radius = solid.top_radius = 0.5f;
        const SolidMesh mesh            = solid_mesh(solid);
        REQUIRE(mesh.indices.size() % 3 == 0);
        // By the divergence theorem, six times the volume; negative if the faces look inwards.
        double volume = 0.0;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const auto& a = mesh.vertices[mesh.indices[i]];
            const auto& b = mesh.vertices[mesh.indices[i + 1]];
            const auto& c = mesh.vertices[mesh.indices[i + 2]];
            volume += glm::dot(glm::dvec3(a.position - solid.from),
                               glm::cross(glm::dvec3(b.position - solid.from), glm::dvec3(c.position - solid.from))) /
                      6.0;
        }
        if (kind == Solid::Kind::Box) CHECK(volume == Approx(9.0 * 29.0 * 9.0).epsilon(1e-4));
        if (kind == Solid::Kind::Cylinder) CHECK(volume == Approx(3.14159 * 0.25 * std::sqrt(200.0)).epsilon(0.03));
        if (kind == Solid::Kind::Spire) CHECK(volume > 0.3 * 9.0 * 29.0 * 9.0);
        for (const SolidVertex& vertex : mesh.vertices) {
            REQUIRE(glm::length(vertex.normal) == Approx(1.0f).margin(1e-4));
            if (kind == Solid::Kind::Cylinder) continue;
            for (int axis = 0; axis < 3; ++axis) {
                REQUIRE(vertex.position[axis] >= solid.from[axis] - 1e-4f);
                REQUIRE(vertex.position[axis] <= solid.to[axis] + 1e-4f);
            }
        }
    }
}

TEST_CASE("mip levels are means, and odd sizes become powers of two", "[demo][terrain]") {
    const pipeline::Texture four = texture_pyramid("t", 2, 2, {0xff000000, 0xff0000ff, 0xff00ff00, 0xffff0001});
    CHECK(four.levels == 2);
    CHECK(four.texels ==
          std::vector<std::uint8_t>{0, 0, 0, 255, 255, 0, 0, 255, 0, 255, 0, 255, 1, 0, 255, 255, 64, 64, 64, 255});
    const pipeline::Texture odd = texture_pyramid("t", 3, 100, std::vector<std::uint32_t>(300, 0xff123456));
    CHECK(odd.width == 4);
    CHECK(odd.height == 128);
    CHECK(odd.levels == 8);
    for (std::size_t i = 0; i < odd.texels.size(); i += 4)
        REQUIRE((odd.texels[i] == 0x56 && odd.texels[i + 2] == 0x12));
    CHECK(texture_pyramid("t", 1, 1, {0xff102030}).levels == 1);
}

TEST_CASE("textures of the desert tile: their opposite borders fit", "[demo][terrain]") {
    for (const pipeline::Texture& texture : {sand_texture(3), rock_texture(3), desert_floor_texture(3)}) {
        const auto green = [&](int x, int y) {
            return static_cast<int>(texture.texels[static_cast<std::size_t>(4 * (y * texture.width + x) + 1)]);
        };
        // The step across the seam is no larger than between neighbours elsewhere.
        long seam = 0, inside = 0;
        for (int y = 0; y < texture.height; ++y) {
            seam += std::abs(green(0, y) - green(texture.width - 1, y));
            inside += std::abs(green(100, y) - green(101, y));
        }
        CHECK(seam < 2 * inside + texture.height);
    }
}

TEST_CASE("rock shows whole where its share is whole, and the desert floor keeps the sand's brightness",
          "[demo][terrain]") {
    const pipeline::Texture rock = rock_texture(3), desert = desert_floor_texture(3);
    int bare = 0;
    for (std::size_t i = 3; i < rock.texels.size(); i += 4) {
        REQUIRE(4 * rock.texels[i] >= 255);
        bare += rock.texels[i] > 128;
    }
    CHECK(bare > 0);
    const auto last = desert.texels.end() - 4;  // the mean of all
    for (int channel = 0; channel < 3; ++channel) {
        CHECK(last[channel] > 110);
        CHECK(last[channel] < 136);
    }
}

TEST_CASE("a wash is where the canyon's floor is cut", "[demo][terrain]") {
    double inside = 0.0, outside = 0.0;
    int beds = 0, others = 0;
    for (float x = -160.0f; x <= 160.0f; x += 4.0f)
        for (float z = 20.0f; z <= 190.0f; z += 4.0f) {
            const float wash = canyon_wash({}, x, z);
            REQUIRE((wash >= 0.0f && wash <= 1.0f));
            if (wash == 1.0f) inside += canyon_height({}, x, z), ++beds;
            if (wash == 0.0f) outside += canyon_height({}, x, z), ++others;
        }
    REQUIRE(beds > 20);
    REQUIRE(others > 20);
    CHECK(inside / beds < outside / others - 2.0);
}

TEST_CASE("camera matrices map the view to Direct3D's clip space", "[demo][terrain]") {
    const Mat4 view        = look_at({0.0f, 58.0f, 170.0f}, {0.0f, 60.0f, 0.0f});
    const glm::vec4 target = view * glm::vec4(0.0f, 60.0f, 0.0f, 1.0f);
    CHECK(target.x == Approx(0.0f).margin(1e-4));
    CHECK(target.y == Approx(0.0f).margin(1e-4));
    CHECK(target.z == Approx(-std::sqrt(170.0f * 170.0f + 4.0f)));
    CHECK((view * glm::vec4(5.0f, 60.0f, 0.0f, 1.0f)).x == Approx(5.0f));
    const Mat4 projection       = perspective(90.0, 2.0, 0.5, 2000.0);
    const glm::vec4 near_corner = projection * glm::vec4(1.0f, 0.5f, -0.5f, 1.0f);
    CHECK(near_corner.z == Approx(0.0f).margin(1e-6));
    CHECK(near_corner.x / near_corner.w == Approx(1.0f));
    CHECK(near_corner.y / near_corner.w == Approx(1.0f));
    const glm::vec4 far_center = projection * glm::vec4(0.0f, 0.0f, -2000.0f, 1.0f);
    CHECK(far_center.z == Approx(far_center.w));
    CHECK(far_center.w == Approx(2000.0f));

    CameraPath path;
    path.orbit_deg    = 60.0;
    path.orbit_frames = 4;
    CHECK(eye_at(path, 0, 0.0) == path.position);
    CHECK(eye_at(path, 1, 0.0).x == Approx(120.0 * std::sin(radians(60.0))));
    CHECK(eye_at(path, 3, 0.0).x == Approx(-120.0 * std::sin(radians(60.0))));
    CHECK(eye_at(path, 5, 0.0) == eye_at(path, 1, 0.0));
}

TEST_CASE("a scene is built the same each time, finite, in range, and its frames are valid", "[demo][terrain]") {
    const Scene scene = build_scene(parse_scene(kSmallScene, "x.toml", "x"));
    const Scene again = build_scene(parse_scene(kSmallScene, "x.toml", "x"));
    CHECK(same_geometry(scene.geometry, again.geometry));
    for (const pipeline::Vertex& vertex : scene.geometry.vertices) {
        for (int axis = 0; axis < 3; ++axis) REQUIRE(std::isfinite(vertex.position[axis]));
        REQUIRE(std::abs(vertex.position.x) <= 1600.0f);
        REQUIRE(std::abs(vertex.position.z) <= 1600.0f);
        REQUIRE(std::isfinite(vertex.uv0.x + vertex.uv0.y + vertex.uv1.x + vertex.uv1.y));
    }
    for (const std::uint32_t index : scene.geometry.indices) REQUIRE(index < scene.geometry.vertices.size());
    for (const int index : {0, 40}) {
        const pipeline::Frame frame = scene_frame(scene, {320, 180}, index);
        CHECK(pipeline::validate(frame).empty());
        std::vector<std::string> labels;
        for (const pipeline::Pass& pass : frame.passes) labels.push_back(pass.label);
        CHECK(labels ==
              std::vector<std::string>{"walls", "ground", "walls over ground", "solids", "sky", "objects in front"});
    }
}

}  // namespace demo
