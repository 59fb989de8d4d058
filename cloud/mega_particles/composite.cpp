// SPDX-License-Identifier: MIT
#include "cloud/mega_particles/composite.h"

namespace cloud {

using namespace pipeline;

void append_composite(const CloudDraw& draw, TargetId finished) {
    Pass& pass       = append_pass(draw, "composite (SRCALPHA, INVSRCALPHA)", draw.scene.back_buffer, draw.bounds);
    pass.state.blend = kAlphaOver;
    show_texture(pass.state, TextureFilter::Point);
    pass.state.stages[0].alpha_op   = TextureOp::Modulate;
    pass.state.stages[0].alpha_arg2 = {.source = ArgSource::TFactor};
    pass.state.texture_factor       = to_argb(Vec3(1.0f), draw.baked.cloud.opacity);
    pass.draws.push_back(blit(finished, draw.view.width, draw.view.height, 1.0f, 0.0f));
}

}  // namespace cloud
