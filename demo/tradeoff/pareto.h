// SPDX-License-Identifier: MIT
// The Pareto front of two figures that should both be small.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace demo {

struct Cost {
    double time = 0.0, error = 0.0;
};

// The indices of those that no other beats, being at most as slow and at most as wrong, and better in one of them; the fastest
// first. Of equals the first alone.
std::vector<std::size_t> pareto_front(std::span<const Cost> costs);

}  // namespace demo
