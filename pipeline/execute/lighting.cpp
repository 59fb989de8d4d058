// SPDX-License-Identifier: MIT
#include "pipeline/execute/lighting.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/execute/curves.h"
#include "pipeline/execute/vector_math.h"

namespace pipeline {
namespace {

Vec4 unpack(Argb color) {
    const auto channel = [&](int shift) { return static_cast<float>((color.value >> shift) & 255u) / 255.0f; };
    return Vec4(channel(16), channel(8), channel(0), channel(24));
}

Vec4 pick(ColorSource source, const Vec4& material, const Vec4& color1, const Vec4& color2) {
    switch (source) {
        case ColorSource::Material:
            return material;
        case ColorSource::Color1:
            return color1;
        case ColorSource::Color2:
            return color2;
    }
    return material;
}

// At most the largest float: an attenuation of zero must not turn a black light into 0 * infinity.
float attenuation_at(const CameraLight& light, double distance) {
    if (distance > light.range) return 0.0f;
    const double factor =
        1.0 / (light.attenuation.x + light.attenuation.y * distance + light.attenuation.z * distance * distance);
    return static_cast<float>(std::min(factor, static_cast<double>(std::numeric_limits<float>::max())));
}

CameraLight to_camera(const Light& light, const glm::dmat4& view, bool specular_enable) {
    CameraLight result;
    result.is_point     = light.type == LightType::Point;
    result.has_specular = specular_enable && light.specular != Vec3(0.0f);
    result.to_light     = normalize3(Vec3(-(view * glm::dvec4(glm::dvec3(light.direction), 0.0))));
    result.position     = Vec3(view * glm::dvec4(glm::dvec3(light.position), 1.0));
    result.diffuse      = light.diffuse;
    result.specular     = light.specular;
    result.ambient      = light.ambient;
    result.range        = light.range;
    result.attenuation  = glm::dvec3(light.attenuation);
    return result;
}

// What the lights give before the material's colours take their part.
struct LightSums {
    Vec3 ambient, diffuse, specular;
};

void add_light(const CameraLight& light, const LightingState& state, const Vec3& position, const Vec3& normal,
               const Vec3& to_viewer, LightSums& sums) {
    Vec3 to_light     = light.to_light;
    float attenuation = 1.0f;
    if (light.is_point) {
        const Vec3 path       = light.position - position;
        const double distance = length3(path);
        to_light              = normalize3(path);
        attenuation           = attenuation_at(light, distance);
        if (attenuation == 0.0f) return;
    }
    sums.ambient += attenuation * light.ambient;

    const float facing = dot3(normal, to_light);
    if (!(facing > 0.0f)) return;
    sums.diffuse += (attenuation * facing) * light.diffuse;

    if (!light.has_specular) return;
    const float gleam = dot3(normal, normalize3(to_light + to_viewer));
    if (!(gleam > 0.0f)) return;
    const auto highlight = static_cast<float>(portable_pow(gleam, state.material.power));
    sums.specular += (attenuation * highlight) * light.specular;
}

Vec3 clamp01(const Vec3& color) {
    return Vec3(pipeline::clamp01(color.x), pipeline::clamp01(color.y), pipeline::clamp01(color.z));
}

}  // namespace

glm::mat3 normal_matrix(const glm::dmat4& object_to_camera) {
    const glm::dvec3 a(object_to_camera[0]), b(object_to_camera[1]), c(object_to_camera[2]);
    const auto cross = [](const glm::dvec3& p, const glm::dvec3& q) {
        return glm::dvec3(p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x);
    };
    // The columns of the inverse transpose of (a b c) are b x c, c x a, a x b over the determinant a . (b x c).
    const glm::dvec3 bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
    const double determinant = a.x * bc.x + a.y * bc.y + a.z * bc.z;
    if (determinant == 0.0 || !std::isfinite(determinant)) return glm::mat3(Vec3(a), Vec3(b), Vec3(c));
    return glm::mat3(Vec3(bc / determinant), Vec3(ca / determinant), Vec3(ab / determinant));
}

CameraLighting prepare_lighting(const LightingState& state, const Mat4& view, const Mat4& world) {
    CameraLighting lighting{.state = state, .normal_to_camera = glm::mat3(1.0f), .lights = {}};
    if (!state.enabled) return lighting;
    const glm::dmat4 to_camera_space(view);
    lighting.normal_to_camera = normal_matrix(to_camera_space * glm::dmat4(world));
    lighting.lights.reserve(state.lights.size());
    for (const Light& light : state.lights)
        lighting.lights.push_back(to_camera(light, to_camera_space, state.specular_enable));
    return lighting;
}

VertexColors light_vertex(const CameraLighting& lighting, const Vertex& vertex, const Vec3& camera_position) {
    const LightingState& state = lighting.state;
    const Vec4 color1 = unpack(vertex.diffuse), color2 = unpack(vertex.specular);
    if (!state.enabled) return {color1, Vec3(color2)};

    const glm::mat3& m = lighting.normal_to_camera;
    Vec3 normal        = m[0] * vertex.normal.x + m[1] * vertex.normal.y + m[2] * vertex.normal.z;
    if (state.normalize_normals) normal = normalize3(normal);
    const Vec3 to_viewer = state.local_viewer ? -normalize3(camera_position) : Vec3(0.0f, 0.0f, -1.0f);

    LightSums sums{.ambient = state.ambient, .diffuse = Vec3(0.0f), .specular = Vec3(0.0f)};
    for (const CameraLight& light : lighting.lights) add_light(light, state, camera_position, normal, to_viewer, sums);

    const Material& material = state.material;
    const auto color         = [&](ColorSource source, const Vec3& own) {
        return Vec3(pick(source, Vec4(own, 1.0f), color1, color2));
    };
    const Vec4 diffuse  = pick(state.diffuse_source, material.diffuse, color1, color2);
    const Vec3 ambient  = color(state.ambient_source, material.ambient);
    const Vec3 specular = color(state.specular_source, material.specular);
    const Vec3 emissive = color(state.emissive_source, material.emissive);
    const Vec3 total    = emissive + ambient * sums.ambient + Vec3(diffuse) * sums.diffuse;
    return {Vec4(clamp01(total), pipeline::clamp01(diffuse.a)), clamp01(specular * sums.specular)};
}

}  // namespace pipeline
