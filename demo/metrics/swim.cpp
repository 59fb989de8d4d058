// SPDX-License-Identifier: MIT
#include "demo/metrics/swim.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <vector>

#include "demo/metrics/measures.h"
#include "demo/metrics/statistics.h"

namespace demo {
namespace {

// By how much a camera motion is to move the cloud's surface on the screen (median). In an orbit its rim moves less.
constexpr float kFlowPx = 4.0f;

Plane detail_of(Studio& studio) {
    FrameOptions options = studio.shot();
    Plane detail         = studio.coverage(options);
    options.has_detail   = false;
    const Plane plain    = studio.coverage(options);
    for (std::size_t i = 0; i < detail.values.size(); ++i) detail.values[i] -= plain.values[i];
    return detail;
}

}  // namespace

Grid<Vec2> camera_flow(const Plane& depth_m, const pipeline::Camera& before, const pipeline::Camera& after) {
    const glm::dmat4 to_world = glm::inverse(glm::dmat4(before.projection) * glm::dmat4(before.view));
    const glm::dmat4 to_clip  = glm::dmat4(after.projection) * glm::dmat4(after.view);
    const double width = depth_m.width, height = depth_m.height;
    Grid<Vec2> flow(depth_m.width, depth_m.height);
    for (int y = 0; y < depth_m.height; ++y)
        for (int x = 0; x < depth_m.width; ++x) {
            const double w = static_cast<double>(depth_m.at(x, y));
            const double z =
                -static_cast<double>(before.projection[2][2]) * w + static_cast<double>(before.projection[3][2]);
            const glm::dvec4 clip(((x + 0.5) / width * 2.0 - 1.0) * w, (1.0 - (y + 0.5) / height * 2.0) * w, z, w);
            const glm::dvec4 moved = to_clip * (to_world * clip);
            flow.at(x, y)          = Vec2(static_cast<float>((1.0 + moved.x / moved.w) * width / 2.0 - (x + 0.5)),
                                          static_cast<float>((1.0 - moved.y / moved.w) * height / 2.0 - (y + 0.5)));
        }
    return flow;
}

Swim swim(const Plane& detail_before, const Plane& detail_after, const Grid<Vec2>& flow, const Mask& where) {
    std::vector<double> before, followed, stayed;
    for (int y = 0; y < detail_before.height; ++y)
        for (int x = 0; x < detail_before.width; ++x) {
            if (where.at(x, y) == 0) continue;
            const Vec2 to = Vec2(static_cast<float>(x), static_cast<float>(y)) + flow.at(x, y);
            if (!(to.x >= 0.0f && to.y >= 0.0f && to.x <= static_cast<float>(detail_after.width - 1) &&
                  to.y <= static_cast<float>(detail_after.height - 1)))
                continue;
            before.push_back(static_cast<double>(detail_before.at(x, y)));
            followed.push_back(static_cast<double>(sample(detail_after, to.x, to.y)));
            stayed.push_back(static_cast<double>(detail_after.at(x, y)));
        }
    return {correlation(before, followed), correlation(before, stayed)};
}

Plane without_holes(const Plane& depth_m) {
    Mask finite(depth_m.width, depth_m.height);
    for (std::size_t i = 0; i < finite.values.size(); ++i) finite.values[i] = std::isfinite(depth_m.values[i]);
    const Nearest nearest = nearest_marked(finite);
    Plane filled          = depth_m;
    for (std::size_t i = 0; i < filled.values.size(); ++i)
        if (nearest.index.values[i] >= 0)
            filled.values[i] = depth_m.values[static_cast<std::size_t>(nearest.index.values[i])];
    return filled;
}

Metrics measure_swim(Studio& studio) {
    Metric orbit{
        "M6.orbit", "detail's correlation on the screen less that on the cloud, in an orbit", "", {}, at_most(-0.2)};
    Metric turn{"M6.turn", "the same while the camera turns in its place", "", {}, at_most(-0.2)};
    Metric shift{"M6.shift", "the same while the camera moves sideways", "", {}, at_most(-0.2)};
    Metric on_cloud{"M6.on_cloud", "detail's correlation on the cloud, in an orbit", ""};
    const bool has_fractal =
        studio.is_mega() && studio.has_cloud() && studio.clouds().front().baked.cloud.detail != cloud::Detail::None;
    if (!has_fractal) return {orbit, turn, shift, on_cloud};

    const Plane& surface          = studio.anatomy().shape_m;
    const Plane depth             = without_holes(surface);
    const Plane before            = detail_of(studio);
    const pipeline::Camera camera = studio.frame().cameras[0];
    const Vec3 eye = studio.eye(), target = studio.target(), middle = studio.cloud_middle();
    Mask where = rim_of(studio.plain_coverage());
    for (std::size_t i = 0; i < where.values.size(); ++i)
        if (!std::isfinite(depth.values[i])) where.values[i] = 0;

    // amount: radians of the orbit and of the turn, or metres.
    const auto camera_moved = [&](int motion, float amount) {
        const auto turned = [&](Vec3 v) {
            return Vec3(std::cos(amount) * v.x + std::sin(amount) * v.z, v.y,
                        std::cos(amount) * v.z - std::sin(amount) * v.x);
        };
        const Vec3 side = glm::normalize(glm::cross(target - eye, Vec3(0.0f, 1.0f, 0.0f)));
        if (motion == 0)
            studio.look_from(middle + turned(eye - middle), middle + turned(target - middle));
        else if (motion == 1)
            studio.look_from(eye, eye + turned(target - eye));
        else
            studio.look_from(eye + side * amount, target + side * amount);
    };
    const auto flow_of = [&](int motion, float amount) {
        camera_moved(motion, amount);
        return camera_flow(depth, camera, studio.frame().cameras[0]);
    };
    const auto measure = [&](int motion, float trial) {
        std::vector<double> lengths;
        const Grid<Vec2> tried = flow_of(motion, trial);
        for (std::size_t i = 0; i < surface.values.size(); ++i)
            if (std::isfinite(surface.values[i])) lengths.push_back(static_cast<double>(glm::length(tried.values[i])));
        const auto length     = static_cast<float>(quantile(lengths, 0.5));
        const Grid<Vec2> flow = flow_of(motion, trial * kFlowPx / std::max(length, 1e-3f));
        const Swim found      = swim(before, detail_of(studio), flow, where);
        studio.look_from(eye, target);
        return found;
    };
    const Swim around   = measure(0, 0.01f);
    const Swim in_place = measure(1, 0.01f);
    const Swim sideways = measure(2, 0.01f * glm::length(middle - eye));
    orbit.value         = around.on_screen - around.on_object;
    on_cloud.value      = around.on_object;
    turn.value          = in_place.on_screen - in_place.on_object;
    shift.value         = sideways.on_screen - sideways.on_object;
    return {orbit, turn, shift, on_cloud};
}

}  // namespace demo
