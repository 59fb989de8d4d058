// SPDX-License-Identifier: MIT
// Does what emit_nv2a writes say what the frame says? All clears, draws and copies in their order, the state of each as decoded by
// tests/support/nv2a_state.h, combiners on random registers against the stages' formulas in real numbers, texels, and of draws with
// many vertices some.
#pragma once

#include <string>
#include <vector>

#include "pipeline/emit/emitted.h"
#include "pipeline/frame/frame.h"

namespace test_support {

// One line for each thing that differs, at most 20; empty if nothing does.
std::vector<std::string> nv2a_differences(const pipeline::Frame& frame, const pipeline::Emitted& emitted);

}  // namespace test_support
