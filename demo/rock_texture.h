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

// A wall of layered rock; down is down. Strata, undercut bedding planes, joints, desert varnish.
pipeline::Texture rock_texture(std::uint32_t seed);

// The ground: sand with ripples, stones and sagebrush.
pipeline::Texture sand_texture(std::uint32_t seed);

// Slow grey variation around 0.5, to be multiplied by two over the others against visible repetition.
pipeline::Texture variation_texture(std::uint32_t seed);

}  // namespace demo
