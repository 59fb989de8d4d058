// SPDX-License-Identifier: MIT
// The registers of a pass and of what its draws bind. See frame/blend_state.h, test_state.h and texture_state.h for what the
// states mean; the chip's registers say the same.
#pragma once

#include "pipeline/emit/gs_memory.h"

namespace pipeline {

// Pixels of the window lie this far right of and below 0 in X and Y of a vertex, in 1/16: 2048 pixels, so that a vertex can
// lie as far outside on either side.
inline constexpr std::int32_t kGsWindowOrigin = 2048 * 16;

// The surface that FRAME names: the colour target, or for a pass without one the depth target as a masked buffer of its size.
GsSurface frame_surface(const GsMemory& memory, const Pass& pass);

struct GsTargets {
    GsSurface color;
    std::uint32_t keep_bits = 0;  // FBMSK
    std::optional<GsSurface> depth;
    bool writes_depth = false;
};
void set_targets(const GsTargets& targets, const PixelRect& part, GsBuilder& out);

// All state of a pass but textures.
void set_pass_state(const Frame& frame, const GsMemory& memory, const Pass& pass, GsBuilder& out);

// None of the states that change a colour on its way: for clears and copies by drawing.
void set_plain_state(GsBuilder& out);

// What a texture register set reads. function: TFX; alpha: TCC. None if the stage reads no texture.
struct GsFunction {
    std::uint32_t tfx = 0, tcc = 0;
};
std::optional<GsFunction> texture_function(const PipelineState& state);

// The surface that a draw reads, with its palette if it has one.
struct GsTexture {
    GsSurface surface;
    std::optional<std::uint32_t> palette;
};
GsTexture bound_texture(const Frame& frame, const GsMemory& memory, const TextureBinding& binding);
void set_texture(const GsTexture& texture, const GsFunction& function, bool linear, bool repeat_u, bool repeat_v,
                 GsBuilder& out);

// TW, TH: the logarithm of the least power of two that holds a size.
std::uint32_t log2_size(std::int32_t size);

// Does ALPHA do more than write the fragment?
bool blends(const GsBlend& blend);

}  // namespace pipeline
