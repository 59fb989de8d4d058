// SPDX-License-Identifier: MIT
// Draws a frame in all ways, which must not differ.
#pragma once

#include <cstdint>

#include "pipeline/frame/frame.h"

namespace fuzz {

// Returns false for a frame that is not valid or takes too long. Stops where the kernels of an instruction set, pass by
// pass or in groups of passes, with a number of threads and an order of tiles that follow from the seed, differ from the
// scalar reference.
bool require_agreement(const pipeline::Frame& frame, std::uint32_t seed);

}  // namespace fuzz
