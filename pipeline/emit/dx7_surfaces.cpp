// SPDX-License-Identifier: MIT
#include "pipeline/emit/dx7_surfaces.h"

#include <algorithm>

#include "pipeline/check/target_use.h"

namespace pipeline::dx7 {

namespace {

std::size_t index_of(TargetId id) {
    return static_cast<std::size_t>(id.index);
}

bool is_whole(const PixelRect& part, const Surface& surface) {
    return part == PixelRect{} || part == PixelRect{0, 0, surface.width, surface.height};
}

class Collector {
  public:
    explicit Collector(const Frame& frame) : frame_(frame) {
        for (const Target& target : frame.targets)
            out_.all.push_back(
                {.name = target.name, .format = target.format, .width = target.width, .height = target.height});
    }

    Surfaces take() {
        for (const Pass& pass : frame_.passes) add(pass);
        use(frame_.output);
        return std::move(out_);
    }

  private:
    void add(const Pass& pass) {
        for_each_texture(pass, [&](std::size_t, std::size_t, const TextureBinding& binding) {
            if (!binding.target) return;
            use(binding.target);
            out_.all[index_of(binding.target)].is_texture = true;
        });
        for (const Draw& draw : pass.draws)
            if (const auto* copy = std::get_if<CopyRectangle>(&draw)) use(copy->source);

        PassSurfaces surfaces;
        if (pass.clear.depth || uses_depth(pass))
            surfaces.depth = draw_to(pass, pass.depth, pass.clear.depth.has_value());
        const bool draws_color = pass.color && (pass.clear.color || !pass.draws.empty() || surfaces.depth >= 0);
        if (draws_color) surfaces.color = draw_to(pass, pass.color, pass.clear.color.has_value());
        if (surfaces.color < 0 && surfaces.depth >= 0) surfaces.color = spare(surfaces.depth);
        out_.passes.push_back(surfaces);
    }

    void use(TargetId id) {
        Surface& surface = out_.all[index_of(id)];
        if (!surface.is_used) surface.is_zeroed = true;
        surface.is_used = true;
    }

    int draw_to(const Pass& pass, TargetId id, bool is_cleared) {
        Surface& surface    = out_.all[index_of(id)];
        const bool is_first = !surface.is_used;
        use(id);
        if (is_first && is_cleared && is_whole(pass.state.viewport, surface) && is_whole(pass.state.scissor, surface))
            surface.is_zeroed = false;
        return id.index;
    }

    int spare(int depth) {
        const Surface& of = out_.all[static_cast<std::size_t>(depth)];
        const auto fits   = [&](const Surface& surface) {
            return surface.is_spare && surface.width == of.width && surface.height == of.height;
        };
        auto found = std::find_if(out_.all.begin(), out_.all.end(), fits);
        if (found == out_.all.end()) {
            out_.all.push_back(
                {.name = "spare", .width = of.width, .height = of.height, .is_used = true, .is_spare = true});
            found = out_.all.end() - 1;
        }
        return static_cast<int>(found - out_.all.begin());
    }

    const Frame& frame_;
    Surfaces out_;
};

}  // namespace

Surfaces surfaces_of(const Frame& frame) {
    return Collector(frame).take();
}

}  // namespace pipeline::dx7
