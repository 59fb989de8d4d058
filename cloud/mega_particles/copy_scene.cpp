// SPDX-License-Identifier: MIT
#include "cloud/mega_particles/copy_scene.h"

namespace cloud {

using namespace pipeline;

void append_scene_copy(const CloudDraw& draw) {
    Pass& pass = append_pass(draw, "copy the back buffer, alpha 0", draw.targets.particles,
                             at_level(draw.halo, draw.blur.first_level));
    show_texture(pass.state, draw.blur.first_level == 0 ? TextureFilter::Point : TextureFilter::Linear);
    pass.state.stages[0].alpha_arg1 = {.source = ArgSource::TFactor};
    pass.state.texture_factor       = {0x00000000};
    pass.draws.push_back(blit(draw.scene.back_buffer, draw.view.width, draw.view.height,
                              1.0f / static_cast<float>(1 << draw.blur.first_level), 0.0f));
}

}  // namespace cloud
