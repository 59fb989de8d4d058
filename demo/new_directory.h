// SPDX-License-Identifier: MIT
// A directory of a few files that appears whole or not at all: it is made under another name beside its place, and takes
// that place in one step, so that a failure leaves an older one as it was and nothing else behind. In the main thread.
// Errors are std::runtime_error with the path and the reason.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace demo {

// Names without directories, and the files' bytes.
using NamedFiles = std::vector<std::pair<std::string, std::string>>;

// Throws if a directory at `path` with files of these names could not be made or replaced, as far as can be told without
// making it. An older directory is replaced only if it holds nothing else.
void check_new_directory(const std::string& path, const std::vector<std::string>& names);

// Signals wait until it is done.
void write_directory(const std::string& path, const NamedFiles& files);

}  // namespace demo
