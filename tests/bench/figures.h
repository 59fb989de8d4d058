// SPDX-License-Identifier: MIT
// What was measured, as read back from Google Benchmark's JSON: one figure for each name, the median of its
// repetitions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bench {

struct Figure {
    std::string name;  // "group/case/implementation"
    double seconds = 0.0;
    double rate    = 0.0;  // per second, of `unit`; 0 if there is none
    std::string unit;      // "pixels", "triangles"
    double size = 0.0;     // of growth/*: how many of what grows
};

// In the order in which they ran; without those that were skipped. Throws std::runtime_error if it is no such text.
std::vector<Figure> read_figures(std::string_view json);

// "57.7 ms": three digits that count, in the unit that suits.
std::string format_time(double seconds);

}  // namespace bench
