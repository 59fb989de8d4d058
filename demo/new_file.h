// SPDX-License-Identifier: MIT
// A file that appears whole or not at all: it is made under another name in the same directory and renamed at the end,
// so a failure, a full disk or Ctrl-C leaves an older file as it was and nothing else behind. One at a time, in the
// main thread. Errors are std::runtime_error with the path and the reason.
#pragma once

#include <string>
#include <string_view>

namespace demo {

// Throws if a file at `path` could not be made or replaced, as far as can be told without making it.
void check_output(const std::string& path);

// What lies in /dev and pipes are written to as they are.
void write_file(const std::string& path, std::string_view bytes);

// To be called once, in the main thread: from now on SIGINT, SIGTERM, SIGHUP and SIGPIPE remove an unfinished NewFile
// and end the program with status 128 + signal, as shells do; a file that outgrows its limit is an error like a full
// disk.
void clean_up_on_signals();

}  // namespace demo
