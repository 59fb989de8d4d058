// SPDX-License-Identifier: MIT
#include "tests/extremes/spheres.h"

#include <limits>

#include "tests/support/small_frame.h"

using namespace extremes;

TEST_CASE("extremes: clouds of the least and the nearest spheres are valid frames, in all modes", "[extremes]") {
    const SphereFrames frames = sphere_frames(kPlaces, 160, 120);
    CHECK(frames.frames == 144);
    CHECK(frames.first == "");
}

// One side below 16 pixels made the blur's rectangles 32 times as long in both.
TEST_CASE("extremes: clouds are drawn in pictures of any shape", "[extremes]") {
    for (const auto& [width, height] : kShapes) {
        INFO(width << "x" << height);
        CHECK(sphere_frames(std::array{Place::Large}, width, height).first == "");
    }
}

TEST_CASE("extremes: spheres below a pixel hide nothing, and all is hidden from inside", "[extremes]") {
    for (const Place place : kPlaces)
        for (const cloud::Mode mode :
             {cloud::Mode::Skirt, cloud::Mode::Article, cloud::Mode::Premultiplied, cloud::Mode::Black}) {
            INFO("place " << static_cast<int>(place) << ", mode " << static_cast<int>(mode));
            const Hidden found  = hidden(place, mode);
            const bool is_small = place == Place::Least || place == Place::ManySmall;
            CHECK((is_small ? found.greatest : 255 - found.least) == 0);
        }
}

TEST_CASE("extremes: a sphere around the eye is drawn alike by kernels and reference", "[extremes]") {
    using namespace cloud;
    for (const Place place : {Place::AtCentre, Place::InsideAll, Place::OnSurface})
        test_support::pixels_on_both(
            sphere_frame(setting(place, Mode::Skirt, Detail::Fractal, Order::OrderFree, 49, 17)));
}

TEST_CASE("extremes: radii of 0, below 1 mm and above 100 km are refused", "[extremes]") {
    for (const float radius : {0.0f, -1.0f, 0.9e-3f, 1.1e5f, std::numeric_limits<float>::infinity(),
                               std::numeric_limits<float>::quiet_NaN()})
        CHECK(is_radius_refused(radius));
    CHECK_FALSE(is_radius_refused(1e-3f));
    CHECK_FALSE(is_radius_refused(1e5f));
}
