// SPDX-License-Identifier: MIT
// Does a draw of the NV2A do what the frame's draw says: state of pixels, combiners on random registers against the stages' formulas
// in real numbers, texels, and of draws with many vertices some.
#pragma once

#include "tests/support/nv2a_comparison.h"

namespace test_support {

void compare_draw(Nv2aComparison& compare, const Nv2aEvent& event, const pipeline::Pass& pass,
                  const pipeline::Draw& draw);

}  // namespace test_support
