// SPDX-License-Identifier: MIT
// The growth series as an SVG picture: time against pixels, spheres, clouds and threads, a panel each, logarithmic on
// both axes and with one axis of time for all. A dashed line through a series' first point shows what grows in
// proportion, or for threads what falls so.
#pragma once

#include <string>
#include <vector>

#include "tests/bench/figures.h"

namespace bench {

// Throws std::runtime_error if no figure is of a growth series.
std::string to_plot(const std::vector<Figure>& figures);

}  // namespace bench
