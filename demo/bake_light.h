// SPDX-License-Identifier: MIT
// Light that does not change with the view, computed once for a vertex: sunlight past terrain, solids and clouds, light
// of the sky from the directions the terrain leaves free, and light thrown back by the ground. Colours are factors, y
// is up.
#pragma once

#include <vector>

#include "cloud/cloud.h"
#include "demo/height_field.h"

namespace demo {

// An upright elliptic column that casts a shadow; a box or tower is approximated by one.
struct ShadowColumn {
    Vec3 center;  // y: of the foot
    float top_y;
    float radius_x, radius_z;
};

// A cloud that casts a shadow, its spheres counted with absorption, and a sphere around them all.
struct ShadowCloud {
    explicit ShadowCloud(const cloud::Cloud& casts);
    const cloud::Cloud* cloud;
    Vec3 center;
    float radius;
};

// What stands between a point and the light. The terrain may be null.
struct Surroundings {
    const HeightField* terrain = nullptr;
    std::vector<ShadowColumn> columns;
    std::vector<ShadowCloud> clouds;
};

// Share of the sun's disc, made wide for a soft edge, that terrain and columns leave free: 0..1.
float sun_past_solids(const Surroundings& around, const Vec3& point, const Vec3& to_sun);

// Share of sunlight that the clouds let through: 0..1.
float sun_past_clouds(const Surroundings& around, const Vec3& point, const Vec3& to_sun);

// Share of the sky's light that reaches a horizontal surface past the terrain: 0..1.
float open_sky(const HeightField& terrain, const Vec3& point);

// sun: share of sunlight that arrives; sky: share of skylight.
Vec3 light_of_day(const cloud::Daylight& light, const Vec3& normal, float sun, float sky);

}  // namespace demo
