// SPDX-License-Identifier: MIT
// The passes of a rewritten frame in its chip's own words, to read: what `nimbus7 emit` writes, without vertices and indices.
#pragma once

#include <string>

#include "pipeline/legalize/legalize.h"

namespace demo {

// Of dx7 and gamecube the program; of ps2 and xbox, pass by pass, what is written to each register or method, each value once
// a pass. Nothing of a profile that is no chip.
std::string chip_words(const pipeline::LegalFrame& legal, const pipeline::Profile& profile);

}  // namespace demo
