// SPDX-License-Identifier: MIT
// nimbus7 bench: becomes nimbus7_bench (tests/bench/), which is built beside this program together with the tests.
#pragma once

#include <string>
#include <vector>

namespace demo {

// Returns only by std::runtime_error, if it is not there.
[[noreturn]] void run_bench(std::vector<std::string> arguments);

}  // namespace demo
