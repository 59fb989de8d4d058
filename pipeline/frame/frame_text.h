// SPDX-License-Identifier: MIT
// The frame as text: the dump, the bug report and the language of tests. parse_frame(to_text(f)) == f for every frame.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/frame/frame.h"

namespace pipeline {

std::string to_text(const Frame& frame);

// what() is the reason alone; line and column count from 1.
struct ParseError : std::runtime_error {
    ParseError(int line_number, int column_number, const std::string& reason)
        : std::runtime_error(reason), line(line_number), column(column_number) {}
    int line, column;
};
Frame parse_frame(std::string_view text);

// One line for each field that differs, "passes[3].state.blend.dest: ONE -> ZERO"; empty if the frames are equal.
std::vector<std::string> diff(const Frame& before, const Frame& after);

}  // namespace pipeline
