// SPDX-License-Identifier: MIT
// Transform and lighting state of Direct3D 7. Colours are linear factors, not limited to [0, 1]: a light with negative
// colour takes light away. All positions and directions of lights are in world space. The equation, with its source,
// stands in pipeline/execute/lighting.h.
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/frame/fields.h"
#include "pipeline/frame/math_types.h"

namespace pipeline {

enum class LightType : std::uint8_t { Directional, Point };
template <>
struct EnumNames<LightType> {
    static constexpr std::array<std::string_view, 2> names{"DIRECTIONAL", "POINT"};
};

// direction: the way the light travels (Directional). range and attenuation a0 + a1 d + a2 d^2: Point.
struct Light {
    LightType type                      = LightType::Directional;
    Vec3 diffuse                        = Vec3(1.0f);
    Vec3 specular                       = Vec3(0.0f);
    Vec3 ambient                        = Vec3(0.0f);
    Vec3 position                       = Vec3(0.0f);
    Vec3 direction                      = Vec3(0.0f, 0.0f, 1.0f);
    float range                         = 1e9f;
    Vec3 attenuation                    = Vec3(1.0f, 0.0f, 0.0f);
    bool operator==(const Light&) const = default;
};
template <SameStruct<Light> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [type, diffuse, specular, ambient, position, direction, range, attenuation] = state;
    visit("type", type);
    visit("diffuse", diffuse);
    visit("specular", specular);
    visit("ambient", ambient);
    visit("position", position);
    visit("direction", direction);
    visit("range", range);
    visit("attenuation", attenuation);
}

struct Material {
    Vec4 diffuse                           = Vec4(1.0f);
    Vec3 ambient                           = Vec3(1.0f);
    Vec3 specular                          = Vec3(0.0f);
    Vec3 emissive                          = Vec3(0.0f);
    float power                            = 0.0f;
    bool operator==(const Material&) const = default;
};
template <SameStruct<Material> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [diffuse, ambient, specular, emissive, power] = state;
    visit("diffuse", diffuse);
    visit("ambient", ambient);
    visit("specular", specular);
    visit("emissive", emissive);
    visit("power", power);
}

// Where a material colour is taken from: the material, the vertex's first colour (diffuse) or its second (specular).
enum class ColorSource : std::uint8_t { Material, Color1, Color2 };
template <>
struct EnumNames<ColorSource> {
    static constexpr std::array<std::string_view, 3> names{"MATERIAL", "COLOR1", "COLOR2"};
};

// enabled = false passes the vertex's own colours through. specular_enable adds the second colour after the stages.
struct LightingState {
    bool enabled                = false;
    bool specular_enable        = false;
    bool local_viewer           = true;
    bool normalize_normals      = false;
    Vec3 ambient                = Vec3(0.0f);
    ColorSource diffuse_source  = ColorSource::Color1;
    ColorSource ambient_source  = ColorSource::Material;
    ColorSource specular_source = ColorSource::Color2;
    ColorSource emissive_source = ColorSource::Material;
    Material material;
    std::vector<Light> lights;
    bool operator==(const LightingState&) const = default;
};
template <SameStruct<LightingState> State, class Visit>
void visit_fields(State& state, Visit&& visit) {
    auto& [enabled, specular_enable, local_viewer, normalize_normals, ambient, diffuse_source, ambient_source,
           specular_source, emissive_source, material, lights] = state;
    visit("enabled", enabled);
    visit("specular_enable", specular_enable);
    visit("local_viewer", local_viewer);
    visit("normalize_normals", normalize_normals);
    visit("ambient", ambient);
    visit("diffuse_source", diffuse_source);
    visit("ambient_source", ambient_source);
    visit("specular_source", specular_source);
    visit("emissive_source", emissive_source);
    visit("material", material);
    visit("lights", lights);
}

inline constexpr int kMaxLights = 8;

}  // namespace pipeline
