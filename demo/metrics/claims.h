// SPDX-License-Identifier: MIT
// What the article (H. and W. Bahnassi, ShaderX5 5.3) claims for mega-particles, and against what it compares them,
// measured: a row for each claim, with the figures of all three techniques.
#pragma once

#include <string>

#include "demo/metrics/studio.h"

namespace demo {

// A Markdown table. Of the options, the technique does not matter.
std::string claims_table(const Scene& scene, StudioOptions options);

}  // namespace demo
