// SPDX-License-Identifier: MIT
#include "demo/metrics/cutouts.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "demo/metrics/measures.h"
#include "demo/metrics/statistics.h"

namespace demo {
namespace {

constexpr double kStep = 0.25;  // pixels between samples of a profile

// Where a profile crosses `level` for the first time, in samples from its start. It rises from below to above.
double crossing(const std::vector<double>& profile, double level) {
    for (std::size_t i = 1; i < profile.size(); ++i)
        if (profile[i] >= level)
            return static_cast<double>(i) - (profile[i] - level) / std::max(profile[i] - profile[i - 1], 1e-12);
    return static_cast<double>(profile.size() - 1);
}

// Values from (x, y) on in a direction, as long as they rise (sign 1) or fall (-1). Bytes may step back by one.
std::vector<double> monotone_run(const Plane& plane, Vec2 from, Vec2 direction, double reach, double sign) {
    std::vector<double> run{static_cast<double>(sample(plane, from.x, from.y))};
    double extreme = run.front();
    for (double s = kStep; s <= reach; s += kStep) {
        const Vec2 at      = from + direction * static_cast<float>(s);
        const double value = static_cast<double>(sample(plane, at.x, at.y));
        if (!(sign * (value - extreme) > -1.5 / 255.0)) break;
        extreme = sign * value > sign * extreme ? value : extreme;
        run.push_back(value);
    }
    return run;
}

// widths: of edges where the scene takes at least a fifth of the cloud away. steps: pixels of edges, hard or not.
struct Edges {
    std::vector<double> widths;
    std::size_t steps = 0, hard_steps = 0;
};

void append_edges(Studio& studio, Edges& edges) {
    constexpr float kLeastDrop = 0.2f;
    const Anatomy& anatomy     = studio.anatomy();
    const Plane left           = share_left(studio.plain_coverage(), studio.coverage(studio.shot(), remove_scene));
    const Mask ridges          = ridges_of(left, 0.01f);
    const float gap_m          = studio.greatest_particle().radius;
    // Not where something that stands clear of the cloud hides it: such an edge is to be sharp.
    const auto meets           = [&](int x, int y) {
        bool is_met = false;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                if (!left.has(x + dx, y + dy)) continue;
                const float scene_m = anatomy.scene_m.at(x + dx, y + dy);
                if (scene_m <= anatomy.near_m) return false;
                is_met |= std::abs(scene_m - anatomy.shape_m.at(x + dx, y + dy)) <= gap_m;
            }
        return is_met;
    };
    for (int y = 0; y < left.height; ++y)
        for (int x = 0; x < left.width; ++x) {
            if (ridges.at(x, y) == 0 || !meets(x, y)) continue;
            if (const auto width = edge_width(left, x, y, std::max(8.0, 4.0 * anatomy.sigma_px), kLeastDrop))
                edges.widths.push_back(*width);
            if (const std::optional<bool> is_hard = is_hard_step(left, x, y)) {
                ++edges.steps;
                edges.hard_steps += *is_hard;
            }
        }
}

}  // namespace

Plane share_left(const Plane& coverage, const Plane& alone) {
    Plane share(coverage.width, coverage.height, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t i = 0; i < share.values.size(); ++i)
        if (alone.values[i] >= 0.5f) share.values[i] = coverage.values[i] / alone.values[i];
    return share;
}

Mask ridges_of(const Plane& plane, float least) {
    Plane slope(plane.width, plane.height);
    for (int y = 0; y < plane.height; ++y)
        for (int x = 0; x < plane.width; ++x) slope.at(x, y) = glm::length(gradient(plane, x, y));
    Mask ridges(plane.width, plane.height);
    for (int y = 0; y < plane.height; ++y)
        for (int x = 0; x < plane.width; ++x) {
            const float here = slope.at(x, y);
            if (!(here > least)) continue;
            const Vec2 up = glm::normalize(gradient(plane, x, y));
            const auto fx = static_cast<float>(x), fy = static_cast<float>(y);
            const float before = sample(slope, fx - up.x, fy - up.y), after = sample(slope, fx + up.x, fy + up.y);
            ridges.at(x, y) = here >= before && here >= after;
        }
    return ridges;
}

std::optional<double> edge_width(const Plane& plane, int x, int y, double reach, float least_drop) {
    const Vec2 slope = gradient(plane, x, y);
    if (!(glm::length(slope) > 0.0f)) return std::nullopt;
    const Vec2 up = glm::normalize(slope), from(static_cast<float>(x), static_cast<float>(y));
    auto down_run = monotone_run(plane, from, -up, reach, -1.0);
    auto up_run   = monotone_run(plane, from, up, reach, 1.0);
    std::vector<double> profile(down_run.rbegin(), down_run.rend());
    profile.insert(profile.end(), up_run.begin() + 1, up_run.end());
    const double low  = *std::min_element(profile.begin(), profile.end());
    const double high = *std::max_element(profile.begin(), profile.end());
    if (!(high - low >= static_cast<double>(least_drop))) return std::nullopt;
    return kStep * (crossing(profile, low + 0.9 * (high - low)) - crossing(profile, low + 0.1 * (high - low)));
}

std::optional<bool> is_hard_step(const Plane& plane, int x, int y) {
    const Vec2 slope = gradient(plane, x, y);
    if (!(glm::length(slope) > 0.0f)) return std::nullopt;
    const Vec2 up     = glm::normalize(slope), from(static_cast<float>(x), static_cast<float>(y));
    const auto change = [&](float s) {
        const Vec2 before = from + up * (s - 0.5f), after = from + up * (s + 0.5f);
        return std::abs(sample(plane, after.x, after.y) - sample(plane, before.x, before.y));
    };
    // The step may lie to either side of the pixel's centre.
    const float place = change(-0.5f) > change(0.5f) ? -0.5f : 0.5f;
    const float here = change(place), beside = std::max(change(place - 2.0f), change(place + 2.0f));
    if (!std::isfinite(here) || !std::isfinite(change(place - 2.0f)) || !std::isfinite(change(place + 2.0f)))
        return std::nullopt;
    return here >= 0.05f && here > 3.0f * beside;
}

Metrics measure_cutouts(Studio& studio) {
    constexpr std::size_t kLeastEdges = 20;
    Metric share{"M1.cut_share",
                 "edges narrower than 2 px where the cloud meets the scene, in up to 5 frames",
                 "%",
                 {},
                 at_most(1.0)};
    Metric width{"M1.edge_width", "their median width, from 10 to 90 % of the drop", "px"};
    Metric hard{"M1.hard_steps",
                "pixels of such edges where a layer ends at once, in a step of 5 % or more",
                "%",
                {},
                at_most(1.0)};
    Edges edges;
    for (Studio& take : studio.takes()) {
        if (!take.has_cloud()) continue;
        take.edit().geometry.solids_in_front.clear();  // these hide the cloud and do not cut it
        append_edges(take, edges);
    }
    const auto percent = [](auto part, std::size_t all) {
        return 100.0 * static_cast<double>(part) / static_cast<double>(all);
    };
    const std::vector<double>& widths = edges.widths;
    if (widths.size() >= kLeastEdges) {
        share.value =
            percent(std::count_if(widths.begin(), widths.end(), [](double w) { return w < 2.0; }), widths.size());
        width.value = quantile(widths, 0.5);
    }
    if (edges.steps >= kLeastEdges) hard.value = percent(edges.hard_steps, edges.steps);
    return {share, width, hard};
}

}  // namespace demo
