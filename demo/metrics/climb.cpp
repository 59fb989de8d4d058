// SPDX-License-Identifier: MIT
#include "demo/metrics/climb.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <utility>

#include "demo/metrics/measures.h"
#include "demo/metrics/statistics.h"

namespace demo {
namespace {

constexpr double kStep = 0.25;

using Neighbors = std::initializer_list<std::pair<int, int>>;
constexpr Neighbors kNeighbors{{1, 0}, {-1, 0}, {0, 1}, {0, -1}};

bool is_straight(const Plane& shape, const CutPoint& point, double straight_px) {
    for (double s = 1.5; s <= straight_px; s += 1.0) {
        const Vec2 from(static_cast<float>(point.x), static_cast<float>(point.y)),
            step = point.out * static_cast<float>(s);
        if (sample(shape, from.x - step.x, from.y - step.y) < 0.99f) return false;
        if (sample(shape, from.x + step.x, from.y + step.y) > 0.01f) return false;
    }
    return true;
}

// Widths are over that of the step. falling: grows by one for each climb that is monotone.
void append_climbs(Studio& studio, std::vector<double>& widths, std::size_t& falling) {
    const Anatomy& anatomy    = studio.anatomy();
    const cloud::Cloud& cloud = studio.clouds().front().baked.cloud;
    // Article and black mode multiply with alpha twice: the edge is that of a^2.
    const bool squared        = cloud.mode == cloud::Mode::Article || cloud.mode == cloud::Mode::Black;
    const double step_px      = (squared ? 2.11 : 2.56) * anatomy.sigma_px;
    for (const CutPoint& point : cut_points(anatomy.shape, anatomy.shape_alone, anatomy.scene_m, anatomy.shape_m,
                                            2.0f * cloud.blur_m, 2.5 * anatomy.sigma_px))
        if (const auto climb = climb_at(studio.detailless_coverage(), point, 5.0 * anatomy.sigma_px)) {
            widths.push_back(climb->width_px / step_px);
            falling += climb->monotone;
        }
}

}  // namespace

std::vector<CutPoint> cut_points(const Plane& shape, const Plane& shape_alone, const Plane& scene_m,
                                 const Plane& shape_m, float gap_m, double straight_px) {
    const Plane soft = smoothed(shape, 2.0);
    std::vector<CutPoint> points;
    for (int y = 0; y < shape.height; ++y)
        for (int x = 0; x < shape.width; ++x) {
            if (shape.at(x, y) < 0.99f) continue;
            for (const auto& [dx, dy] : kNeighbors) {
                const int nx = x + dx, ny = y + dy;
                if (!shape.has(nx, ny) || shape.at(nx, ny) > 0.01f || shape_alone.at(nx, ny) < 0.99f) continue;
                if (!(std::abs(scene_m.at(nx, ny) - shape_m.at(nx, ny)) <= gap_m)) continue;
                const Vec2 slope = gradient(soft, x, y);
                if (!(glm::length(slope) > 1e-4f)) continue;
                const CutPoint point{x, y, -glm::normalize(slope)};
                if (is_straight(shape, point, straight_px)) points.push_back(point);
                break;
            }
        }
    return points;
}

std::optional<Climb> climb_at(const Plane& coverage, const CutPoint& point, double reach) {
    const auto value = [&](double s) {
        return static_cast<double>(sample(coverage, static_cast<float>(point.x) + point.out.x * static_cast<float>(s),
                                          static_cast<float>(point.y) + point.out.y * static_cast<float>(s)));
    };
    // The last place above 0.9 before the first below 0.1.
    std::optional<double> high, low;
    for (double s = -reach; s <= reach && !low; s += kStep) {
        if (value(s) >= 0.9) high = s;
        if (value(s) <= 0.1 && high) low = s;
    }
    if (!high || !low) return std::nullopt;
    const auto refined = [&](double before, double level) {  // between `before` and the next step
        const double a = value(before), b = value(before + kStep);
        return before + kStep * (a - level) / std::max(a - b, 1e-12);
    };
    Climb climb{.width_px = refined(*low - kStep, 0.1) - refined(*high, 0.9)};
    double least = 1.0;
    for (double s = *high; s <= *low; s += kStep) {
        if (value(s) > least + 1.5 / 255.0) climb.monotone = false;
        least = std::min(least, value(s));
    }
    return climb;
}

std::optional<double> leak(const Plane& coverage, const Mask& nearer) {
    double sum = 0.0;
    int border = 0;
    for (int y = 0; y < nearer.height; ++y)
        for (int x = 0; x < nearer.width; ++x) {
            if (nearer.at(x, y) == 0) continue;
            sum += static_cast<double>(coverage.at(x, y));
            for (const auto& [dx, dy] : kNeighbors)
                if (nearer.has(x + dx, y + dy) && nearer.at(x + dx, y + dy) == 0 &&
                    coverage.at(x + dx, y + dy) > 0.02f) {
                    ++border;
                    break;
                }
        }
    return border > 0 ? std::optional(sum / border) : std::nullopt;
}

Metrics measure_climb(Studio& studio) {
    constexpr std::size_t kLeastProfiles = 10;
    Metric width{
        "M3.climb_width",
        "width of the edge on what reaches in, over that of a Gaussian step of the blur's sigma, in up to 5 frames",
        "",
        {},
        Target{0.8, 1.2}};
    Metric monotone{"M3.monotone", "such edges that fall all the way", "%", {}, Target{95.0, 100.0}};
    Metric ordered{"M3.leak", "cloud over what stands before it, by the border's length", "px", {}, at_most(0.0)};
    Metric order_free{"M3.leak_order_free",
                      "the same with the scene drawn first and the order-free composite",
                      "px",
                      {},
                      at_most(0.0)};
    Metric unordered{"M3.leak_unordered", "the same with the scene drawn first and the plain composite", "px"};
    if (!studio.has_cloud()) return {width, monotone, ordered, order_free, unordered};
    std::vector<double> widths;
    std::size_t falling = 0;
    for (Studio& take : studio.takes()) {
        if (!take.has_cloud()) continue;
        take.edit().geometry.solids_in_front.clear();  // these hide the cloud and do not cut it
        append_climbs(take, widths, falling);
    }
    if (widths.size() >= kLeastProfiles) {
        width.value    = quantile(widths, 0.5);
        monotone.value = 100.0 * static_cast<double>(falling) / static_cast<double>(widths.size());
    }

    const Anatomy& anatomy = studio.anatomy();
    Mask nearer(anatomy.scene_m.width, anatomy.scene_m.height);
    for (std::size_t i = 0; i < nearer.values.size(); ++i)
        nearer.values[i] = anatomy.scene_m.values[i] <= anatomy.near_m;
    ordered.value = leak(studio.plain_coverage(), nearer);
    if (studio.is_mega()) {
        FrameOptions free       = studio.shot();
        free.order              = cloud::Order::OrderFree;
        order_free.value        = leak(studio.coverage(free), nearer);
        SceneGeometry& geometry = studio.edit().geometry;
        geometry.solids_behind.insert(geometry.solids_behind.end(), geometry.solids_in_front.begin(),
                                      geometry.solids_in_front.end());
        geometry.solids_in_front.clear();
        unordered.value = leak(studio.coverage(), nearer);
        studio.restore();
    }
    return {width, monotone, ordered, order_free, unordered};
}

}  // namespace demo
