// SPDX-License-Identifier: MIT
// Files that appear whole or not at all: each is made under another name in the same directory and renamed at the end,
// so a failure, a full disk or Ctrl-C leaves an older file as it was and nothing else behind. In the main thread alone.
// Errors are std::runtime_error with the path and the reason.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace demo {

// Throws if a file at `path` could not be made or replaced, as far as can be told without making it.
void check_output(const std::string& path);

// What lies in /dev and pipes are written to as they are.
void write_file(const std::string& path, std::string_view bytes);

// Files that belong together, of which none is renamed before all are written: kMaxFilesTogether at most.
struct FileToWrite {
    std::string path;
    std::string_view bytes;
};
inline constexpr std::size_t kMaxFilesTogether = 2;
void write_files(std::span<const FileToWrite> files);

// To be called once, in the main thread: from now on SIGINT, SIGTERM, SIGHUP and SIGPIPE remove files that are not
// finished and end the program with status 128 + signal, as shells do; a file that outgrows its limit is an error like
// a full disk.
void clean_up_on_signals();

}  // namespace demo
