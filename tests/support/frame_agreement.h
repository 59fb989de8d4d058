// SPDX-License-Identifier: MIT
// Draws a frame and keeps all that can be seen of it, so that two drawings can be compared byte for byte and count for
// count, after every pass.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/execute/execute.h"

namespace test_support {

struct Drawn {
    pipeline::Execution execution;
    std::vector<pipeline::ColorImage> passes;  // the colour target after each pass
};

Drawn draw(pipeline::Executor& executor, const pipeline::Frame& frame, const pipeline::ExecuteOptions& options = {});

// By an executor of its own.
Drawn draw(const pipeline::Frame& frame, const pipeline::ExecuteOptions& options = {});

// By the scalar reference.
Drawn draw_reference(const pipeline::Frame& frame);

// The first thing that differs, or "".
std::string difference(const Drawn& got, const Drawn& want);

inline constexpr std::array<int, 4> kThreadCounts{1, 2, 3, 7};

// Draws with the kernels on every instruction set, with `runs` of the thread counts on each, in turn from `seed` on,
// and tiles shuffled by the seed, pass by pass and in groups of passes, with and without counts. Fails the test that calls it at the first drawing that differs.
void check_kernels(const pipeline::Frame& frame, const Drawn& want, std::uint32_t seed, std::size_t runs);

}  // namespace test_support
