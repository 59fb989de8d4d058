// SPDX-License-Identifier: MIT
// Runs a program to its end, in a directory of its own, and returns what it wrote.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tests {

// A fresh directory, removed with all that is in it at the end.
class ScratchDirectory {
  public:
    ScratchDirectory();
    ~ScratchDirectory();
    ScratchDirectory(const ScratchDirectory&)            = delete;
    ScratchDirectory& operator=(const ScratchDirectory&) = delete;

    const std::string& path() const { return path_; }
    std::string operator/(const std::string& name) const { return path_ + "/" + name; }
    std::vector<std::string> files() const;  // names, sorted, hidden ones too

  private:
    std::string path_;
};

std::string read_file(const std::string& path);
void write_file(const std::string& path, const std::string& text);

struct Ended {
    int status;  // exit status; 128 + signal if one ended it
    std::string out, error;
};

// In the midst of making a file, by the main thread: the file is there and empty, or is whole and not in its place yet.
enum class Midst : std::uint8_t { Never, Made, Written };

struct RunOptions {
    std::int64_t max_file_bytes = 0;             // of each file it writes; 0: no limit
    int interrupt_after_ms      = 0;             // sends SIGINT then; 0: never
    Midst interrupt_in_midst    = Midst::Never;  // sends SIGINT then, of the first file
    bool has_full_output        = false;         // standard output is /dev/full
};

Ended run_program(const std::string& program, const std::vector<std::string>& arguments, const std::string& directory,
                  const RunOptions& options = {});

}  // namespace tests
