// SPDX-License-Identifier: MIT
// What FrameOptions::precision stands for.
#pragma once

#include "demo/scene.h"

namespace demo {

// The same with Precision::Exact, and with the settings of the technique that a Precision::Fast means.
FrameOptions with_precision(FrameOptions options);

}  // namespace demo
