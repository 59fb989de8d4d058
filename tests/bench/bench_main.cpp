// SPDX-License-Identifier: MIT
// nimbus7_bench: parse, run, report. Exit status 1 if nothing ran, 2 for bad input.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <thread>

#include "demo/new_file.h"
#include "demo/standard_output.h"
#include "pipeline/execute/execute.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/llvmpipe_child.h"
#include "tests/bench/options.h"
#include "tests/bench/plot.h"
#include "tests/bench/reporter.h"
#include "tests/bench/table.h"

namespace bench {
namespace {

std::string read_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    if (!file || !(text << file.rdbuf())) throw std::runtime_error(path + ": cannot be read");
    return text.str();
}

std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown";
}

std::string peer() {
    try {
        return LlvmpipeChild("", 1).description();
    } catch (const std::runtime_error& error) {
        return std::string("none: ") + error.what();
    }
}

void add_context(const Options& options) {
    benchmark::AddCustomContext("processor", processor());
    benchmark::AddCustomContext("cores", std::to_string(std::thread::hardware_concurrency()));
    benchmark::AddCustomContext("simd", options.simd.empty() ? pipeline::simd_targets().front() : options.simd);
    benchmark::AddCustomContext("threads of fill and triangles", std::to_string(options.threads));
    benchmark::AddCustomContext("llvmpipe", peer());
}

// Returns the figures as JSON.
std::string run_benchmarks(const Options& options) {
    pipeline::force_simd_target(options.simd);
    register_benchmarks(options.threads);
    // Google Benchmark takes the last of two.
    std::vector<std::string> arguments{"nimbus7_bench", "--benchmark_min_time=0.2"};
    arguments.insert(arguments.end(), options.benchmark_arguments.begin(), options.benchmark_arguments.end());
    std::vector<char*> words;
    for (std::string& argument : arguments) words.push_back(argument.data());
    int count = static_cast<int>(words.size());
    benchmark::Initialize(&count, words.data());
    if (count > 1) throw std::runtime_error(std::string(words[1]) + ": no such option");

    add_context(options);
    // A table is all that standard output then has.
    Reporter reporter(options.prints_table ? std::cerr : std::cout);
    if (benchmark::RunSpecifiedBenchmarks(&reporter) == 0) return {};
    return reporter.json();
}

int run(const Options& options) {
    if (options.prints_help) {
        demo::print(kHelp);
        return 0;
    }
    // What cannot be written is found before minutes of measuring.
    for (const std::optional<std::string>& output : {options.json, options.plot})
        if (output && !output->starts_with("/dev/")) demo::check_output(*output);
    const std::string json = options.from ? read_file(*options.from) : run_benchmarks(options);
    if (json.empty()) return 1;
    if (options.json) demo::write_file(*options.json, json);
    if (!options.prints_table && !options.plot) return 0;
    const std::vector<Figure> figures = read_figures(json);
    if (options.prints_table) demo::print(to_table(figures));
    if (options.plot) demo::write_file(*options.plot, to_plot(figures));
    return 0;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    try {
        if (words.size() == 3 && words[0] == bench::kLlvmpipeArgument)
            return bench::serve_llvmpipe(words[1], std::stoi(words[2]));
        if (words.size() == 3 && words[0] == bench::kPeakMemoryArgument)
            return bench::print_peak_memory(words[1], std::stoi(words[2]));
        demo::clean_up_on_signals();
        return bench::run(bench::parse_options(words));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "nimbus7_bench: %s\n", error.what());
        return 2;
    }
}
