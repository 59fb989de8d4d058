// SPDX-License-Identifier: MIT
// All metrics of a scene, and how they are reported. Some ten seconds on one core at 480x270.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "demo/metrics/studio.h"

namespace demo {

struct MetricsReport {
    StudioOptions options;
    Metrics metrics;
};
MetricsReport scene_metrics(const Scene& scene, const StudioOptions& options);

// The metric of that key; it must be there.
const Metric& find_metric(const Metrics& metrics, const std::string& key);

// "0.42 px", "n.a." without a value.
std::string value_text(const Metric& metric);

// One line for each metric below a line of headings.
std::string to_table(const MetricsReport& report);

nlohmann::ordered_json to_json(const MetricsReport& report);

std::string name_of(Technique technique);

}  // namespace demo
