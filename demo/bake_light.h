// SPDX-License-Identifier: MIT
// Light that does not change with the view, computed once for a vertex: sunlight past terrain, solids and clouds, light
// of the sky from the directions the terrain leaves free, and light thrown back by the ground. Colours are factors, y
// is up.
#pragma once

#include <span>
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

// The same where the terrain's share is known.
float sun_past_columns(const Surroundings& around, const Vec3& point, const Vec3& to_sun, float terrain_share);

// Share of sunlight that the clouds let through: 0..1.
float sun_past_clouds(const Surroundings& around, const Vec3& point, const Vec3& to_sun);

// Multiplies by it the shares of the sun at points that lie in a row; those of 0 stay.
void shade_by_clouds(const Surroundings& around, std::span<const Vec3> points, const Vec3& to_sun,
                     std::span<float> shares);

// Share of the sky's light that reaches a horizontal surface past the terrain: 0..1.
float open_sky(const HeightField& terrain, const Vec3& point);

// What the terrain leaves of the light at points above its own grid: the same as above and several times faster, for
// where on the grid the rays lead is found once for each column and each row.
class GridLight {
  public:
    GridLight(const HeightField& terrain, const Vec3& to_sun);
    class Row;

  private:
    // One coordinate of all places that the light at a point depends on.
    struct Ways {
        std::vector<HeightField::GridCoordinate> to_sun, around;
    };
    template <class Along>
    static Ways ways(float from, float to_sun, std::size_t axis, Along&& along);

    const HeightField& terrain_;
    Vec3 to_sun_;
    std::vector<Ways> columns_;
};

class GridLight::Row {
  public:
    Row(const GridLight& light, int row);
    // y: height of the point above this column of the row.
    float sun_past_terrain(int column, float y) const;
    float open_sky(int column, float y) const;

  private:
    const GridLight& light_;
    Ways ways_;
};

// sun: share of sunlight that arrives; sky: share of skylight.
Vec3 light_of_day(const cloud::Daylight& light, const Vec3& normal, float sun, float sky);

}  // namespace demo
