// SPDX-License-Identifier: MIT
// nimbus7 metrics: measures a scene's clouds and reports on standard output. A missed target is a figure, not an error.
#pragma once

#include <cstdint>
#include <string>

#include "demo/scene.h"

namespace demo {

enum class MetricsFormat : std::uint8_t { Text, Json, Claims };

// Claims: all three techniques, as a Markdown table by what the article claims.
struct MetricsOptions {
    std::string scene;
    Size size            = {480, 270};
    int frame            = 0;
    Technique technique  = Technique::MegaParticles;
    Precision precision  = Precision::Exact;
    MetricsFormat format = MetricsFormat::Text;
};

void report_metrics(const MetricsOptions& options);

}  // namespace demo
