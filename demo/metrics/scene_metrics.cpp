// SPDX-License-Identifier: MIT
#include "demo/metrics/scene_metrics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "demo/metrics/measures.h"

namespace demo {
namespace {

// In the order of the report.
constexpr std::array kFamilies{&measure_numerics, &measure_cutouts,      &measure_depth, &measure_climb,
                               &measure_kernel,   &measure_shimmer,      &measure_swim,  &measure_halo,
                               &measure_fill,     &measure_interference, &measure_look};

// Four digits, without an exponent.
std::string number_text(double value) {
    const double size = std::abs(value);
    char text[64];
    std::snprintf(text, sizeof text, "%.*f",
                  size >= 1000.0 || value == std::round(value) ? 0
                  : size >= 10.0                               ? 1
                  : size >= 0.1                                ? 2
                                                               : 4,
                  value);
    return text;
}

std::string target_text(const Metric& metric) {
    if (!metric.target) return "";
    const auto [low, high] = *metric.target;
    if (low == high) return number_text(low);
    if (std::isinf(low)) return "<= " + number_text(high);
    if (std::isinf(high)) return ">= " + number_text(low);
    return number_text(low) + " to " + number_text(high);
}

const char* verdict_text(const Metric& metric) {
    switch (metric.verdict()) {
        case Verdict::Ok:
            return "ok";
        case Verdict::Missed:
            return "missed";
        case Verdict::NoTarget:
            return "";
        case Verdict::NotApplicable:
            return "n.a.";
    }
    return "";
}

}  // namespace

MetricsReport scene_metrics(const Scene& scene, const StudioOptions& options) {
    Studio studio(scene, options);
    MetricsReport report{.options = options, .metrics = {}};
    for (const auto family : kFamilies)
        for (Metric& metric : family(studio)) report.metrics.push_back(std::move(metric));
    return report;
}

const Metric& find_metric(const Metrics& metrics, const std::string& key) {
    const auto found = std::find_if(metrics.begin(), metrics.end(), [&](const Metric& m) { return m.key == key; });
    if (found == metrics.end()) throw std::logic_error(key + ": no such metric");
    return *found;
}

std::string value_text(const Metric& metric) {
    if (!metric.value) return "n.a.";
    const std::string number = number_text(*metric.value);
    const bool is_joined     = metric.unit.empty() || metric.unit.front() == '/';
    return number + (is_joined ? "" : " ") + metric.unit;
}

std::string to_table(const MetricsReport& report) {
    using Row = std::array<std::string, 5>;
    std::vector<Row> rows{{"metric", "value", "target", "", "what it is"}};
    for (const Metric& metric : report.metrics)
        rows.push_back({metric.key, metric.value ? value_text(metric) : "", target_text(metric), verdict_text(metric),
                        metric.what});
    std::array<std::size_t, 5> widths{};
    for (const Row& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    std::string table;
    for (const Row& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string space(widths[i] - row[i].size(), ' ');
            const bool is_last = i + 1 == row.size();
            table += i == 1 ? space + row[i] + "  " : row[i] + (is_last ? "" : space + "  ");
        }
        table += '\n';
    }
    return table;
}

nlohmann::ordered_json to_json(const MetricsReport& report) {
    nlohmann::ordered_json object;
    object["technique"] = name_of(report.options.technique);
    object["width"]     = report.options.size.width;
    object["height"]    = report.options.size.height;
    object["frame"]     = report.options.frame;
    object["metrics"]   = nlohmann::ordered_json::array();
    for (const Metric& metric : report.metrics) {
        nlohmann::ordered_json entry{{"metric", metric.key}, {"what", metric.what}, {"unit", metric.unit}};
        if (metric.value)
            entry["value"] = *metric.value;
        else
            entry["value"] = nullptr;
        if (metric.target && !std::isinf(metric.target->low)) entry["least"] = metric.target->low;
        if (metric.target && !std::isinf(metric.target->high)) entry["most"] = metric.target->high;
        entry["verdict"] = verdict_text(metric);
        object["metrics"].push_back(std::move(entry));
    }
    return object;
}

std::string name_of(Technique technique) {
    switch (technique) {
        case Technique::MegaParticles:
            return "mega";
        case Technique::Sprites:
            return "sprites";
        case Technique::Slices:
            return "slices";
    }
    return "";
}

}  // namespace demo
