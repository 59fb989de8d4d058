// SPDX-License-Identifier: MIT
#include "pipeline/cost/pass_work.h"

#include <algorithm>
#include <cmath>

namespace pipeline {

namespace {

PixelRect intersect(const PixelRect& a, const PixelRect& b) {
    return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

double area(const PixelRect& rect) {
    if (rect.x0 >= rect.x1 || rect.y0 >= rect.y1) return 0.0;
    return static_cast<double>(rect.x1 - rect.x0) * static_cast<double>(rect.y1 - rect.y0);
}

PixelRect limits_of(const Frame& frame, const Pass& pass) {
    const TargetId id = pass.color ? pass.color : pass.depth;
    if (!id) return {};
    const Target& target = frame.targets[static_cast<std::size_t>(id.index)];
    PixelRect limits{0, 0, target.width, target.height};
    for (const PixelRect& rect : {pass.state.viewport, pass.state.scissor})
        if (rect != PixelRect{}) limits = intersect(limits, rect);
    return limits;
}

// The first pixel whose centre lies at x or beyond, as SnapRule and Arithmetic::pixel_center have it.
int first_pixel(const Arithmetic& arithmetic, float x) {
    const double sixteenths = static_cast<double>(x) * 16.0;
    const double snapped    = arithmetic.snap == SnapRule::Truncate ? std::trunc(sixteenths) : std::round(sixteenths);
    return static_cast<int>(std::ceil((snapped - arithmetic.pixel_center) / 16.0));
}

PixelRect covered_by(const Arithmetic& arithmetic, const DrawRectangle& rectangle) {
    return {first_pixel(arithmetic, rectangle.x0), first_pixel(arithmetic, rectangle.y0),
            first_pixel(arithmetic, rectangle.x1), first_pixel(arithmetic, rectangle.y1)};
}

bool reads_texture(TextureOp op, const TextureArg& arg1, const TextureArg& arg2) {
    if (op == TextureOp::Disable) return false;
    return (op != TextureOp::SelectArg2 && arg1.source == ArgSource::Texture) ||
           (op != TextureOp::SelectArg1 && arg2.source == ArgSource::Texture) || op == TextureOp::BlendTextureAlpha;
}

bool reads_texture(const TextureStage& stage) {
    return reads_texture(stage.color_op, stage.color_arg1, stage.color_arg2) ||
           reads_texture(stage.alpha_op, stage.alpha_arg1, stage.alpha_arg2);
}

TextureRead texture_read(const Frame& frame, const TextureBinding& binding, const TextureStage& stage) {
    TextureRead read{.binding = binding, .fresh = {}, .span = {}};
    if (binding.texture) {
        const Texture& texture = frame.textures[static_cast<std::size_t>(binding.texture.index)];
        read.width             = texture.width;
        read.height            = texture.height;
        read.bytes             = bytes_per_texel(texture.format);
    } else {
        const Target& target = frame.targets[static_cast<std::size_t>(binding.target.index)];
        read.width           = target.width;
        read.height          = target.height;
        read.bytes           = bytes_per_pixel(target.format);
    }
    read.samples = stage.mip_filter == MipFilter::Linear ? 2 : 1;
    read.texels  = read.samples * (stage.filter == TextureFilter::Linear ? 4 : 1);
    read.fresh   = {1.0, static_cast<double>(read.texels)};
    return read;
}

// The texels that a side of `size` texels has between two coordinates, whole ones.
void span_of(float from, float to, int size, std::int32_t& first, std::int32_t& end) {
    const double a = static_cast<double>(from) * size, b = static_cast<double>(to) * size;
    first = static_cast<std::int32_t>(std::floor(std::min(a, b)));
    end   = std::max(first + 1, static_cast<std::int32_t>(std::ceil(std::max(a, b))));
}

void set_span(const DrawRectangle& rectangle, const UvRect& uv, TextureRead& read) {
    span_of(uv.u0, uv.u1, read.width, read.span.x0, read.span.x1);
    span_of(uv.v0, uv.v1, read.height, read.span.y0, read.span.y1);
    const double pixels = static_cast<double>(rectangle.x1 - rectangle.x0) * (rectangle.y1 - rectangle.y0);
    const double ratio  = pixels > 0.0 ? area(read.span) / pixels : 1.0;
    const double most   = read.texels;
    read.fresh          = {std::min(ratio, most), std::clamp(ratio, 1.0, most)};
}

std::vector<TextureRead> textures_read(const Frame& frame, const PipelineState& state, const Draw& draw) {
    std::vector<TextureRead> reads;
    const TextureBindings bindings = textures_of(draw);
    const auto* rectangle          = std::get_if<DrawRectangle>(&draw);
    for (std::size_t i = 0; i < static_cast<std::size_t>(stage_count(state)); ++i) {
        if (!reads_texture(state.stages[i]) || bindings[i] == TextureBinding{}) continue;
        reads.push_back(texture_read(frame, bindings[i], state.stages[i]));
        if (rectangle != nullptr) set_span(*rectangle, rectangle->uv[i], reads.back());
    }
    return reads;
}

struct Shares {
    double rectangles = 0.0;  // pixels
    double indices    = 0.0;
};

std::vector<DrawWork> shapes(const Frame& frame, const Pass& pass, const PixelRect& limits, Shares& shares) {
    std::vector<DrawWork> draws;
    for (const Draw& draw : pass.draws) {
        if (std::holds_alternative<CopyRectangle>(draw)) continue;
        DrawWork& work = draws.emplace_back();
        work.textures  = textures_read(frame, pass.state, draw);
        if (const auto* rectangle = std::get_if<DrawRectangle>(&draw)) {
            work.is_rectangle = true;
            work.covered      = intersect(covered_by(frame.arithmetic, *rectangle), limits);
            work.fragments    = area(work.covered);
            shares.rectangles += work.fragments;
        } else {
            const auto* triangles = std::get_if<DrawTriangles>(&draw);
            work.triangles =
                triangles != nullptr ? triangles->index_count : std::get<DrawWindowTriangles>(draw).index_count;
            shares.indices += work.triangles;
        }
    }
    return draws;
}

// From shares to counts.
void share_out(const PassCounts& counts, const Shares& shares, PassWork& work) {
    const auto covered       = static_cast<double>(counts.covered);
    const bool has_triangles = shares.indices > 0.0;
    const bool too_many      = shares.rectangles > covered || !has_triangles;
    const double scale       = shares.rectangles > 0.0 && too_many ? covered / shares.rectangles : 1.0;
    const double rest        = std::max(0.0, covered - shares.rectangles);
    double texels            = 0.0;
    for (DrawWork& draw : work.draws) {
        if (draw.is_rectangle) {
            draw.fragments *= scale;
        } else {
            const double share = has_triangles ? draw.triangles / shares.indices : 0.0;
            draw.fragments     = rest * share;
            draw.triangles     = static_cast<double>(counts.triangles_drawn) * share;
        }
        for (const TextureRead& read : draw.textures) texels += draw.fragments * read.texels;
    }
    if (texels > 0.0) work.texel_scale = static_cast<double>(counts.texels) / texels;
}

int pixel_bytes(const Frame& frame, TargetId id) {
    return id ? bytes_per_pixel(frame.targets[static_cast<std::size_t>(id.index)].format) : 0;
}

// PassCounts::bytes are of targets and of texels, and copies count in both columns.
void set_bytes(const PassCounts& counts, PassWork& work) {
    const auto bytes = static_cast<double>(counts.bytes);
    if (counts.copies > 0) {
        work.copied       = static_cast<double>(counts.texels);
        work.copied_bytes = static_cast<double>(counts.color_written) * work.color_bytes;
        work.frame_bytes  = std::max(0.0, bytes - work.copied_bytes);
        return;
    }
    double texel_bytes = 0.0;
    for (const DrawWork& draw : work.draws)
        for (const TextureRead& read : draw.textures) texel_bytes += draw.fragments * read.texels * read.bytes;
    work.frame_bytes = std::max(0.0, bytes - texel_bytes * work.texel_scale);
}

}  // namespace

PassWork pass_work(const Frame& frame, const Pass& pass, const PassCounts& counts) {
    PassWork work;
    work.limits         = limits_of(frame, pass);
    work.color_bytes    = pixel_bytes(frame, pass.color);
    work.depth_bytes    = pixel_bytes(frame, pass.depth);
    work.accesses_color = static_cast<bool>(pass.color);
    work.accesses_depth = pass.depth && (pass.state.depth.func != CompareFunc::Always || pass.state.depth.write);
    work.clears_color   = pass.clear.color && pass.color;
    work.clears_depth   = pass.clear.depth && pass.depth;
    if (work.clears_color || work.clears_depth)
        work.cleared = static_cast<double>(counts.cleared) / (work.clears_color && work.clears_depth ? 2 : 1);
    Shares shares;
    work.draws = shapes(frame, pass, work.limits, shares);
    share_out(counts, shares, work);
    set_bytes(counts, work);
    return work;
}

double bytes_of(const Frame& frame, const TextureBinding& binding) {
    if (binding.texture) {
        const Texture& texture = frame.textures[static_cast<std::size_t>(binding.texture.index)];
        double texels          = 0.0;
        for (int level = 0; level < texture.levels; ++level)
            texels += static_cast<double>(std::max(1, texture.width >> level)) * std::max(1, texture.height >> level);
        return texels * bytes_per_texel(texture.format);
    }
    if (!binding.target) return 0.0;
    const Target& target = frame.targets[static_cast<std::size_t>(binding.target.index)];
    return static_cast<double>(target.width) * target.height * bytes_per_pixel(target.format);
}

}  // namespace pipeline
