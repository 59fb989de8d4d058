// SPDX-License-Identifier: MIT
#include "tests/bench/figures.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace bench {

namespace {

using Json = nlohmann::json;

constexpr std::string_view kPerSecond = "_per_second";

double seconds_per(const std::string& unit) {
    static const std::map<std::string, double> units{{"ns", 1e-9}, {"us", 1e-6}, {"ms", 1e-3}, {"s", 1.0}};
    const auto found = units.find(unit);
    if (found == units.end()) throw std::runtime_error("no unit of time: " + unit);
    return found->second;
}

Figure figure_of(const Json& run) {
    Figure figure;
    figure.name    = run.at("run_name").get<std::string>();
    figure.seconds = run.at("real_time").get<double>() * seconds_per(run.at("time_unit").get<std::string>());
    figure.size    = run.value("size", 0.0);
    for (const auto& [key, value] : run.items()) {
        if (!key.ends_with(kPerSecond)) continue;
        figure.unit = key.substr(0, key.size() - kPerSecond.size());
        figure.rate = value.get<double>();
    }
    return figure;
}

double median(std::vector<double> values) {
    const std::size_t middle = values.size() / 2;
    std::sort(values.begin(), values.end());
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2.0;
}

Figure median_of(const std::vector<Figure>& repetitions) {
    const auto median_by = [&](double Figure::*value) {
        std::vector<double> values;
        for (const Figure& each : repetitions) values.push_back(each.*value);
        return median(std::move(values));
    };
    Figure figure  = repetitions.front();
    figure.seconds = median_by(&Figure::seconds);
    figure.rate    = median_by(&Figure::rate);
    return figure;
}

}  // namespace

std::vector<Figure> read_figures(std::string_view json) try {
    std::vector<std::vector<Figure>> names;
    const Json document = Json::parse(json);
    for (const Json& run : document.at("benchmarks")) {
        // Of aggregates alone, which leave the repetitions out, the median is one.
        const bool counts = run.at("run_type") == "iteration" || run.at("aggregate_name") == "median";
        if (!counts || run.value("error_occurred", false)) continue;
        const Figure figure = figure_of(run);
        const auto known    = std::find_if(names.begin(), names.end(), [&](const std::vector<Figure>& repetitions) {
            return repetitions.front().name == figure.name;
        });
        if (known == names.end())
            names.push_back({figure});
        else if (run.at("run_type") == "iteration")
            known->push_back(figure);
    }
    std::vector<Figure> figures;
    for (const std::vector<Figure>& repetitions : names) figures.push_back(median_of(repetitions));
    return figures;
} catch (const Json::exception& error) {
    throw std::runtime_error(std::string("not the JSON of a benchmark: ") + error.what());
}

std::string format_time(double seconds) {
    struct Unit {
        double factor;
        const char* name;
    };
    constexpr std::array kUnits{Unit{1.0, "s"}, Unit{1e3, "ms"}, Unit{1e6, "µs"}, Unit{1e9, "ns"}};
    std::size_t i = 0;
    while (i + 1 < kUnits.size() && seconds * kUnits[i].factor < 0.9995) ++i;
    const double value = seconds * kUnits[i].factor;
    char text[64];
    std::snprintf(text, sizeof text, "%.*f %s", value < 9.995 ? 2 : value < 99.95 ? 1 : 0, value, kUnits[i].name);
    return text;
}

}  // namespace bench
