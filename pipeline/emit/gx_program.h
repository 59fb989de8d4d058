// SPDX-License-Identifier: MIT
// What is the same in every GX program but for a few numbers: its head, which says how it is built, the functions that
// its passes call, and the way onto the display.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/emit/gx_data.h"

namespace pipeline {

struct GxArray {
    std::string_view name;  // POSITIONS, ...
    std::uint32_t offset = 0;
    bool is_there        = false;
};

// memory: bytes of copied targets.
struct GxProgramFacts {
    std::string_view data_file;
    std::vector<GxBlock> blocks;
    std::vector<GxArray> arrays;
    std::size_t data_bytes = 0, target_bytes = 0;
};

std::string gx_program_head(const GxProgramFacts& facts);
// Those that `callers` calls, and those that they call.
std::string gx_program_functions(std::string_view callers);
std::string_view gx_program_main();

}  // namespace pipeline
