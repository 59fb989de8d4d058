// SPDX-License-Identifier: MIT
// What is written to the Graphics Synthesizer for one frame, in order: registers by A+D, and images by HWREG.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/emit/gs_registers.h"

namespace pipeline {

struct GsWrite {
    GsReg reg                             = GsReg::Prim;
    std::uint64_t value                   = 0;
    bool operator==(const GsWrite&) const = default;
};

// what: "rectangle 0", "texture 1 'rock'". image: what follows the writes through HWREG, if anything; their last is then
// TRXDIR, host to local. Its bytes are whole quadwords.
struct GsStep {
    std::string what;
    std::vector<GsWrite> writes;
    std::vector<std::uint8_t> image;
};

// label: "pass 3 'composite'", or what comes before the passes.
struct GsGroup {
    std::string label;
    std::vector<GsStep> steps;
};

// display: registers that the CPU writes, so that the output is shown.
struct GsStream {
    std::vector<GsGroup> groups;
    std::vector<GsWrite> display;
};

}  // namespace pipeline
