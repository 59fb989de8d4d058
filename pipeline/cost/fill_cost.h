// SPDX-License-Identifier: MIT
// The clocks of filling: pixel slots, samples and stages, and changes of page. The formulas stand at
// pipeline/cost/cost.h.
#pragma once

#include "pipeline/cost/pass_work.h"
#include "pipeline/cost/rates.h"

namespace pipeline {

// Pixels of the footprints that a draw's fragments take up.
Range pixel_slots(const DrawWork& draw, Footprint footprint);

// An amount by a rate; nothing where the rate is not known.
Range divided(const Range& amount, const Range& by_rate);
Range divided(const Range& amount, const Rate& by_rate);

Range fill_clocks(const PassWork& work, const PipelineState& state, const ChipRates& rates);

struct PageBreakCost {
    Range count, clocks;
};
PageBreakCost page_break_cost(const PassWork& work, const PageBreakRates& rates);

}  // namespace pipeline
