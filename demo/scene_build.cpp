// SPDX-License-Identifier: MIT
#include "demo/scene_build.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <functional>
#include <optional>
#include <stdexcept>
#include <utility>

#include "demo/cloud_motion.h"
#include "demo/gltf_mesh.h"
#include "demo/gltf_particles.h"
#include "demo/noise.h"
#include "demo/sky.h"
#include "demo/solids.h"
#include "demo/stars.h"
#include "demo/surface_texture.h"
#include "demo/terrain.h"
#include "demo/texture_pyramid.h"

namespace demo {
namespace {

// Share of sky light at a solid's vertex: less near the ground, and what its own shape leaves.
float sky_share(const SolidVertex& vertex, const HeightField* terrain) {
    if (terrain == nullptr) return vertex.open_sky;
    const float height = vertex.position.y - terrain->height_at(vertex.position.x, vertex.position.z);
    return vertex.open_sky * (0.6f + 0.4f * smooth_step(0.0f, 25.0f, height));
}

pipeline::Argb solid_color(Vec3 color, Vec3 position, Vec3 normal, float open_sky, const Surroundings& around,
                           const cloud::Daylight& light) {
    // Off the surface, so that the search for shadows does not start inside.
    const Vec3 start = position + 0.5f * normal;
    const float sun  = sun_past_solids(around, start, light.to_sun) * sun_past_clouds(around, start, light.to_sun);
    return to_argb(color * light_of_day(light, normal, sun * (0.5f + 0.5f * open_sky),
                                        sky_share({position, normal, {}, open_sky}, around.terrain)));
}

TexturedRange append_solid(SceneGeometry& geometry, const Solid& solid, const SolidMesh& mesh,
                           const Surroundings& around, const cloud::Daylight& light) {
    TextureLibrary textures(geometry);
    const int texture      = textures.find(solid.texture);
    const Vec2 tile_m      = TextureLibrary::tile_size(solid.texture, solid.tile_m);
    const auto first       = static_cast<std::uint32_t>(geometry.vertices.size());
    const auto first_index = static_cast<std::uint32_t>(geometry.indices.size());
    geometry.vertices.resize(first + mesh.vertices.size());
    tbb::parallel_for(std::size_t{0}, mesh.vertices.size(), [&](std::size_t i) {
        const SolidVertex& from      = mesh.vertices[i];
        geometry.vertices[first + i] = {
            .position = from.position,
            .normal   = from.normal,
            .diffuse  = solid_color(solid.color, from.position, from.normal, from.open_sky, around, light),
            .uv0      = from.uv_m / tile_m};
    });
    for (const std::uint32_t index : mesh.indices) geometry.indices.push_back(first + index);
    return {first_index, static_cast<std::uint32_t>(mesh.indices.size()), texture};
}

std::vector<TexturedRange> append_mesh(SceneGeometry& geometry, const SceneMesh& mesh, const Surroundings& around,
                                       const cloud::Daylight& light) {
    GltfMesh read           = read_gltf_mesh(mesh.file);
    const int first_texture = static_cast<int>(geometry.textures.size());
    for (pipeline::Texture& texture : read.textures) geometry.textures.push_back(std::move(texture));
    std::vector<TexturedRange> ranges;
    for (const GltfPart& part : read.parts) {
        const auto first       = static_cast<std::uint32_t>(geometry.vertices.size());
        const auto first_index = static_cast<std::uint32_t>(geometry.indices.size());
        for (const GltfVertex& from : part.vertices) {
            const Vec3 position = mesh.position + mesh.scale * from.position;
            geometry.vertices.push_back({.position = position,
                                         .normal   = from.normal,
                                         .diffuse = solid_color(from.color, position, from.normal, 1.0f, around, light),
                                         .uv0     = from.uv});
        }
        for (const std::uint32_t index : part.indices) geometry.indices.push_back(first + index);
        ranges.push_back({first_index, static_cast<std::uint32_t>(part.indices.size()),
                          part.texture < 0 ? -1 : first_texture + part.texture});
    }
    return ranges;
}

// All of a cloud but its light.
SceneCloud build_cloud(const CloudPlan& plan, double last_s) {
    SceneCloud cloud{.plan = plan, .grown = grow_cloud(plan), .file = {}, .baked = {}};
    if (plan.particle_file) cloud.file = std::make_shared<const ParticleFile>(*plan.particle_file);
    if (reshapes(plan)) cloud.grown.box = box_over_time(cloud, last_s);
    return cloud;
}

// All that stands still. The clouds cast their shadows.
SceneGeometry build_geometry(const SceneDescription& description, const std::vector<cloud::Cloud>& clouds) {
    std::optional<HeightField> field;
    if (description.terrain) field.emplace(terrain_heights(*description.terrain));

    Surroundings around{.terrain = field ? &*field : nullptr, .columns = {}, .clouds = {}};
    for (const cloud::Cloud& cloud : clouds) around.clouds.emplace_back(cloud);
    for (const Solid& solid : description.solids)
        for (const ShadowColumn& column : shadow_columns(solid)) around.columns.push_back(column);

    std::vector<SolidMesh> meshes(description.solids.size());
    tbb::parallel_for(std::size_t{0}, meshes.size(),
                      [&](std::size_t i) { meshes[i] = solid_mesh(description.solids[i]); });

    SceneGeometry geometry;
    geometry.sky   = append_sky_dome(geometry, description.sky, description.light.to_sun);
    geometry.stars = append_stars(geometry, description.sky, description.light.to_sun);
    if (field) append_terrain(geometry, *description.terrain, *field, around, description.light);
    for (std::size_t i = 0; i < description.solids.size(); ++i) {
        const Solid& solid  = description.solids[i];
        // A solid does not stand in its own shadow column: which side the sun reaches, its normals tell.
        Surroundings others = around;
        others.columns.clear();
        for (std::size_t j = 0; j < description.solids.size(); ++j)
            if (j != i)
                for (const ShadowColumn& column : shadow_columns(description.solids[j]))
                    others.columns.push_back(column);
        (solid.front ? geometry.solids_in_front : geometry.solids_behind)
            .push_back({append_solid(geometry, solid, meshes[i], others, description.light), solid.velocity});
    }
    for (const SceneMesh& mesh : description.meshes)
        for (const TexturedRange& range : append_mesh(geometry, mesh, around, description.light))
            (mesh.front ? geometry.solids_in_front : geometry.solids_behind).push_back({range});
    return geometry;
}

void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& work) {
    tbb::parallel_for(std::size_t{0}, count, work);
}

}  // namespace

cloud::BakedCloud bake_cloud(const SceneDescription& scene, const cloud::Cloud& cloud,
                             const cloud::BakedCloud* before) {
    try {
        return before ? cloud::bake(cloud, scene.light, *before, on_all_cores)
                      : cloud::bake(cloud, scene.light, on_all_cores);
    } catch (const std::invalid_argument& error) {
        throw SceneError(scene.name + ": " + error.what());
    }
}

Scene build_scene(SceneDescription description) {
    Scene scene;
    const double last_s = (description.frames - 1) / description.fps;
    std::vector<cloud::Cloud> clouds;  // as they are at first
    for (const CloudPlan& plan : description.clouds) {
        scene.clouds.push_back(build_cloud(plan, last_s));
        clouds.push_back(cloud_at(scene.clouds.back(), 0.0));
    }
    tbb::parallel_invoke(
        [&] {
            for (std::size_t i = 0; i < clouds.size(); ++i) scene.clouds[i].baked = bake_cloud(description, clouds[i]);
        },
        [&] { scene.geometry = build_geometry(description, clouds); });
    scene.description = std::move(description);
    return scene;
}

}  // namespace demo
