// SPDX-License-Identifier: MIT
// Draws a frame: a pure function of it, the same bytes on every machine, whatever the options. The only user of
// raster/.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "pipeline/execute/pass_counts.h"
#include "pipeline/frame/frame.h"

namespace pipeline {

// A colour target's pixels: 0xAARRGGBB, rows from the top, no padding.
struct ColorImage {
    int width = 0, height = 0;
    std::vector<std::uint32_t> pixels;
    bool operator==(const ColorImage&) const = default;
};

// Which fill loops a pass went through, in covered pixels: one compiled for the pass's very state, or the slower one for
// all states. All 0 with the Reference.
struct KernelUse {
    std::uint64_t special = 0, general = 0;
};

// Called after each pass, in order, with which passes are drawn one by one, and somewhat slower; `read_color` copies
// the pass's colour target (an empty image if it has none).
struct FinishedPass {
    std::size_t index;
    const Pass& pass;
    const PassCounts& counts;
    const KernelUse& kernels;
    std::function<ColorImage()> read_color;
};
using PassObserver = std::function<void(const FinishedPass&)>;

// Kernels are the SIMD fill loops; Reference is the scalar oracle they are tested against.
enum class Backend : std::uint8_t { Kernels, Reference };

struct ExecuteOptions {
    Backend backend               = Backend::Kernels;
    int threads                   = 0;     // 0: all cores
    std::uint32_t tile_order_seed = 0;     // not 0: tiles are taken in shuffled order, for tests
    bool counts_fragments         = true;  // false: what Execution says of fragments stays 0, and hidden ones cost less
    bool counts_only = false;  // the output stays empty, and no colour is made where no test of the frame reads alpha
};

struct Execution {
    ColorImage output;  // Frame::output
    // One for each pass.
    std::vector<PassCounts> counts;
    std::vector<KernelUse> kernels;
};

// Draws frames one after the other and keeps the memory that one took for the next. Not for use by two threads at once.
class Executor {
  public:
    Executor();
    ~Executor();

    // The frame must be valid (pipeline/validate/validate.h); throws std::invalid_argument with the first finding if it
    // is not.
    Execution execute(const Frame& frame, const ExecuteOptions& options = {}, const PassObserver& observer = {});

    // The same in place of what `out` holds, whose memory is used again.
    void execute(const Frame& frame, Execution& out, const ExecuteOptions& options = {},
                 const PassObserver& observer = {});

  private:
    std::unique_ptr<struct ExecutorMemory> memory_;
};

// One frame by itself.
Execution execute(const Frame& frame, const ExecuteOptions& options = {}, const PassObserver& observer = {});

// The instruction sets compiled in that this machine has, best first, by Highway's name (AVX3, AVX2, SSE4, ...); and
// the choice of one for all later fills, or of the best again with "". Throws std::invalid_argument for an unknown
// name.
std::vector<std::string> simd_targets();
void force_simd_target(const std::string& name);

}  // namespace pipeline
