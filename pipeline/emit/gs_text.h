// SPDX-License-Identifier: MIT
// A stream for reading: each register with its address, its name, its value and what its fields mean, by pass and draw. A line
// is "4c FRAME_1 00000000000a0000: FBP byte 0 (colour), FBW 640 px (row), ...".
#pragma once

#include <string>

#include "pipeline/emit/gs_stream.h"

namespace pipeline {

std::string gs_text(const GsStream& stream);

// One line of it, without its end.
std::string gs_text(const GsWrite& write);

}  // namespace pipeline
