// SPDX-License-Identifier: MIT
// Which samples a primitive covers (the rules of raster/primitives.h, unsnapped), and what it gives to each.
#pragma once

#include "pipeline/truth/fragment.h"
#include "pipeline/truth/vertices.h"

namespace pipeline::truth {

// Linear in the window; `origin` is the triangle's.
struct Plane {
    double value = 0.0, dx = 0.0, dy = 0.0;
};

// A side, the same numbers for both triangles that share it.
struct Side {
    double x = 0.0, y = 0.0, to_x = 0.0, to_y = 0.0;  // from its end with the lesser (x, y)
    bool is_reversed = false, is_top_left = false;
    bool has_inside(double px, double py) const;
};

class CoveredTriangle {
  public:
    // Of an area that is not 0.
    explicit CoveredTriangle(const WindowTriangle& triangle);
    bool covers(double x, double y) const;
    // (x, y): the sample; (center_x, center_y): its pixel. textures: those that are read.
    Fragment at(double x, double y, double center_x, double center_y, const FragmentSetup& setup) const;

    double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;  // around it

  private:
    struct TexturePlanes {
        Plane s, t, q;
        double least_q = 0.0;
    };
    double at(const Plane& plane, double x, double y) const;
    Color color_at(const std::array<Plane, 4>& planes, double x, double y) const;
    TexturePoint point_at(const TexturePlanes& planes, double x, double y, double center_x, double center_y) const;

    double origin_x_ = 0.0, origin_y_ = 0.0, least_z_ = 0.0, greatest_z_ = 1.0;
    std::array<Side, 3> sides_;
    Plane depth_;
    std::array<Plane, 4> diffuse_, specular_;
    std::array<TexturePlanes, kTextureStages> textures_;
};

bool covers(const DrawRectangle& rectangle, double x, double y);
Fragment fragment_at(const DrawRectangle& rectangle, double x, double y, double center_x, double center_y);

}  // namespace pipeline::truth
