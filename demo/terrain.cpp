// SPDX-License-Identifier: MIT
#include "demo/terrain.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <span>

#include "demo/canyon.h"
#include "demo/image_file.h"
#include "demo/noise.h"
#include "demo/surface_texture.h"
#include "demo/terrain_layers.h"
#include "demo/terrain_mesh.h"

namespace demo {
namespace {

constexpr float kHeightTolerance = 1.2f, kShadeTolerance = 0.2f;

// Bilinear, at 0..1 across the map's outermost pixel centres.
float map_height(const HeightMap& map, float u, float v) {
    const float x = std::clamp(u, 0.0f, 1.0f) * static_cast<float>(map.width - 1);
    const float y = std::clamp(v, 0.0f, 1.0f) * static_cast<float>(map.height - 1);
    const int x0  = std::min(static_cast<int>(x), std::max(map.width - 2, 0));
    const int y0  = std::min(static_cast<int>(y), std::max(map.height - 2, 0));
    const int x1 = std::min(x0 + 1, map.width - 1), y1 = std::min(y0 + 1, map.height - 1);
    const auto at = [&](int column, int row) {
        return map.heights[static_cast<std::size_t>(row) * map.width + column];
    };
    const float tx = x - static_cast<float>(x0), ty = y - static_cast<float>(y0);
    return mix(mix(at(x0, y0), at(x1, y0), tx), mix(at(x0, y1), at(x1, y1), tx), ty);
}

HeightMap checked_height_map(const FileReference& file) {
    HeightMap map;
    try {
        map = read_height_map(file.path);
    } catch (const std::runtime_error& error) {
        throw SceneError(file.named_at + ": " + error.what());
    }
    for (const float height : map.heights)
        if (!(std::abs(height) <= 1e6f))
            throw SceneError(file.named_at + ": " + file.path + ": holds heights that are not finite");
    return map;
}

CanyonShape canyon_shape(const Terrain& terrain) {
    return {terrain.size_m, terrain.height_m, terrain.seed};
}

// What the mesh and its vertices need to know at every grid point.
struct Surface {
    std::vector<float> sun, sky, shade;
};

Surface light_surface(const HeightField& field, const Surroundings& around, const cloud::Daylight& light) {
    constexpr int kPoints = HeightField::kPoints;
    Surface surface;
    for (auto* values : {&surface.sun, &surface.sky, &surface.shade}) values->resize(kPoints * kPoints);
    const GridLight grid(field, light.to_sun);
    tbb::parallel_for(0, kPoints, [&](int row) {
        const GridLight::Row grid_row(grid, row);
        std::array<Vec3, kPoints> points;
        std::array<float, kPoints> facings;
        const std::span sun = std::span(surface.sun).subspan(static_cast<std::size_t>(row) * kPoints, kPoints);
        for (int column = 0; column < kPoints; ++column) {
            const int i        = row * kPoints + column;
            const Vec3 point   = field.point(column, row) + Vec3(0.0f, 0.15f, 0.0f);
            const Vec3 normal  = field.normal(column, row);
            // A point turned away from the sun needs no search.
            const float facing = normal.x * light.to_sun.x + normal.y * light.to_sun.y + normal.z * light.to_sun.z;
            if (facing > 0.0f) {
                const float share = grid_row.sun_past_terrain(column, point.y);
                sun[column]       = sun_past_columns(around, point, light.to_sun, share);
            }
            points[column] = point, facings[column] = facing;
            // The sky's share varies slowly: found at every second point, and half-way between at the others.
            if (row % 2 == 0 && column % 2 == 0) surface.sky[i] = grid_row.open_sky(column, field.height(column, row));
        }
        shade_by_clouds(around, points, light.to_sun, sun);
        for (int column = 0; column < kPoints; ++column)
            surface.shade[row * kPoints + column] = sun[column] * std::max(facings[column], 0.0f);
    });
    for (int row = 0; row < kPoints; row += 2)
        for (int column = 1; column < kPoints; column += 2) {
            const int i    = row * kPoints + column;
            surface.sky[i] = 0.5f * (surface.sky[i - 1] + surface.sky[i + 1]);
        }
    for (int row = 1; row < kPoints; row += 2)
        for (int column = 0; column < kPoints; ++column) {
            const int i    = row * kPoints + column;
            surface.sky[i] = 0.5f * (surface.sky[i - kPoints] + surface.sky[i + kPoints]);
        }
    return surface;
}

// Rock where it is steep.
float rock_share(const Vec3& normal) {
    return 1.0f - smooth_step(0.54f, 0.64f, normal.y);
}

// Over some metres, so that a wall with all its flutes counts as facing one way.
bool faces_z(const HeightField& field, const Vec3& p) {
    constexpr float kReach = 14.0f;
    const float slope_x    = field.height_at(p.x + kReach, p.z) - field.height_at(p.x - kReach, p.z);
    const float slope_z    = field.height_at(p.x, p.z + kReach) - field.height_at(p.x, p.z - kReach);
    return std::abs(slope_z) > std::abs(slope_x);
}

// Slow changes of colour, too large for a texture that tiles.
class Tints {
  public:
    explicit Tints(const Terrain& terrain) : terrain_(terrain), seed_(terrain.seed * 211u) {}

