// SPDX-License-Identifier: MIT
// What the text form of a frame may say, for who reads one with another program: every field of every struct, the value that
// it has when it is left out, and the names that an enumerator may have. What they mean stands in the headers of
// pipeline/frame/.
#pragma once

#include <string>

namespace pipeline {

std::string describe_fields();

}  // namespace pipeline
