// SPDX-License-Identifier: MIT
// Figures as Markdown: ours beside those of each peer with the same threads, then those that have no peer.
#pragma once

#include <string>
#include <vector>

#include "tests/bench/figures.h"

namespace bench {

std::string to_table(const std::vector<Figure>& figures);

}  // namespace bench
