// SPDX-License-Identifier: MIT
// Frames within the limits that a profile's table sets: its formats put in the place of others, and what is left that
// its chip does not have.
#pragma once

#include <string>

#include "pipeline/profile/profile.h"

namespace demo {

// The frame with the profile's arithmetic. Targets of A8R8G8B8 and X8R8G8B8 that the chip cannot draw to, or copy to if
// the frame only does that, become its own formats with and without alpha.
pipeline::Frame put_on_chip(pipeline::Frame frame, const pipeline::Profile& profile);

// The first thing in a frame that the chip does not have, as a sentence: "dx7 has no colour mask". Empty if it has all.
std::string what_is_missing(const pipeline::Frame& frame, const pipeline::Profile& profile);

}  // namespace demo
