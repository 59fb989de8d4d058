// SPDX-License-Identifier: MIT
// What OpenGL 1.x has no state for. The executors are compared on all other frames; one that cannot be expressed is
// reported as skipped, with the reason.
#pragma once

#include <optional>
#include <string>

#include "pipeline/frame/frame.h"

namespace peers {

// "pass 3 'stars': no such dither", or nothing.
std::optional<std::string> cannot_express(const pipeline::Frame& frame);

// Puts something that OpenGL has in the place of all that it has not, but for copies that halve and matrices without
// inverse. For random frames, of which hardly one can be expressed as it is.
void make_expressible(pipeline::Frame& frame);

}  // namespace peers
