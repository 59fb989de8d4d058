// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pipeline {

// What is written for one chip: the program or register list as text, and the bytes it reads from a file beside it, empty
// if none.
struct Emitted {
    std::string text;
    std::vector<std::uint8_t> data;
};

}  // namespace pipeline
