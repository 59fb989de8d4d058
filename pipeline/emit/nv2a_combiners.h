// SPDX-License-Identifier: MIT
// Texture stages as register combiners: one general combiner for each stage, one more that adds the second colour, and the
// final combiner, which mixes in fog. With A, B, C, D the inputs, each mapped to max(0, x) or 1 - x, a general combiner writes
//   SPARE0 (R0) = scale * (A B + C D + bias), clamped to [-1, 1]
// of colour and alpha apart; the next input's max(0, x) makes that the stage's clamp to [0, 1]. The final combiner gives
//   D + A B + (1 - A) C of colour, and G of alpha.
// Input word: A in bits 31..24, then B, C, D; of each 3 bits of mapping, 1 of channel (alpha), 4 of register. Output word:
// where A B + C D goes in bits 11..8, scale and bias in 17..15. Source: xemu, pgraph/psh_regs.h and pgraph/glsl/psh.c;
// OpenGL extension NV_register_combiners.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "pipeline/emit/nv2a_methods.h"
#include "pipeline/frame/pipeline_state.h"

namespace pipeline {

// What a stage's texture register holds. Nothing: the stage reads none, or nothing is bound, which is white. Alpha: an A8,
// whose red, green and blue are 0 in the frame and 1 in the chip.
enum class Nv2aTexel : std::uint8_t { Nothing, Color, Alpha };
using Nv2aTexels = std::array<Nv2aTexel, kTextureStages>;

// The words of the first `count` general combiners.
struct Nv2aCombiners {
    std::uint32_t count = 0;
    std::array<std::uint32_t, nv097::kCombiners> color_in{}, color_out{}, alpha_in{}, alpha_out{};
    std::uint32_t final_abcd = 0, final_efg = 0;
    bool operator==(const Nv2aCombiners&) const = default;
};

Nv2aCombiners nv2a_combiners(const PipelineState& state, const Nv2aTexels& texels, bool has_fog);

// Is the second colour read, as an argument or to be added?
bool reads_second_color(const PipelineState& state);

// "A = T0, B = 1 - C0.a, C = 0, D = 0" of an input word, and "R0 = 2 (A B + C D - 1/2)" of an output word.
std::string inputs_text(std::uint32_t in, bool of_alpha);
std::string output_text(std::uint32_t out);

}  // namespace pipeline
