// SPDX-License-Identifier: MIT
#include "demo/scene_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "demo/scene_file_cloud.h"
#include "demo/toml_reader.h"

namespace demo {
namespace {

constexpr std::uintmax_t kMaxFileBytes = 4u << 20;

void read_output(TableReader reader, SceneDescription& scene) {
    reader.read("size", scene.size, 1, kMaxOutputSize);
    reader.read("frames", scene.frames, 1, 1000000);
    reader.read("fps", scene.fps, {0.01, 1000.0});
    reader.finish("[output]");
}

void read_camera_path(TableReader& reader, CameraPath& camera) {
    const auto rows             = reader.read_rows("path", 7, kMaxKeys);
    // Slopes at times that are closer are more than a float can be.
    constexpr double kLeastStep = 0.001;
    double last_s               = -1.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto& row     = rows[i];
        const auto point_at = [&](std::size_t first) {
            return Vec3(static_cast<float>(row[first]), static_cast<float>(row[first + 1]),
                        static_cast<float>(row[first + 2]));
        };
        if (row[0] < 0.0 || row[0] < last_s + kLeastStep)
            reader.fail_at_row("path", i, "must have rising times, from 0 seconds on, at least 0.001 apart");
        last_s = row[0];
        camera.position_path.add(row[0], point_at(1));
        camera.target_path.add(row[0], point_at(4));
    }
    if (rows.empty()) return;
    camera.position = camera.position_path.smooth(0.0);
    camera.target   = camera.target_path.smooth(0.0);
}

void read_camera(TableReader reader, CameraPath& camera) {
    reader.read("position", camera.position, kCoordinate);
    reader.read("target", camera.target, kCoordinate);
    reader.read("vfov_deg", camera.vfov_deg, {1.0, 170.0});
    reader.read("near", camera.near_m, {0.001, 1e5});
    reader.read("far", camera.far_m, {0.001, 1e6});
    if (camera.far_m <= camera.near_m) reader.fail("far", "must be > camera.near");
    if (auto orbit = reader.table("orbit")) {
        orbit->read("degrees", camera.orbit_deg, {-360.0, 360.0});
        orbit->read("frames", camera.orbit_frames, 1, 1000000);
        orbit->finish("[camera.orbit]");
    }
    read_camera_path(reader, camera);
    reader.finish("[camera]");
    const Vec3 ahead       = camera.target - camera.position;
    const float level      = ahead.x * ahead.x + ahead.z * ahead.z;
    constexpr float kLeast = 1e-6f;  // of the squared distance
    if (!(level > kLeast * (level + ahead.y * ahead.y)))
        reader.fail("position", "must differ from camera.target, and not lie straight above or below it");
}

void read_light(TableReader reader, cloud::Daylight& light) {
    if (reader.read("to_sun", light.to_sun, kCoordinate)) {
        const Vec3 v       = light.to_sun;
        const float length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
        if (!(length > 1e-6f)) reader.fail("to_sun", "must not be zero");
        light.to_sun = v / length;
    }
    reader.read("sun", light.sun, kLight);
    reader.read("sky", light.sky, kLight);
    reader.read("bounce", light.bounce, kLight);
    reader.finish("[light]");
}

void read_sky(TableReader reader, Sky& sky) {
    reader.read("zenith", sky.zenith, kShare);
    reader.read("horizon", sky.horizon, kShare);
    reader.read("glow", sky.glow, kShare);
    reader.read("stars", sky.stars, 0, 100000);
    reader.finish("[sky]");
}

void read_fog(TableReader reader, Fog& fog) {
    reader.read("color", fog.color, kShare);
    reader.read("start", fog.start_m, {0.0, 1e6});
    reader.read("end", fog.end_m, {0.0, 1e6, true});
    if (fog.end_m <= fog.start_m) reader.fail("end", "must be > fog.start");
    reader.finish("[fog]");
}

// "none", "rock", "sand", or a file's name.
void read_texture(TableReader& reader, const char* key, SurfaceTexture& texture) {
    std::string word;
    if (!reader.read(key, word)) return;
    using Kind   = SurfaceTexture::Kind;
    texture.file = {};
    if (word == "none" || word == "rock" || word == "sand") {
        texture.kind = word == "none" ? Kind::None : word == "rock" ? Kind::Rock : Kind::Sand;
    } else {
        texture.kind = Kind::File;
        reader.read(key, texture.file);
    }
}

Terrain read_terrain(TableReader reader) {
    Terrain terrain;
    FileReference height_map;
    const bool from_file = reader.read("height_map", height_map);
    const bool generated = reader.read_choice("generate", {"canyon"}).has_value();
    if (from_file == generated) reader.fail("height_map", "or terrain.generate must be there, and not both");
    if (from_file) {
        terrain.height_map = height_map;
    } else {
        reader.read("seed", terrain.seed);
    }
    reader.read("center", terrain.center, kCoordinate);
    reader.read("size", terrain.size_m, {1.0, 1e5});
    reader.read("height", terrain.height_m, {0.0, 1e4});
    reader.read("base", terrain.base_y, kCoordinate);
    read_texture(reader, "walls", terrain.walls);
    read_texture(reader, "ground", terrain.ground);
    reader.read("walls_tile", terrain.walls_tile_m, {0.01, 1e5});
    reader.read("ground_tile", terrain.ground_tile_m, {0.01, 1e5});
    reader.finish(from_file ? "a [terrain] with a height map" : "[terrain]");
    return terrain;
}

Solid read_solid(TableReader reader) {
    Solid solid;
    const auto kind = reader.read_choice("kind", {"box", "cylinder", "spire"});
    if (!kind) reader.fail("kind", "is missing: box, cylinder or spire");
    using Kind = Solid::Kind;
    solid.kind = *kind == 0 ? Kind::Box : *kind == 1 ? Kind::Cylinder : Kind::Spire;
    if (solid.kind == Kind::Spire) solid.texture.kind = SurfaceTexture::Kind::Rock;

    for (const char* end : {"from", "to"})
        if (!reader.read(end, end[0] == 'f' ? solid.from : solid.to, kCoordinate))
            reader.fail(end, "is missing: [x, y, z]");
    constexpr float kLeastSpan = 0.001f;  // normals and noise divide by it
    const Vec3 span            = glm::abs(solid.to - solid.from);
    if (solid.kind == Kind::Cylinder) {
        if (std::max({span.x, span.y, span.z}) < kLeastSpan)
            reader.fail("to", "must lie 0.001 or more from solid.from in x, y or z");
        if (!reader.read("radius", solid.radius, kLength)) reader.fail("radius", "is missing");
        solid.top_radius = solid.radius;
        reader.read("top_radius", solid.top_radius, {0.0, 1e5});
    } else if (std::min({span.x, span.y, span.z}) < kLeastSpan) {
        reader.fail("to", "must lie 0.001 or more from solid.from in x, y and z");
    }
    if (solid.kind == Kind::Spire) reader.read("seed", solid.seed);
    reader.read("front", solid.front);
    reader.read("velocity", solid.velocity, kCoordinate);
    read_texture(reader, "texture", solid.texture);
    reader.read("tile", solid.tile_m, {0.01, 1e5});
    reader.read("color", solid.color, kShare);
    reader.finish(solid.kind == Kind::Box ? "a box" : solid.kind == Kind::Cylinder ? "a cylinder" : "a spire");
    return solid;
}

void read_weather(TableReader reader, double& last_s, WeatherPath& weather) {
    const double at = read_time(reader, last_s);
    const auto read = [&](const char* key, Track<Vec3>& track, Range range) {
        Vec3 value;
        if (reader.read(key, value, range)) track.add(at, value);
    };
    read("to_sun", weather.to_sun, kCoordinate);
    read("sun", weather.sun, kLight);
    read("sky", weather.sky, kLight);
    read("bounce", weather.bounce, kLight);
    read("zenith", weather.zenith, kShare);
    read("horizon", weather.horizon, kShare);
    read("glow", weather.glow, kShare);
    reader.finish("[[weather]]");
}

SceneMesh read_mesh(TableReader reader) {
    SceneMesh mesh;
    if (!reader.read("file", mesh.file)) reader.fail("file", "is missing: a .glb or .gltf file");
    reader.read("position", mesh.position, kCoordinate);
    reader.read("scale", mesh.scale, {0.001, 1000.0});
    reader.read("front", mesh.front);
    reader.finish("[[mesh]]");
    return mesh;
}

}  // namespace

