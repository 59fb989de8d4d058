// SPDX-License-Identifier: MIT
// What the frames built here have in common: one pass, cleared, and a texture of reproducible noise.
#pragma once

#include <cstdint>
#include <optional>

#include "pipeline/frame/frame.h"
#include "tests/support/one_pass_frame.h"

namespace bench {

// A grey, far picture to draw on.
inline pipeline::Frame one_pass_frame(int width, int height, std::optional<pipeline::TargetFormat> depth = {}) {
    pipeline::Frame frame = test_support::one_pass_frame(width, height, depth);
    pipeline::Pass& pass  = frame.passes[0];
    pass.label            = "pass";
    pass.clear.color      = pipeline::Argb{0xff808080};
    if (depth) pass.clear.depth = 1.0f;
    return frame;
}

// Every byte independent of its neighbours, so that nothing can be gained from runs of equal texels.
inline pipeline::TextureId add_noise_texture(pipeline::Frame& frame, pipeline::TextureFormat format, int width,
                                             int height) {
    pipeline::Texture& texture = frame.textures.emplace_back();
    texture.name               = "noise";
    texture.format             = format;
    texture.width              = width;
    texture.height             = height;
    const auto bytes           = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                       static_cast<std::size_t>(bytes_per_texel(format));
    texture.texels.resize(bytes);
    std::uint32_t state = 1;
    for (std::uint8_t& texel : texture.texels) {
        state = state * 1664525u + 1013904223u;
        texel = static_cast<std::uint8_t>(state >> 24);
    }
    return {static_cast<std::int32_t>(frame.textures.size()) - 1};
}

// The stage's colour and alpha are its texture's.
inline void show_texture(pipeline::PipelineState& state, pipeline::TextureFilter filter,
                         pipeline::TextureAddress address = pipeline::TextureAddress::Wrap) {
    pipeline::TextureStage& stage = state.stages[0];
    stage.color_op                = pipeline::TextureOp::SelectArg1;
    stage.alpha_op                = pipeline::TextureOp::SelectArg1;
    stage.filter                  = filter;
    stage.address_u               = address;
    stage.address_v               = address;
}

}  // namespace bench
