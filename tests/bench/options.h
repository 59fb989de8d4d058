// SPDX-License-Identifier: MIT
// The command line of nimbus7_bench. What is not listed here is Google Benchmark's own, such as
// --benchmark_filter=frame/.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace bench {

struct Options {
    int threads = 1;                  // of fill and triangles
    std::string simd;                 // the instruction set; "": the best
    std::optional<std::string> json;  // file to write
    std::optional<std::string> plot;  // file to write
    std::optional<std::string> from;  // figures of an earlier run, in place of a run
    bool prints_table = false;
    bool prints_help  = false;
    std::vector<std::string> benchmark_arguments;
};

// Throws std::runtime_error.
Options parse_options(const std::vector<std::string>& words);

inline constexpr const char* kHelp = R"(nimbus7_bench [OPTION...]
Times nimbus7 beside Mesa's llvmpipe, libyuv and pixman, in one run.
  --threads N        threads of the groups fill and triangles (default 1)
  --simd TARGET      the instruction set that nimbus7 draws with
  --json FILE        write the figures
  --table            print them as a Markdown table of ratios; the run itself is reported on standard error
  --plot FILE.svg    draw the growth series
  --from FILE.json   take the figures of an earlier run for --table and --plot, and time nothing
Others are Google Benchmark's:
  --benchmark_filter=REGEX  --benchmark_list_tests=true  --benchmark_repetitions=N  --benchmark_min_time=SECONDS
  --benchmark_enable_random_interleaving=true
)";

}  // namespace bench
