// SPDX-License-Identifier: MIT
// Generated textures of a sandstone desert, colours without light. All tile in both directions.
#pragma once

#include <cstdint>

#include "pipeline/frame/frame.h"

namespace demo {

inline constexpr char kRockTextureName[]      = "rock";
inline constexpr char kSandTextureName[]      = "sand";
inline constexpr char kVariationTextureName[] = "variation";

// What one tile is meant to cover, in metres.
inline constexpr float kRockTileWidth = 48.0f, kRockTileHeight = 96.0f, kSandTile = 48.0f, kVariationTile = 409.0f;

// A wall of layered rock; down is down. Strata, undercut bedding planes, joints, desert varnish. Alpha says how readily
// a spot shows where rock runs out into sand: times four times the rock's share it is the rock's weight, so that all of
// a texture shows at a share of 1.
inline constexpr float kLeastBareness = 0.25f;
pipeline::Texture rock_texture(std::uint32_t seed);

// The ground: sand with ripples and stones.
pipeline::Texture sand_texture(std::uint32_t seed);

// Slow grey variation around 0.5, to be multiplied by two over the others against visible repetition.
pipeline::Texture variation_texture(std::uint32_t seed);

}  // namespace demo
