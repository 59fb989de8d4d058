// SPDX-License-Identifier: MIT
#include "demo/command_bench.h"

#include <unistd.h>

#include <filesystem>
#include <stdexcept>

namespace demo {

void run_bench(std::vector<std::string> arguments) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::path own_program = fs::read_symlink("/proc/self/exe", error);
    std::string program        = own_program.parent_path() / "nimbus7_bench";
    std::vector<char*> words{program.data()};
    for (std::string& argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    execv(program.c_str(), words.data());
    throw std::runtime_error("bench: there is no " + program +
                             ": it is built with the tests, where Google Benchmark is installed (libbenchmark-dev)");
}

}  // namespace demo
