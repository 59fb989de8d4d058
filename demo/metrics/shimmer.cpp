// SPDX-License-Identifier: MIT
#include "demo/metrics/shimmer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "demo/metrics/measures.h"
#include "demo/metrics/statistics.h"
#include "demo/trigonometry.h"

namespace demo {
namespace {

// Over all whole-pixel steps along the diagonal, of one cell of the blur's coarsest level.
double worst_shift(Studio& studio, FrameOptions options, const Plane& still) {
    const int cell = std::clamp(1 << studio.anatomy().levels, 2, 16);
    const Mask rim = rim_of(still);
    double worst   = 0.0;
    for (int shift = 1; shift < cell; ++shift) {
        options.shift_px = Vec2(static_cast<float>(shift));
        worst = std::max(worst, rms(differences_unmoved(still, studio.coverage(options), shift, shift, rim)));
    }
    return 255.0 * worst;
}

// From views of the cloud by itself, 1.5 degrees apart, from 30 to 60 degrees about the vertical: a technique that
// draws along an axis of the world changes to another between.
double worst_over_median_step(Studio& studio) {
    const Vec3 eye = studio.eye(), target = studio.target(), middle = studio.cloud_middle();
    const Vec3 away    = eye - middle;
    const double reach = std::hypot(static_cast<double>(away.x), static_cast<double>(away.z));
    std::vector<double> changes;
    Plane before;
    for (double degrees = 30.0; degrees <= 60.0; degrees += 1.5) {
        const double angle = radians(degrees);
        studio.look_from(middle + Vec3(static_cast<float>(reach * std::sin(angle)), away.y,
                                       static_cast<float>(reach * std::cos(angle))),
                         middle);
        Plane now = studio.coverage(studio.shot(), remove_scene);
        if (before.width > 0) changes.push_back(rms(differences_unmoved(before, now, 0, 0, rim_of(before))));
        before = std::move(now);
    }
    studio.look_from(eye, target);
    const double median = quantile(changes, 0.5);
    return median > 0.0 ? quantile(changes, 1.0) / median : 1.0;
}

}  // namespace

std::vector<double> differences_unmoved(const Plane& plane, const Plane& moved, int x, int y, const Mask& where) {
    std::vector<double> differences;
    for (int py = 0; py < plane.height; ++py)
        for (int px = 0; px < plane.width; ++px)
            if (where.at(px, py) != 0 && moved.has(px + x, py + y))
                differences.push_back(static_cast<double>(moved.at(px + x, py + y) - plane.at(px, py)));
    return differences;
}

Metrics measure_shimmer(Studio& studio) {
    Metric plain{"M5.shimmer",
                 "change of the rim without fractal, moved by whole pixels (RMS, worst step)",
                 "/255",
                 {},
                 at_most(1.0)};
    Metric detailed{"M5.shimmer_detailed", "the same with the fractal", "/255", {}, at_most(1.0)};
    Metric jump{"M5.orbit_jump",
                "change of the rim from one view of an orbit to the next, worst over median",
                "",
                {},
                at_most(2.0)};
    Metric crawl{"M5.crawl", "change of the rim from an eighth of a pixel to the next (RMS, worst step)", "/255"};
    if (studio.has_cloud()) {
        FrameOptions options = studio.shot();
        detailed.value       = worst_shift(studio, options, studio.plain_coverage());
        options.has_detail   = false;
        plain.value          = worst_shift(studio, options, studio.detailless_coverage());

        options        = studio.shot();
        Plane before   = studio.plain_coverage();
        const Mask rim = rim_of(before);
        double worst   = 0.0;
        for (int eighth = 1; eighth <= 8; ++eighth) {
            options.shift_px = Vec2(static_cast<float>(eighth) / 8.0f);
            Plane after      = studio.coverage(options);
            worst            = std::max(worst, rms(differences_unmoved(before, after, 0, 0, rim)));
            before           = std::move(after);
        }
        crawl.value = 255.0 * worst;
        jump.value  = worst_over_median_step(studio);
    }
    return {plain, detailed, crawl, jump};
}

}  // namespace demo
