// SPDX-License-Identifier: MIT
#include <cfloat>
#include <cmath>

#include "pipeline/truth/vertices.h"

namespace pipeline::truth {
namespace {

using glm::dvec3;

dvec3 normalized(const dvec3& v) {
    const double length = glm::length(v);
    return length == 0.0 ? v : v / length;
}

struct Sums {
    dvec3 ambient{0.0}, diffuse{0.0}, specular{0.0};
};

void add_light(const VertexSetup& setup, const Light& light, const dvec3& camera, const dvec3& normal, Sums& sums) {
    const LightingState& state = setup.state.lighting;
    dvec3 to_light             = normalized(-dvec3(setup.view * glm::dvec4(dvec3(light.direction), 0.0)));
    double attenuation         = 1.0;
    if (light.type == LightType::Point) {
        const dvec3 path = dvec3(setup.view * glm::dvec4(dvec3(light.position), 1.0)) - camera;
        const double d   = glm::length(path);
        if (d > light.range) return;
        to_light            = normalized(path);
        const dvec3 factors = light.attenuation;
        // The largest float, as in `execute`, keeps a black light from infinity.
        attenuation         = std::min(1.0 / (factors.x + factors.y * d + factors.z * d * d), double{FLT_MAX});
        if (attenuation == 0.0) return;
    }
    sums.ambient += attenuation * dvec3(light.ambient);
    const double facing = glm::dot(normal, to_light);
    if (!(facing > 0.0)) return;
    sums.diffuse += attenuation * facing * dvec3(light.diffuse);

    if (!state.specular_enable) return;
    const dvec3 to_viewer = state.local_viewer ? -normalized(camera) : dvec3(0.0, 0.0, -1.0);
    const double gleam    = glm::dot(normal, normalized(to_light + to_viewer));
    if (gleam > 0.0)
        sums.specular += attenuation * std::pow(gleam, double{state.material.power}) * dvec3(light.specular);
}

Color pick(ColorSource source, const Color& material, const Vertex& vertex) {
    return source == ColorSource::Material ? material
                                           : to_color(source == ColorSource::Color1 ? vertex.diffuse : vertex.specular);
}

}  // namespace

void light(const VertexSetup& setup, const Vertex& vertex, const dvec3& camera, ClipVertex& out) {
    const LightingState& state = setup.state.lighting;
    out.diffuse                = to_color(vertex.diffuse);
    out.specular               = to_color(vertex.specular);
    if (!state.enabled) return;

    dvec3 normal = setup.normal_to_camera * dvec3(vertex.normal);
    if (state.normalize_normals) normal = normalized(normal);
    Sums sums{.ambient = state.ambient};
    for (const Light& each : state.lights) add_light(setup, each, camera, normal, sums);

    const Material& material = state.material;
    const auto rgb           = [&](ColorSource source, const Vec3& own) {
        return dvec3(pick(source, Color(dvec3(own), 1.0), vertex));
    };
    const Color diffuse = pick(state.diffuse_source, material.diffuse, vertex);
    const dvec3 total   = rgb(state.emissive_source, material.emissive) +
                        rgb(state.ambient_source, material.ambient) * sums.ambient + dvec3(diffuse) * sums.diffuse;
    out.diffuse  = clamp01(Color(total, diffuse.a));
    out.specular = clamp01(Color(rgb(state.specular_source, material.specular) * sums.specular, 1.0));
}

double fog_factor(const FogState& fog, const dvec3& camera) {
    const double distance = fog.range ? glm::length(camera) : std::abs(camera.z);
    const double depth    = fog.density * distance;
    switch (fog.mode) {
        case FogMode::None:
            return 1.0;
        case FogMode::Linear:
            if (fog.start == fog.end) return 0.0;
            return clamp01((fog.end - distance) / (double{fog.end} - fog.start));
        case FogMode::Exp:
            return clamp01(std::exp(-depth));
        case FogMode::Exp2:
            return clamp01(std::exp(-depth * depth));
    }
    return 1.0;
}

}  // namespace pipeline::truth
