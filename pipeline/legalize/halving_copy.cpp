// SPDX-License-Identifier: MIT
#include "pipeline/legalize/halving_copy.h"

#include <cmath>

#include "pipeline/check/needed_pixels.h"

namespace pipeline {

namespace {

bool can_be_halved(TargetFormat format) {
    return keeps_bytes(format) || format == TargetFormat::R6G6B6A6;
}

bool shows_texel(const TextureStage& stage) {
    return stage.color_op == TextureOp::SelectArg1 && stage.alpha_op == TextureOp::SelectArg1 &&
           stage.color_arg1 == TextureArg{.source = ArgSource::Texture} && stage.alpha_arg1 == stage.color_arg1 &&
           stage.filter == TextureFilter::Linear;
}

bool does_nothing_else(const Pass& pass) {
    PipelineState plain;
    plain.stages[0] = pass.state.stages[0];
    plain.viewport  = pass.state.viewport;
    plain.scissor   = pass.state.scissor;
    plain.dither    = pass.state.dither;
    return pass.state == plain && shows_texel(pass.state.stages[0]) && pass.clear == Clear{} && pass.draws.size() == 1;
}

// Is the coordinate at the sample point of pixels first and last, in texels, 2 * pixel + 1?
bool halves(float start, float stop, float from, float to, std::int32_t first, std::int32_t last, std::int32_t size,
            double center) {
    constexpr double kOff = 1.0 / 512.0;  // texels, less than any filter's fraction
    const double step     = (double{to} - from) / (double{stop} - start);
    const auto is_corner  = [&](double pixel) {
        return std::abs((from + (pixel + center - start) * step) * size - (2.0 * pixel + 1.0)) <= kOff;
    };
    return is_corner(first) && is_corner(last);
}

}  // namespace

std::optional<CopyRectangle> halving_copy(const Frame& frame, const Pass& pass, const PixelRect& to) {
    const PixelRect limit = limit_of(frame, pass);
    if (!does_nothing_else(pass) || !has_pixels(limit)) return {};
    const auto* draw = std::get_if<DrawRectangle>(&pass.draws[0]);
    if (draw == nullptr || !draw->textures[0].target) return {};
    const Target& source = frame.targets[static_cast<std::size_t>(draw->textures[0].target.index)];
    const UvRect& uv     = draw->uv[0];
    const double center  = frame.arithmetic.pixel_center / 16.0;
    const bool is_exact  = contains(covered_pixels(frame.arithmetic, *draw), limit) &&
                          halves(draw->x0, draw->x1, uv.u0, uv.u1, limit.x0, limit.x1 - 1, source.width, center) &&
                          halves(draw->y0, draw->y1, uv.v0, uv.v1, limit.y0, limit.y1 - 1, source.height, center);
    const PixelRect from{2 * to.x0, 2 * to.y0, 2 * to.x1, 2 * to.y1};
    if (!is_exact || !can_be_halved(source.format) || !contains({0, 0, source.width, source.height}, from)) return {};
    return CopyRectangle{.source = draw->textures[0].target, .from = from, .x = to.x0, .y = to.y0, .halve = true};
}

}  // namespace pipeline
