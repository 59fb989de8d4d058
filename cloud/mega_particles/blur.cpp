// SPDX-License-Identifier: MIT
#include "cloud/mega_particles/blur.h"

namespace cloud {

using namespace pipeline;

namespace {

struct Pyramid {
    const CloudDraw& draw;

    const Target& target(TargetId id) const { return draw.frame.targets[static_cast<std::size_t>(id.index)]; }
    TargetId front(int level) const {
        return level == draw.blur.first_level ? draw.targets.particles
                                              : draw.targets.front[static_cast<std::size_t>(level)];
    }
    TargetId back(int level) const { return draw.targets.back[static_cast<std::size_t>(level)]; }

    void append_blit(const std::string& what, TargetId from, TargetId to, int to_level, PixelRect area, float scale,
                     float shift) const {
        const Target& source = target(from);
        Pass& pass           = append_pass(draw, what, to, at_level(area, to_level));
        show_texture(pass.state, TextureFilter::Linear);
        pass.draws.push_back(blit(from, source.width, source.height, scale, shift));
    }

    // A pixel's centre falls on the corner that four texels share: their mean.
    void append_down(int level) const {
        append_blit("downsample 2:1 (box filter)", front(level - 1), front(level), level, draw.halo, 0.5f, 0.0f);
    }

    // Each blit averages 2x2 texels, first those right and below, then those left and above: 1 2 1 in both axes. The
    // first fills the halo, for the second to read; the second leaves the halo, where there is no cloud, as it was.
    void append_tent(int level) const {
        append_blit("tent, right and down by half a texel", front(level), back(level), level, draw.halo, 1.0f, -0.5f);
        append_blit("tent, left and up by half a texel", back(level), front(level), level, draw.bounds, 1.0f, 0.5f);
    }

    // By 1:2 the weights are 3/4 and 1/4 in both axes.
    void append_up(int level) const {
        append_blit("upsample 1:2 (bilinear)", front(level + 1), front(level), level, draw.bounds, 2.0f, 0.0f);
    }
};

}  // namespace

void append_blur(const CloudDraw& draw) {
    const Pyramid pyramid{draw};
    const BlurPlan& plan    = draw.blur;
    const auto append_tents = [&](int level, int count) {
        for (int i = 0; i < count; ++i) pyramid.append_tent(level);
    };
    for (int level = plan.first_level; level < plan.levels; ++level) {
        if (level > 0)
            append_tents(level, plan.extra_tents[static_cast<std::size_t>(level)] + (plan.inner_tents ? 1 : 0));
        pyramid.append_down(level + 1);
    }
    append_tents(plan.levels, plan.bottom_tents);
    for (int level = plan.levels - 1; level >= plan.first_level; --level) {
        pyramid.append_up(level);
        if (plan.inner_tents && level > 0) pyramid.append_tent(level);
    }
}

}  // namespace cloud
