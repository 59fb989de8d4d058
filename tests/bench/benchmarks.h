// SPDX-License-Identifier: MIT
// Registers everything that is timed with Google Benchmark, as `group/case/implementation`. Times are wall times of
// whole drawings: of nimbus7 an Executor that is kept, called with a frame, its copy of the picture out included; of
// the peers without any such copy.
#pragma once

#include <string>

namespace bench {

// threads: of the groups fill and triangles, in all implementations.
void register_benchmarks(int threads);

// In a child process: draws a frame a few times and prints the most memory the process ever had, in MiB, with all
// that it took to build the frame.
inline constexpr const char* kPeakMemoryArgument = "--peak-memory";
int print_peak_memory(const std::string& frame_case, int threads);

// image_peers.cpp: libyuv, pixman, and what memory itself allows.
void register_image_peers();

}  // namespace bench
