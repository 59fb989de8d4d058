// SPDX-License-Identifier: MIT
#include "tests/bench/options.h"

#include <charconv>

namespace bench {

namespace {

int parse_threads(const std::string& text) {
    int value       = 0;
    const char* end = text.data() + text.size();
    if (std::from_chars(text.data(), end, value).ptr != end || value < 1 || value > 1024)
        throw std::runtime_error("--threads " + text + ": expected a number from 1 to 1024");
    return value;
}

}  // namespace

Options parse_options(const std::vector<std::string>& words) {
    Options options;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        const auto value        = [&]() -> const std::string& {
            if (i + 1 == words.size()) throw std::runtime_error(word + " needs a value");
            return words[++i];
        };
        if (word == "--threads")
            options.threads = parse_threads(value());
        else if (word == "--simd")
            options.simd = value();
        else if (word == "--json")
            options.json = value();
        else if (word == "--plot")
            options.plot = value();
        else if (word == "--from")
            options.from = value();
        else if (word == "--table")
            options.prints_table = true;
        else if (word == "--help" || word == "-h")
            options.prints_help = true;
        else if (word.starts_with("--benchmark_") || word.starts_with("--v="))
            options.benchmark_arguments.push_back(word);
        else
            throw std::runtime_error(word + ": no such option (see nimbus7_bench --help)");
    }
    if (options.from && !options.plot) options.prints_table = true;
    return options;
}

}  // namespace bench
