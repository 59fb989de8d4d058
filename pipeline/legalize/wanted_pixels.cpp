// SPDX-License-Identifier: MIT
#include "pipeline/legalize/wanted_pixels.h"

#include "pipeline/check/needed_pixels.h"
#include "pipeline/check/target_use.h"
#include "pipeline/legalize/texels_read.h"

namespace pipeline {

namespace {

std::size_t index_of(TargetId id) {
    return static_cast<std::size_t>(id.index);
}

// Backwards through the passes; wanted: of each target, what is wanted after the pass, and then before it.
class Backwards {
  public:
    explicit Backwards(const Frame& frame) : frame_(frame), wanted_(frame.targets.size()) {
        const Target& picture = frame.targets[index_of(frame.output)];
        wanted_[index_of(frame.output)].add({0, 0, picture.width, picture.height});
    }

    void step(const Pass& pass) {
        // Where what it draws can be seen; what it leaves in depth, anywhere within its limits.
        const PixelRegion limit(limit_of(frame_, pass));
        PixelRegion seen;
        if (pass.color) seen = common_part(wanted_[index_of(pass.color)], limit);
        if (writes_depth_by_alpha(pass)) seen = limit;
        std::vector<std::pair<TargetId, PixelRect>> reads = copied(pass);
        for_each_texture(pass, [&](std::size_t draw, std::size_t stage, const TextureBinding& binding) {
            if (binding.target)
                reads.emplace_back(binding.target, texels_read(frame_, pass, pass.draws[draw], stage, seen.bounds()));
        });
        if (pass.color) wanted_[index_of(pass.color)].remove(overwritten(frame_, pass));
        if (pass.color && writes_depth_by_alpha(pass) && pass.state.dest_alpha_test != DestAlphaTest::Off)
            wanted_[index_of(pass.color)].add(limit);
        for (const auto& [target, part] : reads) wanted_[index_of(target)].add(part);
    }

    const PixelRegion& wanted(std::size_t target) const { return wanted_[target]; }

  private:
    static bool writes_depth_by_alpha(const Pass& pass) {
        const PipelineState& state = pass.state;
        return pass.depth && draws(pass) && state.depth.write &&
               (state.alpha_test.func != CompareFunc::Always || state.dest_alpha_test != DestAlphaTest::Off);
    }

    static std::vector<std::pair<TargetId, PixelRect>> copied(const Pass& pass) {
        std::vector<std::pair<TargetId, PixelRect>> reads;
        for (const Draw& draw : pass.draws)
            if (const auto* copy = std::get_if<CopyRectangle>(&draw)) reads.emplace_back(copy->source, copy->from);
        return reads;
    }

    const Frame& frame_;
    std::vector<PixelRegion> wanted_;
};

}  // namespace

std::vector<std::vector<PixelRegion>> wanted_pixels(const Frame& frame) {
    const std::size_t passes = frame.passes.size();
    std::vector<std::vector<PixelRegion>> wanted(frame.targets.size(), std::vector<PixelRegion>(passes + 1));
    Backwards backwards(frame);
    const auto keep = [&](std::size_t pass) {
        for (std::size_t i = 0; i < wanted.size(); ++i) wanted[i][pass] = backwards.wanted(i);
    };
    keep(passes);
    for (std::size_t i = passes; i-- > 0;) {
        backwards.step(frame.passes[i]);
        keep(i);
    }
    return wanted;
}

}  // namespace pipeline
