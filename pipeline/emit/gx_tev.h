// SPDX-License-Identifier: MIT
// A pass's texture stages, specular addition and vertex fog as stages of the TEV, which computes for each channel, with
// C = c + (c >> 7):
//   ((d + bias) * scale) +- ((a * (256 - C) + b * C) * scale + 128 >> 8)
// so that a frame's op, with arguments 1 and 2, is
//   SELECT        d = argument
//   MODULATE      b = 1, c = 2; the 2X and 4X with scale         MODULATECOLOR_ADDALPHA    d = alpha of 1 besides
//   ADD           a = 1, d = 2; the signed ones with bias -1/2, and AddSigned2X with scale
//   SUBTRACT      a = 2, d = 1, subtracting                      BLENDxALPHA               a = 2, b = 1, c = x
// Texture factor and fog colour lie in registers C0 and C2, and specular goes through C1 where a stage reads both vertex
// colours, of which one stage of the TEV sees one. I8 textures read as their value in all four channels: the black of an A8
// texture and the alpha of an L8 texture are constants, as is the alpha of specular.
// Sources: libogc, gx.h, GX_SetTevColorIn and GX_CC_*, GX_CA_*; the formula: profile evidence "combine".
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/frame/frame.h"

namespace pipeline {

// What a stage's TEXTURE is. White: nothing is bound.
enum class TexelKind : std::uint8_t { White, Color, Luminance, Alpha };

// Vertex fog's factor is the alpha of the second vertex colour; where the chip computes fog itself, it is no stage.
struct TevInputs {
    std::array<TexelKind, kTextureStages> texels{};
    bool is_rectangle   = false;  // no specular: its second colour is black
    bool has_vertex_fog = false;
};

// One half of a stage, as the arguments of GX_SetTevColorIn, GX_SetTevColorOp or their twins for alpha.
struct TevUnit {
    std::string_view a, b, c, d;
    std::string_view op = "GX_TEV_ADD", bias = "GX_TB_ZERO", scale = "GX_CS_SCALE_1", out = "GX_TEVPREV";
    bool operator==(const TevUnit&) const = default;
};

// texture: the frame's stage whose texture it reads, -1 if none. rasterized: GX_COLOR0A0 or GX_COLOR1A1, or none.
struct TevStage {
    std::string_view what;
    int texture                 = -1;
    std::string_view rasterized = "GX_COLORNULL";
    TevUnit color, alpha;
    bool operator==(const TevStage&) const = default;
};

struct TevProgram {
    std::vector<TevStage> stages;
    bool reads_specular                      = false;  // red, green and blue of the second vertex colour
    bool reads_fog                           = false;  // its alpha
    bool operator==(const TevProgram&) const = default;
    bool reads(int texture) const;
};

TevProgram tev_program(const PipelineState& state, const TevInputs& inputs);

}  // namespace pipeline
