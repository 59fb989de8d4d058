// SPDX-License-Identifier: MIT
// What the passes of a frame did and how long they took, as a table for people and as JSON for programs.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "pipeline/execute/pass_counts.h"

namespace demo {

struct PassStatistics {
    std::string label;
    pipeline::PassCounts counts;
    double milliseconds = 0.0;
};

// One line for each pass below a line of headings, and a line of totals; ends with a newline.
std::string to_table(const std::vector<PassStatistics>& passes);

// An object with the counts by their names in PassCounts.
nlohmann::ordered_json to_json(const PassStatistics& pass);

}  // namespace demo
