// SPDX-License-Identifier: MIT
// Does a GX program do what its frame says? Its calls, as tests/support/gx_log.h reads them, are followed pass by pass: places
// in the frame buffer, masks, blending, tests, the TEV by its formula in real numbers on random inputs, textures untiled,
// coordinates, colours, fog, and where vertices go. Nothing of pipeline/emit is used.
#pragma once

#include <vector>

#include "pipeline/frame/frame.h"
#include "tests/support/gx_log.h"

namespace test_support {

// Catch's checks. step: only every step-th vertex of a draw is looked at.
void check_gx(const pipeline::Frame& frame, const std::vector<GxEvent>& events, const std::vector<std::uint8_t>& data,
              std::size_t step = 1);

}  // namespace test_support
