// SPDX-License-Identifier: MIT
#include "cloud/mega_particles/cloud_draw.h"

#include <algorithm>

namespace cloud {

using namespace pipeline;

Pass& append_pass(const CloudDraw& draw, const std::string& what, TargetId color, PixelRect area) {
    Pass& pass         = draw.frame.passes.emplace_back();
    pass.label         = draw.baked.cloud.name + ": " + what;
    pass.color         = color;
    const Target& into = draw.frame.targets[static_cast<std::size_t>(color.index)];
    pass.state.scissor = grow(area, 0, into.width, into.height);
    return pass;
}

DrawRectangle blit(TargetId source, int source_width, int source_height, float scale, float shift) {
    // The pyramid is of a size rounded up to 2^kMaxBlurLevels: more than twice as large as what is less than half of that.
    const auto times = [scale](int size) {
        return scale > 2.0f ? 1.0f : size < (1 << kMaxBlurLevels) / 2 ? float{1 << kMaxBlurLevels} : 2.0f;
    };
    DrawRectangle rectangle;
    rectangle.x0 = rectangle.y0 = shift;
    rectangle.x1                = shift + times(source_width) * scale * static_cast<float>(source_width);
    rectangle.y1                = shift + times(source_height) * scale * static_cast<float>(source_height);
    rectangle.uv[0]             = {.u0 = 0.0f, .v0 = 0.0f, .u1 = times(source_width), .v1 = times(source_height)};
    rectangle.textures[0]       = {.texture = {}, .target = source};
    return rectangle;
}

void show_texture(PipelineState& state, TextureFilter filter) {
    TextureStage& stage = state.stages[0];
    stage.color_op      = TextureOp::SelectArg1;
    stage.alpha_op      = TextureOp::SelectArg1;
    stage.filter        = filter;
    stage.address_u     = TextureAddress::Clamp;
    stage.address_v     = TextureAddress::Clamp;
}

void blend_over_scene(const CloudDraw& draw, PipelineState& state, BlendState blend) {
    state.blend = blend;
    if (draw.baked.cloud.order == Order::InOrder) return;
    state.dest_alpha_test  = DestAlphaTest::One;
    state.color_mask.alpha = false;
}

Argb to_argb(Vec3 color, float alpha) {
    const auto byte = [](float v) { return static_cast<std::uint32_t>(std::clamp(v, 0.0f, 1.0f) * 255.0f + 0.5f); };
    return {byte(alpha) << 24 | byte(color.x) << 16 | byte(color.y) << 8 | byte(color.z)};
}

}  // namespace cloud
