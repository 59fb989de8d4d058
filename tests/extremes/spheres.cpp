// SPDX-License-Identifier: MIT
#include "tests/extremes/spheres.h"

#include <algorithm>
#include <stdexcept>

#include "cloud/mega_particles/mega_particles.h"
#include "pipeline/execute/execute.h"
#include "pipeline/validate/validate.h"
#include "tests/cloud/coverage.h"
#include "tests/cloud/cumulus.h"

namespace extremes {

using namespace cloud;

namespace {

Particle sphere(Vec3 center, float radius) {
    return {.center = center, .radius = radius};
}

pipeline::Frame frame_of(const Setting& setting, std::uint32_t background) {
    return plain_scene(
        [&](pipeline::Frame& frame, const SceneTargets& scene, const View& view) {
            append_mega_particles(frame, scene, view, Daylight{}, std::span(&setting.cloud, 1));
        },
        setting.view, {background});
}

}  // namespace

Setting setting(Place place, Mode mode, Detail detail, Order order, int width, int height) {
    Setting setting;
    Cloud& cloud            = setting.cloud;
    cloud.mode              = mode;
    cloud.detail            = detail;
    cloud.order             = order;
    cloud.fractal.face_size = 16;
    const Vec3 eye(0.0f, 60.0f, 100.0f);
    setting.view = look(eye, Vec3(0.0f, 60.0f, 0.0f), width, height);
    switch (place) {
        case Place::Least:
            cloud.particles = {sphere(Vec3(0.0f, 60.0f, 0.0f), 1e-3f)};
            break;
        case Place::ManySmall:
            for (int i = 0; i < 200; ++i)
                cloud.particles.push_back(
                    sphere(Vec3(static_cast<float>(i % 20 - 10), 55.0f + static_cast<float>(i / 20), 0.0f), 1e-3f));
            break;
        case Place::Large:
            cloud.particles = {sphere(Vec3(0.0f, 60.0f, -1e4f), 1e4f)};
            break;
        case Place::AtCentre:
            cloud.particles = {sphere(eye, 20.0f)};
            break;
        case Place::InsideAll:
            for (int i = 0; i < 12; ++i)
                cloud.particles.push_back(
                    sphere(eye + Vec3(static_cast<float>(i % 3 - 1), static_cast<float>(i / 3 - 1),
                                      static_cast<float>(i % 5 - 2)),
                           20.0f));
            break;
        case Place::OnSurface:
            cloud.particles = {sphere(eye + Vec3(0.0f, 0.0f, -20.0f), 20.0f)};
            break;
    }
    return setting;
}

Hidden hidden(Place place, Mode mode) {
    const Setting what               = setting(place, mode, Detail::None, Order::InOrder, 160, 120);
    const pipeline::ColorImage black = pipeline::execute(frame_of(what, 0xff000000)).output;
    const pipeline::ColorImage white = pipeline::execute(frame_of(what, 0xffffffff)).output;
    Hidden hidden;
    for (std::size_t i = 0; i < black.pixels.size(); ++i) {
        const auto green  = [](std::uint32_t argb) { return static_cast<int>(argb >> 8 & 255); };
        const int of_this = 255 - (green(white.pixels[i]) - green(black.pixels[i]));
        hidden.least      = std::min(hidden.least, of_this);
        hidden.greatest   = std::max(hidden.greatest, of_this);
    }
    return hidden;
}

SphereFrames sphere_frames(std::span<const Place> places, int width, int height) {
    SphereFrames frames;
    for (const Place place : places)
        for (const Mode mode : {Mode::Skirt, Mode::Article, Mode::Premultiplied, Mode::Black})
            for (const Detail detail : {Detail::Fractal, Detail::Displacement, Detail::None})
                for (const Order order : {Order::InOrder, Order::OrderFree}) {
                    const std::vector<pipeline::Finding> findings =
                        validate(sphere_frame(setting(place, mode, detail, order, width, height)));
                    ++frames.frames;
                    if (findings.empty()) continue;
                    ++frames.invalid;
                    if (frames.first.empty()) frames.first = findings[0].where + " " + findings[0].what;
                }
    return frames;
}

pipeline::Frame sphere_frame(const Setting& setting) {
    return frame_of(setting, 0xff4060ff);
}

bool is_radius_refused(float radius) {
    Cloud cloud;
    cloud.particles = {sphere(Vec3(0.0f), radius)};
    try {
        bake(cloud, Daylight{});
    } catch (const std::invalid_argument&) {
        return true;
    }
    return false;
}

std::vector<Row> sphere_rows() {
    Hidden without, inside;
    without.least = 0;
    for (const Place place : kPlaces)
        for (const Mode mode : {Mode::Skirt, Mode::Article, Mode::Premultiplied, Mode::Black}) {
            const Hidden found = hidden(place, mode);
            if (place == Place::Least || place == Place::ManySmall)
                without.greatest = std::max(without.greatest, found.greatest);
            else
                inside.least = std::min(inside.least, found.least);
        }
    SphereFrames shapes;
    for (const auto& [width, height] : kShapes) {
        const SphereFrames found = sphere_frames(std::array{Place::Large}, width, height);
        shapes.frames += found.frames;
        shapes.invalid += found.invalid;
    }
    return {
        {"spheres below a pixel", "radius 1 mm, 100 m away; one and 200", "0 of 255 hidden",
         std::to_string(without.greatest), "a radius below 1 mm, and so 0, is refused, as one above 100 km is"},
        {"spheres around the eye or larger than the picture",
         "eye at the centre, on the surface, inside of all; radius 10 km", "255 of 255 hidden",
         std::to_string(inside.least), "nowhere"},
        {"clouds in pictures of any shape", "1x1 to 8,192x8 and 8x8,192; modes, details and orders",
         "the frame is valid", count_text(shapes.invalid) + " invalid of " + count_text(shapes.frames), "8,192 pixels"},
    };
}

}  // namespace extremes
