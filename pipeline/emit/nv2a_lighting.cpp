// SPDX-License-Identifier: MIT
#include "pipeline/emit/nv2a_lighting.h"

#include <algorithm>

#include "pipeline/execute/lighting.h"

namespace pipeline {
namespace {

std::uint32_t to_byte(float channel) {
    const float clamped = channel > 0.0f ? std::min(channel, 1.0f) : 0.0f;
    return static_cast<std::uint32_t>(clamped * 255.0 + 0.5);
}

std::uint32_t pack_argb(float alpha, const Vec3& color) {
    return to_byte(alpha) << 24 | to_byte(color.r) << 16 | to_byte(color.g) << 8 | to_byte(color.b);
}

void set_color(Nv2aStream& out, const Nv2aMethod& method, std::size_t entry, const Vec3& color,
               std::string_view meaning) {
    const float values[] = {color.r, color.g, color.b};
    out.set_floats(method, entry, values, meaning);
}

void set_light(Nv2aStream& out, std::size_t i, const CameraLight& light, const LightingState& state) {
    const bool from_vertex = state.diffuse_source != ColorSource::Material;
    set_color(out, nv097::SET_LIGHT_AMBIENT_COLOR, i, state.material.ambient * light.ambient, "times the material's");
    set_color(out, nv097::SET_LIGHT_DIFFUSE_COLOR, i,
              from_vertex ? light.diffuse : Vec3(state.material.diffuse) * light.diffuse,
              from_vertex ? "" : "times the material's");
    set_color(out, nv097::SET_LIGHT_SPECULAR_COLOR, i, Vec3(0.0f), "no highlights");
    if (light.is_point) {
        const float range[]       = {static_cast<float>(light.range)};
        const float attenuation[] = {static_cast<float>(light.attenuation.x), static_cast<float>(light.attenuation.y),
                                     static_cast<float>(light.attenuation.z)};
        out.set_floats(nv097::SET_LIGHT_LOCAL_RANGE, i, range, "");
        set_color(out, nv097::SET_LIGHT_LOCAL_POSITION, i, light.position, "in camera space");
        out.set_floats(nv097::SET_LIGHT_LOCAL_ATTENUATION, i, attenuation, "");
    } else {
        constexpr float kFar[] = {1e30f};
        out.set_floats(nv097::SET_LIGHT_LOCAL_RANGE, i, kFar, "no limit");
        set_color(out, nv097::SET_LIGHT_INFINITE_DIRECTION, i, light.to_light, "toward the light, in camera space");
    }
}

// Two bits for each light.
std::uint32_t enable_mask(const std::vector<CameraLight>& lights) {
    std::uint32_t mask = 0;
    for (std::size_t i = 0; i < lights.size(); ++i)
        mask |= (lights[i].is_point ? nv097::LIGHT_LOCAL : nv097::LIGHT_INFINITE) << (2 * i);
    return mask;
}

Nv2aValue diffuse_source(ColorSource source) {
    switch (source) {
        case ColorSource::Material:
            break;
        case ColorSource::Color1:
            return {1, "diffuse from the vertex's diffuse"};
        case ColorSource::Color2:
            return {2, "diffuse from the vertex's specular"};
    }
    return {0, "all from the material"};
}

}  // namespace

bool lights_on_chip(const LightingState& lighting) {
    const auto has_highlight = [](const Light& light) { return light.specular != Vec3(0.0f); };
    return lighting.enabled && lighting.ambient_source == ColorSource::Material &&
           lighting.emissive_source == ColorSource::Material &&
           !(lighting.specular_enable && std::any_of(lighting.lights.begin(), lighting.lights.end(), has_highlight));
}

void set_lights(Nv2aStream& out, const Nv2aDraw& draw) {
    const LightingState& state = draw.state().lighting;
    const bool on_chip         = draw.triangles() != nullptr && lights_on_chip(state);
    out.set_flag(nv097::SET_LIGHTING_ENABLE, on_chip);
    const bool has_second = reads_second_color(draw.state()) && !on_chip && draw.rectangle() == nullptr;
    out.set(nv097::SET_SPECULAR_ENABLE, {has_second ? 1u : 0u},
            has_second ? "V1 is the vertex's second colour" : "V1 is black");
    out.set(nv097::SET_LIGHT_CONTROL, {pack(nv097::LIGHT_CONTROL_SEPARATE_SPECULAR, 1)}, "SEPARATE_SPECULAR");
    if (!on_chip) return;

    const Camera& camera          = draw.frame.cameras[static_cast<std::size_t>(draw.pass.camera.index)];
    const CameraLighting lighting = prepare_lighting(state, camera.view, draw.triangles()->world);
    const float eye[] = {0.0f, 0.0f, 0.0f, 1.0f}, alpha[] = {state.material.diffuse.a};
    const Nv2aValue source = diffuse_source(state.diffuse_source);
    out.set(nv097::SET_COLOR_MATERIAL, {pack(nv097::COLOR_MATERIAL_DIFFUSE, source.value)}, source.name);
    out.set_flag(nv097::SET_NORMALIZATION_ENABLE, state.normalize_normals);
    out.set_floats(nv097::SET_EYE_POSITION, 0, eye, "in camera space");
    set_color(out, nv097::SET_SCENE_AMBIENT_COLOR, 0, state.material.emissive + state.material.ambient * state.ambient,
              "emissive + material's ambient * ambient light");
    set_color(out, nv097::SET_MATERIAL_EMISSION, 0, Vec3(0.0f), "none from vertices");
    out.set_floats(nv097::SET_MATERIAL_ALPHA, 0, alpha, "");
    out.set(nv097::SET_LIGHT_ENABLE_MASK, {enable_mask(lighting.lights)},
            std::to_string(lighting.lights.size()) + " lights; 1 infinite, 2 local");
    for (std::size_t i = 0; i < lighting.lights.size(); ++i) set_light(out, i, lighting.lights[i], state);
    for (std::size_t row = 0; row < 3; ++row) {
        const glm::mat3& m   = lighting.normal_to_camera;
        const auto r         = static_cast<glm::length_t>(row);
        const float values[] = {m[0][r], m[1][r], m[2][r], 0.0f};
        out.set_floats(nv097::SET_INVERSE_MODEL_VIEW_MATRIX, row, values, "of normals, row " + std::to_string(row));
    }
}

std::vector<std::uint8_t> lit_colors(const Nv2aDraw& draw, std::uint32_t first, std::uint32_t count) {
    const Camera& camera          = draw.frame.cameras[static_cast<std::size_t>(draw.pass.camera.index)];
    const Mat4& world             = draw.triangles()->world;
    const CameraLighting lighting = prepare_lighting(draw.state().lighting, camera.view, world);
    const Mat4 to_camera(glm::dmat4(camera.view) * glm::dmat4(world));
    std::vector<std::uint8_t> bytes;
    bytes.reserve(std::size_t{8} * count);
    for (std::uint32_t i = first; i < first + count; ++i) {
        const Vertex& vertex      = draw.frame.vertices[i];
        const VertexColors colors = light_vertex(lighting, vertex, Vec3(to_camera * Vec4(vertex.position, 1.0f)));
        append_word(bytes, pack_argb(colors.diffuse.a, Vec3(colors.diffuse)));
        append_word(bytes, pack_argb(1.0f, colors.specular));
    }
    return bytes;
}

}  // namespace pipeline
