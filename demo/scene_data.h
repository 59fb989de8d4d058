// SPDX-License-Identifier: MIT
// A scene: as its file describes it, and as it is kept ready for frames. Lengths in metres, y up, colours factors 0..1
// unless said otherwise. The defaults are those of an absent key in the file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cloud/bake.h"
#include "demo/cloud_plan.h"
#include "demo/file_reference.h"
#include "demo/scene.h"
#include "demo/terrain_blocks.h"
#include "demo/track.h"

namespace demo {

class ParticleFile;  // gltf_particles.h

inline constexpr int kMaxOutputSize        = 8192;
inline constexpr int kMaxClouds            = 64;
inline constexpr int kMaxParticlesPerCloud = 2000;
inline constexpr int kMaxSolids            = 256;
inline constexpr int kMaxMeshes            = 64;
inline constexpr int kMaxKeys              = 1000;

// A picture that covers a surface: none, one of ours, or a file's.
struct SurfaceTexture {
    enum class Kind : std::uint8_t { None, Rock, Sand, File } kind = Kind::None;
    FileReference file;
};

// Looks from position at target; swings about target's vertical by +-orbit_deg in orbit_frames frames, from the middle.
// With a path both move as it says.
struct CameraPath {
    Vec3 position    = Vec3(0.0f, 20.0f, 120.0f);
    Vec3 target      = Vec3(0.0f, 20.0f, 0.0f);
    double vfov_deg  = 45.0;
    double near_m    = 0.5;
    double far_m     = 2000.0;
    double orbit_deg = 0.0;
    int orbit_frames = 1;
    Track<Vec3> position_path, target_path;
};

struct Sky {
    Vec3 zenith  = Vec3(0.13f, 0.32f, 0.66f);
    Vec3 horizon = Vec3(0.80f, 0.845f, 0.89f);
    Vec3 glow    = Vec3(0.22f, 0.17f, 0.10f);  // added around the sun
    int stars    = 0;
};

// Haze that hides all at end_m. color: the sky's horizon, if absent.
struct Fog {
    std::optional<Vec3> color;
    float start_m = 150.0f, end_m = 1900.0f;
};

struct Terrain {
    std::optional<FileReference> height_map;  // absent: generated
    std::uint32_t seed    = 1;
    Vec2 center           = Vec2(0.0f);  // x, z
    float size_m          = 3200.0f;     // along x; a height map's aspect gives the other side
    float height_m        = 165.0f;      // of white above black, or of the canyon's rim above its floor
    float base_y          = 0.0f;
    SurfaceTexture walls  = {.kind = SurfaceTexture::Kind::Rock, .file = {}};
    SurfaceTexture ground = {.kind = SurfaceTexture::Kind::Sand, .file = {}};
    std::optional<float> walls_tile_m, ground_tile_m;
};

// Box, spire: from and to are opposite corners; a spire is a tower of rock within its box. Cylinder: from and to are
// the ends of the axis. front: drawn after the clouds.
struct Solid {
    enum class Kind : std::uint8_t { Box, Cylinder, Spire } kind = Kind::Box;
    Vec3 from = Vec3(0.0f), to = Vec3(1.0f);
    float radius = 1.0f, top_radius = 1.0f;  // cylinder
    bool front             = false;
    Vec3 velocity          = Vec3(0.0f);  // metres a second; its light stays as it was
    SurfaceTexture texture = {};
    std::optional<float> tile_m;
    Vec3 color         = Vec3(1.0f);
    std::uint32_t seed = 1;  // spire
};

// Geometry from a glTF file, placed and lit like a solid.
struct SceneMesh {
    FileReference file;
    Vec3 position = Vec3(0.0f);
    float scale   = 1.0f;
    bool front    = false;
};

// Light and sky over time; what is empty stays as it is.
struct WeatherPath {
    Track<Vec3> to_sun, sun, sky, bounce;  // Daylight
    Track<Vec3> zenith, horizon, glow;     // Sky
    bool empty() const {
        return to_sun.empty() && sun.empty() && sky.empty() && bounce.empty() && zenith.empty() && horizon.empty() &&
               glow.empty();
    }
};

struct SceneDescription {
    std::string name, summary;
    Size size  = {1280, 720};
    int frames = 1;  // of the whole animation
    double fps = 30.0;
    CameraPath camera;
    cloud::Daylight light;
    Sky sky;
    Fog fog;
    std::optional<Terrain> terrain;
    WeatherPath weather;
    std::vector<Solid> solids;
    std::vector<SceneMesh> meshes;
    std::vector<CloudPlan> clouds;
};

// Triangles of SceneGeometry that share a texture (an index into textures, -1: none).
struct TexturedRange {
    std::uint32_t first_index = 0, index_count = 0;
    int texture = -1;
};

struct MovingRange {
    TexturedRange range;
    Vec3 velocity = Vec3(0.0f);
};

// All but the clouds, lit: vertex colours hold the light.
struct SceneGeometry {
    std::vector<pipeline::Texture> textures;
    std::vector<pipeline::Vertex> vertices;
    std::vector<std::uint32_t> indices;
    TexturedRange sky, stars;  // unit domes around the eye
    TerrainBlocks terrain;
    std::vector<MovingRange> solids_behind, solids_in_front;
};

// grown: as the plan says, before anything moves; particles that stream or come from a file are not in it. baked: at the start of the animation.
struct SceneCloud {
    CloudPlan plan;
    cloud::Cloud grown;
    std::shared_ptr<const ParticleFile> file;
    cloud::BakedCloud baked;
};

struct Scene {
    SceneDescription description;
    std::vector<SceneCloud> clouds;
    SceneGeometry geometry;
};

}  // namespace demo
