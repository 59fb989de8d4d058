// SPDX-License-Identifier: MIT
// The families of metrics, M0 to M10. Each is one function that photographs a scene in the studio; what it computes
// from the pictures is in its own header, free of scenes. What a metric is, each says itself in words; one without
// anything to measure has no value. A new family is a function here, and a line in scene_metrics.cpp.
#pragma once

#include "demo/metrics/studio.h"

namespace demo {

Metrics measure_numerics(Studio& studio);      // M0
Metrics measure_cutouts(Studio& studio);       // M1
Metrics measure_depth(Studio& studio);         // M2
Metrics measure_climb(Studio& studio);         // M3
Metrics measure_kernel(Studio& studio);        // M4
Metrics measure_shimmer(Studio& studio);       // M5
Metrics measure_swim(Studio& studio);          // M6
Metrics measure_halo(Studio& studio);          // M7
Metrics measure_fill(Studio& studio);          // M8
Metrics measure_interference(Studio& studio);  // M9
Metrics measure_look(Studio& studio);          // M10

}  // namespace demo
