// SPDX-License-Identifier: MIT
#include "demo/precision.h"

#include <utility>

namespace demo {

FrameOptions with_precision(FrameOptions options) {
    if (std::exchange(options.precision, Precision::Exact) == Precision::Exact) return options;
    options.mega_particles.skirt = false;
    return options;
}

}  // namespace demo
