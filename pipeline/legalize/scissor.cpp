// SPDX-License-Identifier: MIT
#include "pipeline/legalize/scissor.h"

#include <algorithm>

#include "pipeline/check/chip_findings.h"
#include "pipeline/check/target_use.h"
#include "pipeline/legalize/window_map.h"

namespace pipeline {

namespace {

PixelRect common(const PixelRect& a, const PixelRect& b) {
    return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

// X + (1 + x/w) W/2 = X' + (1 + x'/w) W'/2 gives x' = W/W' x + (2X + W - 2X' - W')/W' w; y, which runs down, likewise.
WindowMap map_between(const PixelRect& from, const PixelRect& to) {
    const double width = to.x1 - to.x0, height = to.y1 - to.y0;
    return {.scale_x = (from.x1 - from.x0) / width,
            .shift_x = (from.x0 + from.x1 - to.x0 - to.x1) / width,
            .scale_y = (from.y1 - from.y0) / height,
            .shift_y = -(from.y0 + from.y1 - to.y0 - to.y1) / height};
}

bool is_limited(const Pass& pass) {
    return draws(pass) || pass.clear.color || pass.clear.depth;
}

void draw_nothing(Pass& pass) {
    pass.clear = {};
    if (draws(pass)) pass.draws.clear();  // copies know no scissor
}

}  // namespace

Frame limit_by_viewport(Frame frame, const Profile& profile, RewriteNotes& notes) {
    if (profile.states.scissor) return frame;
    std::vector<std::optional<WindowMap>> maps(frame.passes.size());
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        Pass& pass = frame.passes[i];
        if (pass.state.scissor == PixelRect{} || !is_limited(pass)) continue;
        const PixelRect viewport = viewport_of(frame, pass), limit = common(viewport, pass.state.scissor);
        if (limit == viewport) continue;
        pass.state.scissor  = {};
        const bool is_empty = limit.x0 >= limit.x1 || limit.y0 >= limit.y1;
        if (is_empty) {
            draw_nothing(pass);
        } else {
            pass.state.viewport = limit;
            if (draws_triangles(pass)) maps[i] = map_between(viewport, limit);
        }
        notes.push_back(
            {"scissor", place_of(frame, i), "the chip has no scissor",
             is_empty ? "nothing is drawn, as nothing of the viewport is left"
                      : "viewport " + differing_fields(limit, {}) + (maps[i] ? ", with the projection to fit" : "")});
    }
    move_triangles(frame, maps);
    return frame;
}

}  // namespace pipeline
