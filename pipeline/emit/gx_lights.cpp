// SPDX-License-Identifier: MIT
#include "pipeline/emit/gx_lights.h"

#include <algorithm>
#include <cmath>

#include "pipeline/execute/fog.h"
#include "pipeline/execute/vector_math.h"

namespace pipeline {

namespace {

// As the frame's vertex stage rounds: half up.
std::uint32_t to_byte(float channel) {
    return static_cast<std::uint32_t>(clamp01(channel) * 255.0 + 0.5);
}
Argb pack(float alpha, const Vec3& color) {
    return {to_byte(alpha) << 24 | to_byte(color.r) << 16 | to_byte(color.g) << 8 | to_byte(color.b)};
}
int byte_of(Argb color, int shift) {
    return static_cast<int>((color.value >> shift) & 0xffu);
}

Vec3 transformed(const GxMatrix& matrix, const Vec3& v, float w) {
    Vec3 out;
    for (int row = 0; row < 3; ++row) {
        const auto& r = matrix[static_cast<std::size_t>(row)];
        out[row]      = r[0] * v.x + r[1] * v.y + r[2] * v.z + r[3] * w;
    }
    return out;
}

const Camera& camera_of(const Frame& frame, const Pass& pass) {
    return frame.cameras[static_cast<std::size_t>(pass.camera.index)];
}

GxMatrix normal_matrix_of(const Camera& camera, const DrawTriangles& draw, float eye_z) {
    const glm::mat3 normal = normal_matrix(glm::dmat4(camera.view) * glm::dmat4(draw.world));
    GxMatrix out{};
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            out[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] =
                normal[column][row] * (row == 2 ? eye_z : 1.0f);
    return out;
}

float farthest(const Frame& frame, std::span<const std::uint32_t> indices, const GxMatrix& position) {
    double most = 1.0;
    for (const std::uint32_t index : indices)
        most = std::max(most, length3(transformed(position, frame.vertices[index].position, 1.0f)));
    return static_cast<float>(most);
}

// Colours brighter than one are written as dimmer ones that lose less on the way.
void set_color(GxLight& light, const Vec3& color, const Vec3& attenuation) {
    const float most  = std::max({color.r, color.g, color.b});
    const float scale = most > 1.0f ? most : 1.0f;
    light.color       = pack(1.0f, color / scale);
    light.k           = attenuation / scale;
}

GxLight chip_light(const Light& light, const Vec3& color, const Mat4& view, float eye_z, float distance) {
    const bool is_point = light.type == LightType::Point;
    const Vec3 in_world = is_point ? light.position : -normalize3(light.direction) * distance;
    GxLight out;
    out.position = Vec3(glm::dmat4(view) * glm::dvec4(glm::dvec3(in_world), is_point ? 1.0 : 0.0));
    out.position.z *= eye_z;
    set_color(out, color, is_point ? light.attenuation : Vec3(1.0f, 0.0f, 0.0f));
    return out;
}

// The form of the frame's lighting that channel 0 has, without regard to what it cuts.
std::optional<GxLighting> candidate(const Frame& frame, const Pass& pass, const DrawTriangles& draw,
                                    std::span<const std::uint32_t> indices, const GxTransform& transform) {
    const LightingState& state = pass.state.lighting;
    if (!state.enabled || transform.eye_z == 0.0f || state.specular_enable) return {};
    const bool of_vertex = state.diffuse_source == ColorSource::Color1;
    if (!of_vertex && state.diffuse_source != ColorSource::Material) return {};
    if (state.emissive_source != ColorSource::Material) return {};

    Vec3 ambient = state.ambient;
    for (const Light& light : state.lights) {
        if (light.type == LightType::Directional)
            ambient += light.ambient;
        else if (light.ambient != Vec3(0.0f))
            return {};
    }
    if (of_vertex && state.ambient_source == ColorSource::Material) {
        if (ambient * state.material.ambient + state.material.emissive != Vec3(0.0f)) return {};
        ambient = Vec3(0.0f);
    } else if (of_vertex) {
        if (state.ambient_source != ColorSource::Color1 || state.material.emissive != Vec3(0.0f)) return {};
    } else {
        if (state.ambient_source != ColorSource::Material) return {};
        ambient = state.material.emissive + state.material.ambient * ambient;
    }

    const Camera& camera = camera_of(frame, pass);
    GxLighting out;
    out.material_from_vertex = out.alpha_from_vertex = of_vertex;
    out.ambient                                      = pack(1.0f, ambient);
    out.material                                     = of_vertex ? Argb{} : pack(state.material.diffuse.a, Vec3(1.0f));
    out.normal                                       = normal_matrix_of(camera, draw, transform.eye_z);
    const float distance = kDirectionalDistance * farthest(frame, indices, transform.position);
    const Vec3 diffuse   = of_vertex ? Vec3(1.0f) : Vec3(state.material.diffuse);
    for (const Light& light : state.lights)
        out.lights.push_back(chip_light(light, light.diffuse * diffuse, camera.view, transform.eye_z, distance));
    return out;
}

bool are_near(Argb a, Argb b) {
    for (int shift = 0; shift < 32; shift += 8)
        if (std::abs(byte_of(a, shift) - byte_of(b, shift)) > kLightTolerance) return false;
    return true;
}

}  // namespace

std::optional<GxLighting> chip_lighting(const Frame& frame, const Pass& pass, const DrawTriangles& draw,
                                        std::span<const std::uint32_t> indices, const GxTransform& transform) {
    std::optional<GxLighting> lighting = candidate(frame, pass, draw, indices, transform);
    if (!lighting) return {};
    const VertexColorist colors(frame, pass, draw);
    for (const std::uint32_t index : indices) {
        const Vertex& vertex = frame.vertices[index];
        if (!are_near(chip_lit(*lighting, transform.position, vertex), colors(vertex).first)) return {};
    }
    return lighting;
}

Argb chip_lit(const GxLighting& lighting, const GxMatrix& position, const Vertex& vertex) {
    const Vec3 at     = transformed(position, vertex.position, 1.0f);
    const Vec3 normal = normalize3(transformed(lighting.normal, vertex.normal, 0.0f));
    Vec3 sum(static_cast<float>(byte_of(lighting.ambient, 16)), static_cast<float>(byte_of(lighting.ambient, 8)),
             static_cast<float>(byte_of(lighting.ambient, 0)));
    for (const GxLight& light : lighting.lights) {
        const Vec3 path    = light.position - at;
        const auto d       = static_cast<float>(length3(path));
        const float facing = std::max(0.0f, dot3(normal, normalize3(path)));
        const float share  = facing / (light.k.x + light.k.y * d + light.k.z * d * d);
        for (int channel = 0; channel < 3; ++channel)
            sum[channel] += share * static_cast<float>(byte_of(light.color, 16 - 8 * channel));
    }
    const Argb material = lighting.material_from_vertex ? vertex.diffuse : lighting.material;
    const Argb alpha    = lighting.alpha_from_vertex ? vertex.diffuse : lighting.material;
    std::uint32_t out   = alpha.value & 0xff000000u;
    for (int channel = 0; channel < 3; ++channel) {
        const int shift = 16 - 8 * channel;
        const int l     = static_cast<int>(255.0f * clamp01(sum[channel] / 255.0f));
        out |= static_cast<std::uint32_t>(byte_of(material, shift) * (l + (l >> 7)) >> 8) << shift;
    }
    return {out};
}

VertexColorist::VertexColorist(const Frame& frame, const Pass& pass, const DrawTriangles& draw)
    : state_(pass.state),
      lighting_(prepare_lighting(pass.state.lighting, camera_of(frame, pass).view, draw.world)),
      object_to_camera_(glm::dmat4(camera_of(frame, pass).view) * glm::dmat4(draw.world)) {}

VertexBytes VertexColorist::operator()(const Vertex& vertex) const {
    const Vec3 camera_position(object_to_camera_ * Vec4(vertex.position, 1.0f));
    const VertexColors colors = light_vertex(lighting_, vertex, camera_position);
    return {pack(colors.diffuse.a, Vec3(colors.diffuse)),
            pack(fog_factor(state_.fog, camera_position), colors.specular)};
}

}  // namespace pipeline
