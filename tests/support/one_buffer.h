// SPDX-License-Identifier: MIT
// Frames drawn by a chip with one frame buffer.
#pragma once

#include "pipeline/check/frame_buffer.h"
#include "pipeline/check/needed_pixels.h"
#include "pipeline/profile/profile.h"
#include "tests/support/garbage.h"

namespace test_support {

// What a chip would draw that has the frame's targets at one place of its buffer: after each pass, what it drew to is lost for
// the targets that lie there too.
inline pipeline::Frame with_one_buffer(const pipeline::Frame& frame, const pipeline::Profile& chip) {
    using namespace pipeline;
    std::vector<bool> is_in_buffer;
    for (const Target& target : frame.targets)
        is_in_buffer.push_back(is_depth(target.format) || target.format == TargetFormat::X8R8G8B8 ||
                               target.format == TargetFormat::R6G6B6A6);
    const ChipLimits& limits  = chip.limits;
    const BufferPlaces places = place_targets(frame, is_in_buffer, limits.frame_buffer_width, limits.copy_from_step);
    Frame shared              = frame;
    std::size_t added         = 0;
    for (std::size_t pass = 0; pass < frame.passes.size(); ++pass) {
        const TargetId drawn = frame.passes[pass].color;
        if (!drawn || !is_in_buffer[static_cast<std::size_t>(drawn.index)]) continue;
        const BufferSpot here = *places.spots[static_cast<std::size_t>(drawn.index)];
        for (std::size_t i = 0; i < frame.targets.size(); ++i) {
            const TargetId other{static_cast<std::int32_t>(i)};
            if (other == drawn || !is_in_buffer[i] || is_depth(frame.targets[i].format)) continue;
            const std::int32_t dx = here.x - places.spots[i]->x, dy = here.y - places.spots[i]->y;
            const PixelRegion changed = drawn_to(frame, frame.passes[pass]);
            PixelRegion lost;
            for (const PixelRect& part : changed.parts())
                lost.add(PixelRect{part.x0 + dx, part.y0 + dy, part.x1 + dx, part.y1 + dy});
            const std::vector<Pass> passes = garbage_passes(frame, other, common_part(lost, whole_of(frame, other)));
            insert_passes(shared, pass + 1 + added, passes);
            added += passes.size();
        }
    }
    return shared;
}

}  // namespace test_support
