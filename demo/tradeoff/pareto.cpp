// SPDX-License-Identifier: MIT
#include "demo/tradeoff/pareto.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

namespace demo {

std::vector<std::size_t> pareto_front(std::span<const Cost> costs) {
    std::vector<std::size_t> order(costs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::tuple(costs[a].time, costs[a].error, a) < std::tuple(costs[b].time, costs[b].error, b);
    });
    std::vector<std::size_t> front;
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t i : order) {
        if (!(costs[i].error < least)) continue;
        least = costs[i].error;
        front.push_back(i);
    }
    return front;
}

}  // namespace demo
