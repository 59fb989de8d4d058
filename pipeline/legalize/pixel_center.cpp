// SPDX-License-Identifier: MIT
#include "pipeline/legalize/pixel_center.h"

#include <algorithm>
#include <cmath>

#include "pipeline/check/chip_findings.h"
#include "pipeline/check/target_use.h"
#include "pipeline/legalize/window_map.h"

namespace pipeline {

namespace {

constexpr float kSubpixels = 16.0f;

struct Move {
    SnapRule snap = SnapRule::Nearest;  // of the frame
    float by_q4   = 0.0f;               // 1/16 pixel
};

// Exact: the result is a multiple of 1/16 of less than 2^24 / 16.
float moved(const Move& move, float pixels) {
    const float x      = pixels * kSubpixels;
    const float x_snap = move.snap == SnapRule::Truncate ? std::trunc(x) : std::nearbyint(x);
    return (x_snap + move.by_q4) / kSubpixels;
}

// At the limit of coordinates a moved edge does not go on, and its texture coordinates are those found there.
void move_axis(const Move& move, float& low, float& high, std::array<UvRect, kTextureStages>& uv, float UvRect::*uv_low,
               float UvRect::*uv_high) {
    constexpr auto kLimit = static_cast<float>(kMaxRectangleCoordinate);
    const float low_there = moved(move, low), high_there = moved(move, high);
    low              = std::max(low_there, -kLimit);
    high             = std::min(std::max(high_there, low), kLimit);
    low              = std::min(low, high);
    const float size = high_there - low_there;
    if (size <= 0.0f || (low == low_there && high == high_there)) return;
    for (UvRect& rect : uv) {
        const float per_pixel = (rect.*uv_high - rect.*uv_low) / size;
        rect.*uv_low += (low - low_there) * per_pixel;
        rect.*uv_high += (high - high_there) * per_pixel;
    }
}

void move_rectangle(const Move& move, DrawRectangle& draw) {
    move_axis(move, draw.x0, draw.x1, draw.uv, &UvRect::u0, &UvRect::u1);
    move_axis(move, draw.y0, draw.y1, draw.uv, &UvRect::v0, &UvRect::v1);
}

void move_vertices(Frame& frame, double by_px) {
    constexpr auto kLimit = static_cast<float>(kMaxWindowCoordinate);
    const auto by         = static_cast<float>(by_px);
    for (WindowVertex& vertex : frame.window_vertices) {
        vertex.x = std::clamp(vertex.x + by, -kLimit, kLimit);
        vertex.y = std::clamp(vertex.y + by, -kLimit, kLimit);
    }
}

WindowMap map_of(const PixelRect& viewport, double by_px) {
    return {.shift_x = 2.0 * by_px / (viewport.x1 - viewport.x0),
            .shift_y = -2.0 * by_px / (viewport.y1 - viewport.y0)};
}

double rounding_px(SnapRule frame, SnapRule chip) {
    if (frame == chip) return 0.0;
    return chip == SnapRule::Truncate ? 1.0 / 32.0 : -1.0 / 32.0;
}

}  // namespace

Frame move_to_pixel_centers(Frame frame, const Profile& profile, RewriteNotes& notes) {
    const Arithmetic before = frame.arithmetic, &chip = profile.arithmetic;
    if (before.pixel_center == chip.pixel_center && before.snap == chip.snap) return frame;
    const Move move    = {before.snap, static_cast<float>(chip.pixel_center - before.pixel_center)};
    const double by_px = move.by_q4 / kSubpixels + rounding_px(before.snap, chip.snap);
    std::vector<std::optional<WindowMap>> maps;
    for (Pass& pass : frame.passes) {
        maps.push_back(pass.camera && draws_triangles(pass) ? std::optional(map_of(viewport_of(frame, pass), by_px))
                                                            : std::nullopt);
        for (Draw& draw : pass.draws)
            if (auto* rectangle = std::get_if<DrawRectangle>(&draw)) move_rectangle(move, *rectangle);
    }
    move_triangles(frame, maps);
    move_vertices(frame, by_px);
    frame.arithmetic.pixel_center = chip.pixel_center;
    frame.arithmetic.snap         = chip.snap;
    notes.push_back(
        {"pixel_center", "frame", "the chip samples and snaps otherwise: " + differing_fields(before, frame.arithmetic),
         differing_fields(frame.arithmetic, before) + ", rectangles move by " + text_of(move.by_q4 / kSubpixels) +
             " pixel and projections by " + text_of(static_cast<float>(by_px))});
    return frame;
}

}  // namespace pipeline
