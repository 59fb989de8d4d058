// SPDX-License-Identifier: MIT
// nimbus7 emit: a scene's frame in a chip's own words, complete: replayed from reset, with nothing else, it makes the frame.
#pragma once

#include <optional>
#include <string>

#include "demo/chip_frame.h"

namespace demo {

// output: else the scene's name with the chip's ending. What the file itself does not hold goes beside it, with .bin in place
// of its ending. as_text: of ps2, the registers as a list to read in place of a dump.
struct EmitOptions : ChipFrameOptions {
    std::optional<std::string> output;
    bool as_text = false;
};

// Throws ChipCannot if the chip lacks something.
void emit(const EmitOptions& options);

}  // namespace demo
