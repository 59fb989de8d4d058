// SPDX-License-Identifier: MIT
#include "tests/bench/llvmpipe_child.h"

#include <stdexcept>
#include <string_view>

namespace bench {

LlvmpipeChild::LlvmpipeChild(const std::string& frame_case, int threads)
    : child_({kLlvmpipeArgument, frame_case, std::to_string(threads)}) {
    constexpr std::string_view kReady = "ready ";
    const std::string line            = child_.read_line();
    if (!line.starts_with(kReady)) throw std::runtime_error(line);
    description_ = line.substr(kReady.size());
}

double LlvmpipeChild::draw() {
    return std::stod(child_.ask());
}

}  // namespace bench
