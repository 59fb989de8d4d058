// SPDX-License-Identifier: MIT
// nimbus7 tradeoff: measures what a scene's knobs save and what they err; writes a directory of a table, a chart and a page,
// or prints what is on the front as Markdown.
#pragma once

#include <optional>
#include <string>

#include "demo/tradeoff/sweep.h"

namespace demo {

// One of directory and prints_table at least.
struct TradeoffOptions {
    std::string scene;
    std::optional<std::string> directory;
    bool prints_table = false;
    SweepOptions sweep;
};

void report_tradeoff(const TradeoffOptions& options);

}  // namespace demo
