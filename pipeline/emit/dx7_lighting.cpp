// SPDX-License-Identifier: MIT
#include "pipeline/emit/dx7_lighting.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "pipeline/emit/dx7_states.h"
#include "pipeline/emit/dx7_text.h"

namespace pipeline::dx7 {

namespace {

constexpr float kRangeMax = 0x1.fffffep63f;  // D3DLIGHT_RANGE_MAX, the root of FLT_MAX

std::string color(const Vec3& value, float alpha) {
    return "color(" + list_of({value.r, value.g, value.b, alpha}) + ')';
}
std::string vector(const Vec3& value) {
    return "vector(" + list_of({value.x, value.y, value.z}) + ')';
}

std::optional<std::uint32_t> exact_byte(float channel) {
    if (!(channel >= 0.0f && channel <= 1.0f)) return std::nullopt;
    const float byte = std::nearbyint(channel * 255.0f);
    if (byte / 255.0f != channel) return std::nullopt;
    return static_cast<std::uint32_t>(byte);
}

std::uint32_t nearest_byte(float channel) {
    return static_cast<std::uint32_t>(std::nearbyint(std::clamp(channel, 0.0f, 1.0f) * 255.0f));
}

std::optional<Argb> exact_color(const Vec3& value) {
    const auto red = exact_byte(value.r), green = exact_byte(value.g), blue = exact_byte(value.b);
    if (!red || !green || !blue) return std::nullopt;
    return Argb{*red << 16 | *green << 8 | *blue};
}

class Calls {
  public:
    void add(std::string line) { lines_.push_back(std::move(line)); }

    void material(const Material& material) {
        add("D3DMATERIAL7 material = {};");
        add("material.dcvDiffuse = " + color(Vec3(material.diffuse), material.diffuse.a) + ';');
        add("material.dcvAmbient = " + color(material.ambient, 1.0f) + ';');
        add("material.dcvSpecular = " + color(material.specular, 1.0f) + ';');
        add("material.dcvEmissive = " + color(material.emissive, 1.0f) + ';');
        add("material.dvPower = " + literal(material.power) + ';');
        add("TRY(device->SetMaterial(&material));");
    }

    void light(std::size_t index, const Light& light) {
        const std::string number = std::to_string(index), name = "light_" + number;
        add("D3DLIGHT7 " + name + " = {};");
        add(name + ".dltType = " + constant("D3DLIGHT_", light.type) + ';');
        add(name + ".dcvDiffuse = " + color(light.diffuse, 1.0f) + ';');
        add(name + ".dcvSpecular = " + color(light.specular, 1.0f) + ';');
        add(name + ".dcvAmbient = " + color(light.ambient, 1.0f) + ';');
        if (light.type == LightType::Directional) {
            add(name + ".dvDirection = " + vector(light.direction) + ';');
        } else {
            add(name + ".dvPosition = " + vector(light.position) + ';');
            add(name + ".dvRange = " + literal(std::min(light.range, kRangeMax)) + ';');
            add(name + ".dvAttenuation0 = " + literal(light.attenuation.x) + ';');
            add(name + ".dvAttenuation1 = " + literal(light.attenuation.y) + ';');
            add(name + ".dvAttenuation2 = " + literal(light.attenuation.z) + ';');
        }
        add("TRY(device->SetLight(" + number + ", &" + name + "));");
        add("TRY(device->LightEnable(" + number + ", TRUE));");
    }

    void ambient(Argb value) {
        if (value.value != 0) add(set_state({"D3DRENDERSTATE_AMBIENT", literal(value)}));
    }

    std::vector<std::string> take() { return std::move(lines_); }

  private:
    std::vector<std::string> lines_;
};

// Puts the light that is everywhere into a light, if one can take it: a directional one reaches everything.
bool take_ambient(std::vector<Light>& lights, const Vec3& ambient) {
    const auto found = std::find_if(lights.begin(), lights.end(),
                                    [](const Light& light) { return light.type == LightType::Directional; });
    if (found != lights.end()) {
        found->ambient += ambient;
        return true;
    }
    if (lights.size() == static_cast<std::size_t>(kMaxLights)) return false;
    lights.push_back({.type = LightType::Directional, .diffuse = Vec3(0.0f), .ambient = ambient});
    return true;
}

}  // namespace

std::vector<std::string> lighting_calls(const LightingState& state) {
    Calls calls;
    calls.material(state.material);
    std::vector<Light> lights = state.lights;
    if (const auto exact = exact_color(state.ambient)) {
        calls.ambient(*exact);
    } else if (take_ambient(lights, state.ambient)) {
        calls.add("// The ambient light, " + list_of({state.ambient.r, state.ambient.g, state.ambient.b}) +
                  ", is no colour of bytes: a directional light brings it.");
    } else {
        calls.add("// The ambient light, " + list_of({state.ambient.r, state.ambient.g, state.ambient.b}) +
                  ", is rounded to bytes: there are no more lights.");
        calls.ambient(
            {nearest_byte(state.ambient.r) << 16 | nearest_byte(state.ambient.g) << 8 | nearest_byte(state.ambient.b)});
    }
    for (std::size_t i = 0; i < lights.size(); ++i) calls.light(i, lights[i]);
    return calls.take();
}

}  // namespace pipeline::dx7
