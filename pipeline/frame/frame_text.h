// SPDX-License-Identifier: MIT
// The frame as text: the dump, the bug report and the language of tests. parse_frame(to_text(f)) is f, to the bit.
//   nimbus7 frame 1                                     the first line; // starts a comment
//   targets [ "cloud" { width 640 height 480 } ]        a list; a struct's name stands before its brace
//   blend { source SRCALPHA dest INVSRCALPHA }          fields in any order; one left out has its default value
//   color "cloud"   depth #2   camera none              an id: the name if it is the only one, a number, or nothing
//   0x80ffffff   (1 0.5 -2)   ((1 0 0 5) ...)           colour 0xAARRGGBB, vector, matrix (rows, as on paper)
//   triangles { ... }   rectangle { ... }               a draw
//   vertices columns (position uv0) [ (0 0 0) (0 1) ]   a long list of structs: rows of the fields named first
//   texels [00ff8001]   indices [0 1 2]                 bytes in hexadecimal, numbers
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
