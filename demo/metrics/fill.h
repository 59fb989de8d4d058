// SPDX-License-Identifier: MIT
// M8: what a cloud costs, counted.
#pragma once

#include "pipeline/execute/execute.h"
#include "pipeline/frame/frame.h"

namespace demo {

// Sums over the passes that draw clouds. depth_passed: of passes that test depth only.
pipeline::PassCounts cloud_counts(const pipeline::Frame& frame, const pipeline::Execution& execution);

// The same triangles in the opposite order.
void reverse_triangles(pipeline::Frame& frame, const pipeline::Pass& pass);

}  // namespace demo
