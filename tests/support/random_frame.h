// SPDX-License-Identifier: MIT
// Small random frames: valid (pipeline/validate/validate.h), all states and formats of pipeline/frame, and most of them
// show something. One to three colour targets and up to two depth targets of 1..150 pixels each way, one to six passes.
// The same frame from a seed on every machine.
#pragma once

#include <cstdint>

#include "pipeline/frame/frame.h"

namespace test_support {

pipeline::Frame random_frame(std::uint32_t seed);

// Changes one field somewhere in the frame, so that it is no longer equal; it need not be valid any more.
void mutate_field(pipeline::Frame& frame, std::uint32_t seed);

}  // namespace test_support
