// SPDX-License-Identifier: MIT
#include "cloud/bake.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <initializer_list>
#include <stdexcept>
#include <string>

#include "cloud/bounds.h"

namespace cloud {
namespace {

void require(bool holds, const Cloud& cloud, const char* what) {
    if (!holds) throw std::invalid_argument("cloud '" + cloud.name + "': " + what);
}

// Beyond this float loses the centimetres.
bool within_reach(std::initializer_list<float> values) {
    for (float v : values)
        if (!(std::abs(v) <= 1e6f)) return false;
    return true;
}

void check(const Daylight& light) {
    const auto require_light = [](bool holds, const char* what) {
        if (!holds) throw std::invalid_argument(std::string("daylight: ") + what);
    };
    for (const Vec3& color : {light.sun, light.sky, light.bounce})
        require_light(within_reach({color.x, color.y, color.z}), "colours must be finite");
    const float length2 = glm::dot(light.to_sun, light.to_sun);
    require_light(length2 > 0.999f && length2 < 1.001f, "to_sun must be a unit vector");
}

void check(const Cloud& cloud) {
    for (const Particle& p : cloud.particles) {
        require(within_reach({p.center.x, p.center.y, p.center.z}), cloud, "a particle's centre must be within 1e6 m");
        require(p.radius >= 1e-3f && p.radius <= 1e5f, cloud, "a particle's radius must be 0.001 to 1e5 m");
        require(p.alpha >= 0.0f && p.alpha <= 1.0f, cloud, "a particle's alpha must be 0 to 1");
        require(within_reach({p.color.x, p.color.y, p.color.z}), cloud, "a particle's colour must be finite");
        require(within_reach({p.glow.x, p.glow.y, p.glow.z}), cloud, "a particle's glow must be finite");
        const float volume = glm::determinant(p.shape);
        require(volume > 1e-6f && greatest_radius(p) <= 1e3f * p.radius, cloud,
                "a particle's shape must stretch at most a thousandfold, and its determinant be above 0");
    }
    require(cloud.base_y == cloud.base_y && cloud.base_y <= 1e6f, cloud, "base_y must be a number below 1e6 m");
    require(cloud.blur_m >= 0.0f && cloud.blur_m <= 1e5f, cloud, "blur_m must be 0 to 1e5 m");
    require(cloud.opacity >= 0.0f && cloud.opacity <= 1.0f, cloud, "opacity must be 0 to 1");
    require(cloud.dissolve >= 0.0f && cloud.dissolve <= 1.0f, cloud, "dissolve must be 0 to 1");
    require(cloud.displacement >= 0.0f && cloud.displacement <= 10.0f, cloud, "displacement must be 0 to 10");
    for (const InnerLight& light : cloud.lights) {
        require(within_reach({light.center.x, light.center.y, light.center.z}), cloud, "a light must be within 1e6 m");
        require(within_reach({light.color.x, light.color.y, light.color.z}), cloud, "a light's colour must be finite");
        require(light.range > 0.0f && light.range <= 1e6f, cloud, "a light's range must be above 0, up to 1e6 m");
    }
    for (const std::optional<Turn>& turn : {cloud.box_turn, cloud.second_box_turn})
        require(!turn || std::abs(glm::dot(*turn, *turn) - 1.0f) < 1e-3f, cloud, "a turn must be of length 1");
    require(cloud.absorption >= 0.0f && cloud.absorption <= 1e3f, cloud, "absorption must be 0 to 1000");
    require(cloud.silver_lining >= 0.0f && cloud.silver_lining <= 4.0f, cloud, "silver_lining must be 0 to 4");
    require(cloud.lumpiness >= 0.0f && cloud.lumpiness <= 0.5f, cloud, "lumpiness must be 0 to 0.5");
    const Fractal& f = cloud.fractal;
    require(f.face_size >= 1 && f.face_size <= 1024 && (f.face_size & (f.face_size - 1)) == 0, cloud,
            "fractal.face_size must be a power of two up to 1024");
    require(f.octaves >= 1 && f.octaves <= 12, cloud, "fractal.octaves must be 1 to 12");
    require(f.gain >= 0.0f && f.gain <= 1.0f, cloud, "fractal.gain must be 0 to 1");
    require(f.cycles > 0.0f && f.cycles <= 1024.0f, cloud, "fractal.cycles must be above 0, up to 1024");
}

}  // namespace

Box fractal_box(const Cloud& cloud, const LitParticles& lit) {
    Box box = cloud.box.value_or(Box{lit.low, lit.high});
    if (cloud.box_turn || cloud.second_box_turn) {
        const Vec3 middle = (box.low + box.high) * 0.5f, half = box.high - middle;
        const float round = std::sqrt(half.x * half.x + half.z * half.z);
        box.low.x = middle.x - round, box.low.z = middle.z - round;
        box.high.x = middle.x + round, box.high.z = middle.z + round;
    }
    return box;
}

BakedCloud bake(const Cloud& cloud, const Daylight& daylight, const ForEach& for_each) {
    BakedCloud baked = bake(cloud, daylight, BakedCloud{}, for_each);
    if (cloud.particles.empty() && !cloud.box) return baked;
    const Box box = fractal_box(cloud, baked.lit);
    baked.fractal = std::make_shared<FractalFaces>(
        make_fractal(cloud.fractal, box.high - box.low,
                     cloud.mode == Mode::Skirt ? FractalCode::Half : FractalCode::Factor, for_each));
    return baked;
}

BakedCloud bake(const Cloud& cloud, const Daylight& daylight, const BakedCloud& before, const ForEach& for_each) {
    check(cloud);
    check(daylight);
    return {cloud, daylight, light_particles(cloud, daylight, for_each), before.fractal};
}

}  // namespace cloud