    Vec3 ground(const Vec3& p, const Vec3& normal) const {
        const float tone = fractal_noise(p.x / 150.0f, p.z / 150.0f, 3, seed_);
        Vec3 tint        = Vec3(1.0f + 0.09f * tone, 1.0f + 0.12f * tone, 1.0f + 0.15f * tone);
        // Debris of the walls on slopes, clean sand in washes.
        tint *= glm::mix(Vec3(1.0f), Vec3(0.90f, 0.80f, 0.76f), 1.0f - smooth_step(0.78f, 0.94f, normal.y));
        if (!terrain_.height_map) {
            const float low = 1.0f - smooth_step(1.0f, 8.0f, p.y - terrain_.base_y);
            if (low > 0.0f) {
                const float wash =
                    canyon_wash(canyon_shape(terrain_), p.x - terrain_.center.x, p.z - terrain_.center.y);
                tint *= glm::mix(Vec3(1.0f), Vec3(1.10f, 1.15f, 1.19f), low * wash);
            }
        }
        return tint;
    }

    Vec3 rock(const Vec3& p) const {
        const float tone = fractal_noise(p.x / 80.0f + p.y / 190.0f, p.z / 80.0f - p.y / 190.0f, 3, seed_ + 10u);
        return {1.0f + 0.14f * tone, 1.0f + 0.17f * tone, 1.0f + 0.19f * tone};
    }

  private:
    const Terrain& terrain_;
    std::uint32_t seed_;
};

struct LitMesh {
    TriangleMesh mesh;
    std::vector<TerrainPoint> points;  // those of the mesh
};

LitMesh lit_mesh(const Terrain& terrain, const HeightField& field, const Surroundings& around,
                 const cloud::Daylight& light) {
    const Surface surface = light_surface(field, around, light);
    LitMesh lit{.mesh = triangulate(field, surface.shade, kHeightTolerance, kShadeTolerance), .points = {}};
    const bool has_rock = terrain.walls.kind != SurfaceTexture::Kind::None;
    const Tints tints(terrain);
    lit.points.resize(lit.mesh.points.size());
    tbb::parallel_for(std::size_t{0}, lit.points.size(), [&](std::size_t i) {
        const std::uint32_t index = lit.mesh.points[i];
        const int column          = static_cast<int>(index) % HeightField::kPoints;
        const int row             = static_cast<int>(index) / HeightField::kPoints;
        const Vec3 p = field.point(column, row), normal = field.normal(column, row);
        const Vec3 arrives = light_of_day(light, normal, surface.sun[index], surface.sky[index]);
        lit.points[i]      = {.column       = column,
                              .row          = row,
                              .position     = p,
                              .normal       = normal,
                              .ground_light = arrives * tints.ground(p, normal),
                              .rock_light   = arrives * tints.rock(p),
                              .rock         = has_rock ? rock_share(normal) : 0.0f,
                              .faces_z      = faces_z(field, p)};
    });
    return lit;
}

}  // namespace

HeightField terrain_heights(const Terrain& terrain) {
    const float half = 0.5f * terrain.size_m;
    if (!terrain.height_map) {
        const CanyonShape shape = canyon_shape(terrain);
        return HeightField(terrain.center, {half, half}, [&](std::span<const float> x) -> HeightField::RowOf {
            std::vector<float> from_middle(x.begin(), x.end());
            for (float& column : from_middle) column -= terrain.center.x;
            return [&, canyon = CanyonHeights(shape, from_middle)](float z, std::span<float> heights) {
                canyon.row(z - terrain.center.y, heights);
                for (float& height : heights) height = terrain.base_y + height;
            };
        });
    }
    const HeightMap map = checked_height_map(*terrain.height_map);
    const Vec2 half_size(half, half * static_cast<float>(map.height) / static_cast<float>(map.width));
    const Vec2 corner = terrain.center - half_size;
    return HeightField(terrain.center, half_size, [&](float x, float z) {
        const float u = (x - corner.x) / (2.0f * half_size.x), v = (z - corner.y) / (2.0f * half_size.y);
        return terrain.base_y + terrain.height_m * map_height(map, u, v);
    });
}

void append_terrain(SceneGeometry& geometry, const Terrain& terrain, const HeightField& field,
                    const Surroundings& around, const cloud::Daylight& light) {
    TextureLibrary textures(geometry);
    int ground = -1, detail = -1, rock = -1;
    LitMesh lit;
    tbb::parallel_invoke(
        [&] {
            ground = textures.find(terrain.ground);
            detail = textures.detail(terrain.ground);
            rock   = textures.find(terrain.walls);
        },
        [&] { lit = lit_mesh(terrain, field, around, light); });

    const TerrainTiles tiles{.ground_m = textures.tile_size(terrain.ground, terrain.ground_tile_m),
                             .detail_m = textures.detail_size(terrain.ground),
                             .rock_m   = textures.tile_size(terrain.walls, terrain.walls_tile_m)};
    geometry.terrain                = append_terrain_blocks(geometry.vertices, field, lit.mesh, lit.points, tiles);
    geometry.terrain.ground_texture = ground;
    geometry.terrain.detail_texture = detail;
    geometry.terrain.rock_texture   = rock;
}

}  // namespace demo
