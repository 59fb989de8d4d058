// SPDX-License-Identifier: MIT
#include "tests/peers/gl_lighting.h"

#include <algorithm>
#include <array>

#include "tests/peers/gl.h"

namespace peers {

using namespace pipeline;

namespace {

using Floats = std::array<float, 4>;

Floats floats(const Vec3& v, float w) {
    return {v.x, v.y, v.z, w};
}
Floats floats(const Vec4& v) {
    return {v.x, v.y, v.z, v.w};
}

constexpr float kEverywhere = 1e8f;  // a range
constexpr float kMaxPower   = 128.0f;

// Specular colours of a material matter only if one comes out.
bool has_specular(const LightingState& lighting) {
    if (!lighting.specular_enable) return false;
    for (const Light& light : lighting.lights)
        if (light.specular != Vec3(0.0f)) return true;
    return false;
}

// OpenGL lets one property of the material, or ambient and diffuse together, follow the vertex's first colour.
struct FollowsColor {
    bool ambient, diffuse, specular, emissive;
    explicit FollowsColor(const LightingState& lighting)
        : ambient(lighting.ambient_source == ColorSource::Color1),
          diffuse(lighting.diffuse_source == ColorSource::Color1),
          specular(has_specular(lighting) && lighting.specular_source == ColorSource::Color1),
          emissive(lighting.emissive_source == ColorSource::Color1) {}

    int count() const { return ambient + diffuse + specular + emissive; }
    bool is_possible() const { return count() <= 1 || (count() == 2 && ambient && diffuse); }
    GLenum property() const {
        if (ambient && diffuse) return GL_AMBIENT_AND_DIFFUSE;
        if (ambient) return GL_AMBIENT;
        if (diffuse) return GL_DIFFUSE;
        if (specular) return GL_SPECULAR;
        return GL_EMISSION;
    }
};

void set_light(GLenum name, const Light& light, bool adds_specular) {
    glEnable(name);
    glLightfv(name, GL_DIFFUSE, floats(light.diffuse, 1.0f).data());
    glLightfv(name, GL_AMBIENT, floats(light.ambient, 1.0f).data());
    glLightfv(name, GL_SPECULAR, floats(adds_specular ? light.specular : Vec3(0.0f), 1.0f).data());
    if (light.type == LightType::Directional) {
        glLightfv(name, GL_POSITION, floats(-light.direction, 0.0f).data());
    } else {
        glLightfv(name, GL_POSITION, floats(light.position, 1.0f).data());
        glLightf(name, GL_CONSTANT_ATTENUATION, light.attenuation.x);
        glLightf(name, GL_LINEAR_ATTENUATION, light.attenuation.y);
        glLightf(name, GL_QUADRATIC_ATTENUATION, light.attenuation.z);
    }
}

}  // namespace

Mat4 opengl_view(const Camera& camera) {
    Mat4 flip(1.0f);
    flip[2][2] = -1.0f;
    return flip * camera.view;
}

void set_lighting(const LightingState& lighting, const Camera& camera) {
    glEnable(GL_LIGHTING);
    glDisable(GL_COLOR_SUM);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, floats(lighting.ambient, 1.0f).data());
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, lighting.local_viewer);
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_FALSE);
    if (lighting.normalize_normals)
        glEnable(GL_NORMALIZE);
    else
        glDisable(GL_NORMALIZE);

    const Material& material = lighting.material;
    glDisable(GL_COLOR_MATERIAL);
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, floats(material.ambient, 1.0f).data());
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, floats(material.diffuse).data());
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, floats(material.specular, 1.0f).data());
    glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, floats(material.emissive, 1.0f).data());
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, material.power);
    const FollowsColor follows(lighting);
    if (follows.count() > 0) {
        glColorMaterial(GL_FRONT_AND_BACK, follows.property());
        glEnable(GL_COLOR_MATERIAL);
    }

    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixf(&opengl_view(camera)[0][0]);
    for (int i = 0; i < kMaxLights; ++i) {
        const GLenum name = static_cast<GLenum>(GL_LIGHT0 + i);
        if (static_cast<std::size_t>(i) < lighting.lights.size())
            set_light(name, lighting.lights[static_cast<std::size_t>(i)], lighting.specular_enable);
        else
            glDisable(name);
    }
}

void set_no_lighting(bool add_specular) {
    glDisable(GL_LIGHTING);
    glDisable(GL_COLOR_MATERIAL);
    if (add_specular)
        glEnable(GL_COLOR_SUM);
    else
        glDisable(GL_COLOR_SUM);
}

std::optional<std::string> cannot_light(const LightingState& lighting) {
    if (!lighting.enabled) return std::nullopt;
    const auto second = [](ColorSource source) { return source == ColorSource::Color2; };
    if (second(lighting.ambient_source) || second(lighting.diffuse_source) || second(lighting.emissive_source) ||
        (has_specular(lighting) && second(lighting.specular_source)))
        return "no material colour from the vertex's second colour";
    if (!FollowsColor(lighting).is_possible()) return "no several material colours from the vertex's first colour";
    // OpenGL takes 0^0 for 1 also where the highlight is turned away.
    if (has_specular(lighting) && lighting.material.power == 0.0f) return "no specular power of 0";
    if (lighting.material.power > kMaxPower) return "no specular power above 128";
    for (const Light& light : lighting.lights) {
        if (light.type == LightType::Point && light.range < kEverywhere) return "no light with a range";
    }
    return std::nullopt;
}

void make_expressible(LightingState& lighting) {
    for (ColorSource* source :
         {&lighting.ambient_source, &lighting.diffuse_source, &lighting.specular_source, &lighting.emissive_source})
        if (*source == ColorSource::Color2) *source = ColorSource::Material;
    if (!FollowsColor(lighting).is_possible())
        lighting.emissive_source = lighting.specular_source = ColorSource::Material;
    lighting.material.power = std::clamp(lighting.material.power, 1.0f, kMaxPower);
    for (Light& light : lighting.lights) light.range = std::max(light.range, kEverywhere);
}

}  // namespace peers