SceneDescription parse_scene(std::string_view text, const std::string& file, const std::string& name) {
    toml::table root;
    try {
        root = toml::parse(text, file);
    } catch (const toml::parse_error& error) {
        const auto& begin = error.source().begin;
        throw SceneError(file + ":" + std::to_string(begin.line) + ":" + std::to_string(begin.column) + ": " +
                         std::string(error.description()));
    }
    SceneDescription scene;
    scene.name = name;
    TableReader reader(root, file, "");
    reader.read("summary", scene.summary);
    if (auto table = reader.table("output")) read_output(*table, scene);
    if (auto table = reader.table("camera")) read_camera(*table, scene.camera);
    if (auto table = reader.table("light")) read_light(*table, scene.light);
    if (auto table = reader.table("sky")) read_sky(*table, scene.sky);
    if (auto table = reader.table("fog")) read_fog(*table, scene.fog);
    if (auto table = reader.table("terrain")) scene.terrain = read_terrain(*table);
    for (TableReader& table : reader.tables("solid", kMaxSolids)) scene.solids.push_back(read_solid(std::move(table)));
    double weather_s = -1.0;
    for (TableReader& table : reader.tables("weather", kMaxKeys))
        read_weather(std::move(table), weather_s, scene.weather);
    for (TableReader& table : reader.tables("mesh", kMaxMeshes)) scene.meshes.push_back(read_mesh(std::move(table)));
    for (TableReader& table : reader.tables("cloud", kMaxClouds)) scene.clouds.push_back(read_cloud(std::move(table)));
    reader.finish("a scene file");
    return scene;
}

SceneDescription read_scene_file(const std::string& path) {
    namespace fs = std::filesystem;
    std::error_code error;
    if (!fs::exists(path, error)) throw SceneError(path + ": no such file");
    if (!fs::is_regular_file(path, error)) throw SceneError(path + ": is not a file");
    if (fs::file_size(path, error) > kMaxFileBytes)
        throw SceneError(path + ": is larger than a scene file may be (4 MiB)");
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) throw SceneError(path + ": cannot be read");
    return parse_scene(text.view(), path, fs::path(path).stem().string());
}

}  // namespace demo
