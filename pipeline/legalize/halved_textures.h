// SPDX-License-Identifier: MIT
// Textures of half the width and height, for a memory that does not hold them as they are. No rewrite by itself, since the
// picture loses detail: who asks for it chooses how often.
#pragma once

#include "pipeline/frame/frame.h"

namespace pipeline {

// Each texture loses its first `times` mip levels, but no more than leave one of kLeastHalved texels on its longer side; one without
// levels is made smaller by means of 2x2 texels, rounded half up, as long as its sizes are even. Coordinates stay what they are.
inline constexpr std::int32_t kLeastHalved = 64;
Frame with_halved_textures(Frame frame, int times);

}  // namespace pipeline
