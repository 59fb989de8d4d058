// SPDX-License-Identifier: MIT
// This program once more, as a process of its own with hidden arguments: what it measures there is not mixed with
// what this process has done. They talk in lines through its standard input and output.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <string>
#include <vector>

namespace bench {

class Child {
  public:
    // Errors are std::runtime_error, here and below.
    explicit Child(std::vector<std::string> arguments);
    ~Child();
    Child(const Child&)            = delete;
    Child& operator=(const Child&) = delete;

    std::string read_line();
    std::string ask();  // sends an empty line and reads the answer

  private:
    pid_t process_       = -1;
    std::FILE* requests_ = nullptr;
    std::FILE* answers_  = nullptr;
};

}  // namespace bench
