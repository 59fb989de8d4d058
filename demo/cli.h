// SPDX-License-Identifier: MIT
// The command line: reads the arguments and runs one command. Usage and input errors are std::runtime_error, one line
// each.
#pragma once

namespace demo {

void run_command_line(int argc, const char* const* argv);

}  // namespace demo
