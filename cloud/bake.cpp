// SPDX-License-Identifier: MIT
#include "cloud/bake.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <stdexcept>
#include <string>

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
    }
    require(cloud.base_y == cloud.base_y && cloud.base_y <= 1e6f, cloud, "base_y must be a number below 1e6 m");
    require(cloud.blur_m >= 0.0f && cloud.blur_m <= 1e5f, cloud, "blur_m must be 0 to 1e5 m");
    require(cloud.opacity >= 0.0f && cloud.opacity <= 1.0f, cloud, "opacity must be 0 to 1");
    require(cloud.absorption >= 0.0f && cloud.absorption <= 1e3f, cloud, "absorption must be 0 to 1000");
    require(cloud.lumpiness >= 0.0f && cloud.lumpiness <= 0.5f, cloud, "lumpiness must be 0 to 0.5");
    const Fractal& f = cloud.fractal;
    require(f.face_size >= 1 && f.face_size <= 1024 && (f.face_size & (f.face_size - 1)) == 0, cloud,
            "fractal.face_size must be a power of two up to 1024");
    require(f.octaves >= 1 && f.octaves <= 12, cloud, "fractal.octaves must be 1 to 12");
    require(f.gain >= 0.0f && f.gain <= 1.0f, cloud, "fractal.gain must be 0 to 1");
    require(f.cycles > 0.0f && f.cycles <= 1024.0f, cloud, "fractal.cycles must be above 0, up to 1024");
}

}  // namespace

BakedCloud bake(const Cloud& cloud, const Daylight& daylight) {
    check(cloud);
    check(daylight);
    BakedCloud baked{cloud, daylight, light_particles(cloud, daylight), {}};
    if (!cloud.particles.empty())
        baked.fractal = make_fractal(cloud.fractal, baked.lit.high - baked.lit.low,
                                     cloud.mode == Mode::Article ? FractalCode::Factor : FractalCode::Half);
    return baked;
}

}  // namespace cloud
