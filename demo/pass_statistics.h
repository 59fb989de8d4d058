// SPDX-License-Identifier: MIT
// What the passes of a frame did and how long they took, as a table for people and as JSON for programs.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "pipeline/execute/execute.h"

namespace demo {

struct PassStatistics {
    std::string label;
    pipeline::PassCounts counts;
    pipeline::KernelUse kernels;
    double milliseconds = 0.0;
};

// One line for each pass below a line of headings, and a line of totals; ends with a newline. "general": covered pixels
// that had no kernel of their own.
std::string to_table(const std::vector<PassStatistics>& passes);

// An object with the counts by their names in PassCounts, and those of KernelUse.
nlohmann::ordered_json to_json(const PassStatistics& pass);

}  // namespace demo
