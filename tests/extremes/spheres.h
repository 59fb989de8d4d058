// SPDX-License-Identifier: MIT
// Clouds of spheres as small, as large and as near as they may be.
#pragma once

#include <array>
#include <span>
#include <string>

#include "cloud/cloud.h"
#include "tests/extremes/extremes.h"

namespace extremes {

// One sphere of the least radius, below a pixel; many of them; one larger than the picture, before the eye; the eye at
// a sphere's centre; inside of all spheres of a cloud; on a sphere's surface.
enum class Place : std::uint8_t { Least, ManySmall, Large, AtCentre, InsideAll, OnSurface };
inline constexpr std::array kPlaces{Place::Least,    Place::ManySmall, Place::Large,
                                    Place::AtCentre, Place::InsideAll, Place::OnSurface};

struct Setting {
    cloud::Cloud cloud;
    cloud::View view;
};
Setting setting(Place place, cloud::Mode mode, cloud::Detail detail, cloud::Order order, int width, int height);

// What a cloud without fractal hides of a scene behind it, in 255ths of each pixel: the least and the greatest; 255 everywhere
// with the eye inside, 0 without a sphere.
struct Hidden {
    int least = 255, greatest = 0;
};
Hidden hidden(Place place, cloud::Mode mode);

// Frames of all modes, details and orders, for each of the places: how many, and how many of them are not valid.
struct SphereFrames {
    std::uint64_t frames = 0, invalid = 0;
    std::string first;  // finding
};
SphereFrames sphere_frames(std::span<const Place> places, int width, int height);
pipeline::Frame sphere_frame(const Setting& setting);

// Pictures as narrow as they may be.
inline constexpr std::array<std::array<int, 2>, 6> kShapes{
    {{1, 1}, {33, 7}, {640, 15}, {15, 640}, {8192, 8}, {8, 8192}}};

// Is a radius refused?
bool is_radius_refused(float radius);

}  // namespace extremes
