// SPDX-License-Identifier: MIT
#include "demo/terrain.h"

#include <algorithm>
#include <cmath>

#include "demo/canyon.h"
#include "demo/image_file.h"
#include "demo/noise.h"
#include "demo/rock_texture.h"
#include "demo/surface_texture.h"
#include "demo/terrain_mesh.h"
#include "demo/texture_pyramid.h"

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

// What the mesh and its vertices need to know at every grid point.
struct Surface {
    std::vector<float> sun, sky, shade;
};

Surface light_surface(const HeightField& field, const Surroundings& around, const cloud::Daylight& light) {
    constexpr int kPoints = HeightField::kPoints;
    Surface surface;
    for (auto* values : {&surface.sun, &surface.sky, &surface.shade}) values->resize(kPoints * kPoints);
    for (int row = 0; row < kPoints; ++row) {
        for (int column = 0; column < kPoints; ++column) {
            const int i        = row * kPoints + column;
            const Vec3 point   = field.point(column, row) + Vec3(0.0f, 0.15f, 0.0f);
            const Vec3 normal  = field.normal(column, row);
            // A point turned away from the sun needs no search.
            const float facing = normal.x * light.to_sun.x + normal.y * light.to_sun.y + normal.z * light.to_sun.z;
            surface.sun[i]     = facing <= 0.0f ? 0.0f : sun_past_solids(around, point, light.to_sun);
            if (surface.sun[i] > 0.0f) surface.sun[i] *= sun_past_clouds(around, point, light.to_sun);
            surface.shade[i] = surface.sun[i] * std::max(facing, 0.0f);
        }
    }
    // The sky's share varies slowly: found at every second point, and half-way between at the others.
    for (int row = 0; row < kPoints; row += 2)
        for (int column = 0; column < kPoints; column += 2)
            surface.sky[row * kPoints + column] = open_sky(field, field.point(column, row));
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

// How much of a point's colour each layer gives. x, z: walls that face along that axis; z lies over x, x over the
// ground.
struct LayerAlpha {
    float x, z;
};
LayerAlpha layer_alpha(const Vec3& normal) {
    const float wall = 1.0f - smooth_step(0.66f, 0.80f, normal.y);
    const float x2 = normal.x * normal.x, z2 = normal.z * normal.z;
    const float share_z = x2 + z2 > 0.0f ? smooth_step(0.35f, 0.65f, z2 / (x2 + z2)) : 0.0f;
    const float z       = wall * share_z;
    return {z < 1.0f ? wall * (1.0f - share_z) / (1.0f - z) : 0.0f, z};
}

class TerrainLayers {
  public:
    TerrainLayers(SceneGeometry& geometry, const TerrainMesh& mesh, std::vector<pipeline::Vertex> base,
                  std::vector<LayerAlpha> alphas)
        : geometry_(geometry), mesh_(mesh), base_(std::move(base)), alphas_(std::move(alphas)) {}

    // alpha_of(LayerAlpha): the layer's own; needs(a, b, c): whether a triangle with these corners is drawn;
    // uv_of(position).
    template <class AlphaOf, class Needs, class UvOf>
    TexturedRange append(int texture, AlphaOf&& alpha_of, Needs&& needs, UvOf&& uv_of) {
        std::vector<std::int64_t> copied(base_.size(), -1);
        const auto first_index = static_cast<std::uint32_t>(geometry_.indices.size());
        for (const auto& triangle : mesh_.triangles) {
            if (!needs(alphas_[triangle[0]], alphas_[triangle[1]], alphas_[triangle[2]])) continue;
            for (const std::uint32_t corner : triangle) {
                if (copied[corner] < 0) {
                    pipeline::Vertex vertex   = base_[corner];
                    const std::uint32_t alpha = to_argb(Vec3(0.0f), alpha_of(alphas_[corner])).value & 0xff000000u;
                    vertex.diffuse.value      = (vertex.diffuse.value & 0x00ffffffu) | alpha;
                    vertex.uv0                = uv_of(vertex.position);
                    vertex.uv1 = Vec2(vertex.position.x + vertex.position.y, vertex.position.z - vertex.position.y) /
                                 kVariationTile;
                    copied[corner] = static_cast<std::int64_t>(geometry_.vertices.size());
                    geometry_.vertices.push_back(vertex);
                }
                geometry_.indices.push_back(static_cast<std::uint32_t>(copied[corner]));
            }
        }
        return {first_index, static_cast<std::uint32_t>(geometry_.indices.size()) - first_index, texture};
    }

  private:
    SceneGeometry& geometry_;
    const TerrainMesh& mesh_;
    std::vector<pipeline::Vertex> base_;
    std::vector<LayerAlpha> alphas_;
};

}  // namespace

