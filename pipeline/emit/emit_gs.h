// SPDX-License-Identifier: MIT
// A frame as what is written to the PlayStation 2's Graphics Synthesizer: complete from reset. Groups: registers that
// stay, uploads, targets that start at zero, then each pass. gs_text.h prints it, gs_dump.h packs it for an emulator.
// Exact against pipeline/execute, as the chip is modelled there, but for triangles whose texture has a size that is no
// power of two: their S and T count 2^TW and 2^TH texels and are rounded once more, so that a pixel can read 1/256 texel
// away. Not known of the chip, and assumed here: that transfers within the memory take any position and width; that a
// palette is read from memory when TEX0 is written with CLD 1. How it interpolates is not known; ps2's profile says what
// is modelled.
#pragma once

#include "pipeline/emit/gs_stream.h"
#include "pipeline/legalize/legalize.h"

namespace pipeline {

// Throws std::invalid_argument if something is left of `legal` that the chip lacks, or a value does not fit its registers.
GsStream emit_gs(const LegalFrame& legal);

}  // namespace pipeline
