// SPDX-License-Identifier: MIT
#include "demo/scene_build.h"

#include <optional>
#include <utility>

#include "cloud/generate.h"
#include "demo/noise.h"
#include "demo/sky.h"
#include "demo/solids.h"
#include "demo/surface_texture.h"
#include "demo/terrain.h"
#include "demo/texture_pyramid.h"

namespace demo {
namespace {

cloud::Cloud grow_cloud(const CloudPlan& plan) {
    std::vector<cloud::Particle> cores;
    for (const CloudPlan::Core& core : plan.cores)
        cores.push_back({.center     = plan.position + plan.scale * core.center,
                         .radius     = plan.scale * core.radius,
                         .color      = plan.color,
                         .alpha      = 1.0f,
                         .generation = 0});
    cloud::Growth growth;
    growth.crown.count = plan.crown;
    growth.rim.count   = plan.rim;
    growth.jitter      = plan.jitter;
    growth.seed        = plan.seed;

    cloud::Cloud cloud = plan.settings;
    cloud.particles    = cloud::grow(cores, growth);
    cloud.base_y       = plan.position.y + plan.scale * cloud.base_y;
    cloud.blur_m *= plan.scale;
    return cloud;
}

// Share of sky light at a solid's vertex: less near the ground, and what its own shape leaves.
float sky_share(const SolidVertex& vertex, const HeightField* terrain) {
    if (terrain == nullptr) return vertex.open_sky;
    const float height = vertex.position.y - terrain->height_at(vertex.position.x, vertex.position.z);
    return vertex.open_sky * (0.6f + 0.4f * smooth_step(0.0f, 25.0f, height));
}

TexturedRange append_solid(SceneGeometry& geometry, const Solid& solid, const Surroundings& around,
                           const cloud::Daylight& light) {
    TextureLibrary textures(geometry);
    const int texture      = textures.find(solid.texture);
    const Vec2 tile_m      = TextureLibrary::tile_size(solid.texture, solid.tile_m);
    const SolidMesh mesh   = solid_mesh(solid);
    const auto first       = static_cast<std::uint32_t>(geometry.vertices.size());
    const auto first_index = static_cast<std::uint32_t>(geometry.indices.size());
    for (const SolidVertex& from : mesh.vertices) {
        // Off the surface, so that the search for shadows does not start inside.
        const Vec3 start = from.position + 0.5f * from.normal;
        const float sun  = sun_past_solids(around, start, light.to_sun) * sun_past_clouds(around, start, light.to_sun);
        pipeline::Vertex vertex;
        vertex.position = from.position;
        vertex.normal   = from.normal;
        vertex.diffuse  = to_argb(solid.color * light_of_day(light, from.normal, sun * (0.5f + 0.5f * from.open_sky),
                                                             sky_share(from, around.terrain)));
        vertex.uv0      = from.uv_m / tile_m;
        geometry.vertices.push_back(vertex);
    }
    for (const std::uint32_t index : mesh.indices) geometry.indices.push_back(first + index);
    return {first_index, static_cast<std::uint32_t>(mesh.indices.size()), texture};
}

}  // namespace

Scene build_scene(SceneDescription description) {
    Scene scene;
    std::vector<cloud::Cloud> clouds;
    for (const CloudPlan& plan : description.clouds) {
        clouds.push_back(grow_cloud(plan));
        scene.clouds.push_back(cloud::bake(clouds.back(), description.light));
    }

    std::optional<HeightField> field;
    if (description.terrain) field.emplace(terrain_heights(*description.terrain));

    Surroundings around{.terrain = field ? &*field : nullptr, .columns = {}, .clouds = {}};
    for (const cloud::Cloud& cloud : clouds) around.clouds.emplace_back(cloud);
    for (const Solid& solid : description.solids)
        for (const ShadowColumn& column : shadow_columns(solid)) around.columns.push_back(column);

    SceneGeometry& geometry = scene.geometry;
    geometry.sky            = append_sky_dome(geometry, description.sky, description.light.to_sun);
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
            .push_back(append_solid(geometry, solid, others, description.light));
    }
    scene.description = std::move(description);
    return scene;
}

}  // namespace demo