HeightField terrain_heights(const Terrain& terrain) {
    const float half = 0.5f * terrain.size_m;
    if (!terrain.height_map) {
        const CanyonShape shape{terrain.size_m, terrain.height_m, terrain.seed};
        return HeightField(terrain.center, {half, half}, [&](float x, float z) {
            return terrain.base_y + canyon_height(shape, x - terrain.center.x, z - terrain.center.y);
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
    const Surface surface  = light_surface(field, around, light);
    const TerrainMesh mesh = triangulate(field, surface.shade, kHeightTolerance, kShadeTolerance);

    std::vector<pipeline::Vertex> base;
    std::vector<LayerAlpha> alphas;
    base.reserve(mesh.points.size());
    alphas.reserve(mesh.points.size());
    for (const std::uint32_t index : mesh.points) {
        const int column = static_cast<int>(index) % HeightField::kPoints,
                  row    = static_cast<int>(index) / HeightField::kPoints;
        pipeline::Vertex vertex;
        vertex.position = field.point(column, row);
        vertex.normal   = field.normal(column, row);
        vertex.diffuse  = to_argb(light_of_day(light, vertex.normal, surface.sun[index], surface.sky[index]));
        base.push_back(vertex);
        alphas.push_back(layer_alpha(vertex.normal));
    }

    TextureLibrary textures(geometry);
    const int ground = textures.find(terrain.ground), walls = textures.find(terrain.walls);
    geometry.variation   = textures.variation();
    const Vec2 ground_m  = textures.tile_size(terrain.ground, terrain.ground_tile_m);
    const Vec2 walls_m   = textures.tile_size(terrain.walls, terrain.walls_tile_m);
    const bool has_walls = terrain.walls.kind != SurfaceTexture::Kind::None;

    TerrainLayers layers(geometry, mesh, std::move(base), std::move(alphas));
    // Hidden by a wall layer that is opaque at all three corners.
    const auto shows_ground = [&](const LayerAlpha& a, const LayerAlpha& b, const LayerAlpha& c) {
        return !has_walls ||
               !((a.x >= 1.0f && b.x >= 1.0f && c.x >= 1.0f) || (a.z >= 1.0f && b.z >= 1.0f && c.z >= 1.0f));
    };
    geometry.ground = layers.append(
        ground, [](const LayerAlpha&) { return 1.0f; }, shows_ground,
        [&](const Vec3& p) { return Vec2(p.x, p.z) / ground_m; });
    if (!has_walls) return;
    // y runs up, v down.
    geometry.walls.push_back(layers.append(
        walls, [](const LayerAlpha& own) { return own.x; },
        [](const LayerAlpha& a, const LayerAlpha& b, const LayerAlpha& c) {
            const bool hidden = a.z >= 1.0f && b.z >= 1.0f && c.z >= 1.0f;
            return !hidden && (a.x > 0.0f || b.x > 0.0f || c.x > 0.0f);
        },
        [&](const Vec3& p) { return Vec2(p.z, -p.y) / walls_m; }));
    geometry.walls.push_back(layers.append(
        walls, [](const LayerAlpha& own) { return own.z; },
        [](const LayerAlpha& a, const LayerAlpha& b, const LayerAlpha& c) {
            return a.z > 0.0f || b.z > 0.0f || c.z > 0.0f;
        },
        [&](const Vec3& p) { return Vec2(p.x, -p.y) / walls_m; }));
}

}  // namespace demo
