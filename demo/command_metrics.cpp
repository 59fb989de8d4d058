// SPDX-License-Identifier: MIT
#include "demo/command_metrics.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "demo/metrics/claims.h"
#include "demo/metrics/scene_metrics.h"
#include "demo/standard_output.h"

namespace demo {
namespace {

// Rims of a few pixels have no shape.
constexpr int kLeastSize = 64;

}  // namespace

void report_metrics(const MetricsOptions& options) {
    if (options.size.width < kLeastSize || options.size.height < kLeastSize)
        throw std::runtime_error("--size: metrics need at least " + std::to_string(kLeastSize) + " pixels each way");
    const ScenePtr scene = load_scene(options.scene);
    const StudioOptions studio{
        .size = options.size, .frame = options.frame, .technique = options.technique, .precision = options.precision};
    if (options.format == MetricsFormat::Claims) return print(claims_table(*scene, studio));
    const MetricsReport report = scene_metrics(*scene, studio);
    if (options.format == MetricsFormat::Text) return print(to_table(report));
    nlohmann::ordered_json object{{"scene", options.scene}};
    object.update(to_json(report));
    print(object.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

}  // namespace demo
