// SPDX-License-Identifier: MIT
// nimbus7 plan: a scene's frame rewritten for a chip, what the chip still lacks, where all lies in its memory, what it costs.
#pragma once

#include <cstdint>

#include "demo/chip_frame.h"

namespace demo {

enum class PlanFormat : std::uint8_t { Text, Json };

struct PlanOptions : ChipFrameOptions {
    PlanFormat format = PlanFormat::Text;
    bool with_words   = false;  // of the chip, where it can draw the frame; in the text
};

// Prints the plan; then throws ChipCannot if the chip lacks something.
void report_plan(const PlanOptions& options);

}  // namespace demo
