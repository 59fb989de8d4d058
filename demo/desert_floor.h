// SPDX-License-Identifier: MIT
// What lies on the sand of a desert, as factors around 0.5 to be multiplied by two over its texture: slow variation
// against visible repetition, dry rills, and strewn stones and shrubs in clumps with their shade. Tiles in both
// directions; drawn for sunlight that comes from +u, a little +v.
#pragma once

#include <cstdint>

#include "pipeline/frame/frame.h"

namespace demo {

inline constexpr char kDesertFloorTextureName[] = "desert floor";

// What one tile is meant to cover, in metres.
inline constexpr float kDesertFloorWidth = 160.0f, kDesertFloorHeight = 80.0f;

pipeline::Texture desert_floor_texture(std::uint32_t seed);

}  // namespace demo
