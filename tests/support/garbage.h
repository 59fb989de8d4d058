// SPDX-License-Identifier: MIT
// Passes that spoil pixels of a target: where these may hold anything, the picture stays as it is.
#pragma once

#include "pipeline/check/pixel_region.h"
#include "pipeline/frame/frame.h"

namespace test_support {

// One for each part of the region.
inline std::vector<pipeline::Pass> garbage_passes(const pipeline::Frame& frame, pipeline::TargetId target,
                                                  const pipeline::PixelRegion& region) {
    std::vector<pipeline::Pass> passes;
    for (const pipeline::PixelRect& part : region.parts()) {
        pipeline::Pass& pass = passes.emplace_back();
        pass.label           = "garbage";
        if (is_depth(frame.targets[static_cast<std::size_t>(target.index)].format)) {
            pass.depth       = target;
            pass.clear.depth = 0.37f;
        } else {
            pass.color       = target;
            pass.clear.color = pipeline::Argb{0x5ac3397e};
        }
        pass.state.scissor = part;
    }
    return passes;
}

inline pipeline::PixelRegion whole_of(const pipeline::Frame& frame, pipeline::TargetId target) {
    const pipeline::Target& size = frame.targets[static_cast<std::size_t>(target.index)];
    return pipeline::PixelRegion(pipeline::PixelRect{0, 0, size.width, size.height});
}

// The passes before pass number `before`.
inline void insert_passes(pipeline::Frame& frame, std::size_t before, const std::vector<pipeline::Pass>& passes) {
    frame.passes.insert(frame.passes.begin() + static_cast<std::ptrdiff_t>(before), passes.begin(), passes.end());
}

}  // namespace test_support
