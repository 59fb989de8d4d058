// SPDX-License-Identifier: MIT
#include "demo/metrics/depth_match.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "demo/metrics/measures.h"
#include "demo/metrics/statistics.h"

namespace demo {

Mask away_from_edges(const Plane& shape, double clear_px) {
    const Plane distance = nearest_marked(edges_of(shape, 0.02f)).distance;
    Mask away(shape.width, shape.height);
    for (std::size_t i = 0; i < away.values.size(); ++i)
        away.values[i] = static_cast<double>(distance.values[i]) > clear_px &&
                         (shape.values[i] > 0.0f || static_cast<double>(distance.values[i]) < 4.0 * clear_px);
    return away;
}

double mean_difference(const Plane& coverage, const Plane& shape, const Mask& where) {
    std::vector<double> differences;
    for (std::size_t i = 0; i < coverage.values.size(); ++i)
        if (where.values[i] != 0)
            differences.push_back(std::abs(static_cast<double>(coverage.values[i] - shape.values[i])));
    return mean(differences);
}

Metrics measure_depth(Studio& studio) {
    Metric plain{"M2.error",
                 "coverage against the spheres' own, beyond 3 sigma from their edges, without fractal",
                 "/255",
                 {},
                 at_most(1.0)};
    Metric outside{"M2.error_outside", "the same with the fractal, where no sphere is", "/255", {}, at_most(1.0)};
    const Anatomy& anatomy = studio.anatomy();
    // A cloud that is translucent as a whole has no silhouette to compare with; nor does one that dissolves.
    const bool comparable  = std::all_of(studio.clouds().begin(), studio.clouds().end(), [](const SceneCloud& cloud) {
        return cloud.baked.cloud.opacity == 1.0f && cloud.baked.cloud.dissolve == 0.0f;
    });
    if (studio.has_cloud() && comparable) {
        Mask away   = away_from_edges(anatomy.shape, 3.0 * anatomy.sigma_px);
        plain.value = 255.0 * mean_difference(studio.detailless_coverage(), anatomy.shape, away);
        for (std::size_t i = 0; i < away.values.size(); ++i)
            if (anatomy.shape.values[i] > 0.0f) away.values[i] = 0;
        outside.value = 255.0 * mean_difference(studio.plain_coverage(), anatomy.shape, away);
    }
    return {plain, outside};
}

}  // namespace demo
