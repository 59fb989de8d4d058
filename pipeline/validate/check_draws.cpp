// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cmath>

#include "pipeline/validate/check_pass.h"
#include "pipeline/validate/check_values.h"

namespace pipeline {

namespace {

struct Size {
    std::int32_t width = 0, height = 0;
};

// Of what is bound; zero if that is nothing, or not valid itself.
Size bound_size(const Frame& frame, const TextureBinding& binding) {
    const Texture* texture = find_texture(frame, binding.texture);
    const Target* target   = find_target(frame, binding.target);
    if ((texture == nullptr) == (target == nullptr)) return {};
    const Size size = texture != nullptr ? Size{texture->width, texture->height} : Size{target->width, target->height};
    const auto is_possible = [](std::int32_t texels) { return texels >= 1 && texels <= kMaxTextureSize; };
    return is_possible(size.width) && is_possible(size.height) ? size : Size{};
}

void check_address(TextureAddress address, char axis, std::int32_t size, const Place& place, Findings& findings) {
    if (address == TextureAddress::Clamp || size == 0 || is_power_of_two(size)) return;
    report(findings, place,
           "must have a size that is a power of two for address_" + std::string(1, axis) + ' ' +
               std::string(enum_name(address)) + got(size));
}

void check_bindings(const Frame& frame, const Pass& pass, const TextureBindings& textures, const Place& place,
                    Findings& findings) {
    for (std::size_t i = 0; i < textures.size(); ++i) {
        const TextureBinding& binding = textures[i];
        const Place here              = place.entry("textures", i);
        if (binding.texture && binding.target) {
            report(findings, here, "must bind a texture or a target, not both");
        }
        if (const Target* target = find_target(frame, binding.target)) {
            if (is_depth(target->format)) {
                report(findings, here.field("target"), "must be a colour target" + got(target->format));
            }
            if (binding.target == pass.color) {
                report(findings, here.field("target"), "must not be the target that the pass draws to");
            }
        }
        if (reads_texture(pass.state, static_cast<int>(i))) {
            const TextureStage& stage = pass.state.stages[i];
            const Size size           = bound_size(frame, binding);
            if (static_cast<std::size_t>(stage.address_u) < EnumNames<TextureAddress>::names.size()) {
                check_address(stage.address_u, 'u', size.width, here, findings);
            }
            if (static_cast<std::size_t>(stage.address_v) < EnumNames<TextureAddress>::names.size()) {
                check_address(stage.address_v, 'v', size.height, here, findings);
            }
        }
    }
}

template <class Triangles>
void check_triangles(const Frame& frame, const Triangles& draw, const Place& place, Findings& findings) {
    if (draw.index_count % 3 != 0) {
        report(findings, place.field("index_count"), "must be a multiple of 3" + got(draw.index_count));
    }
    const std::uint64_t end = std::uint64_t{draw.first_index} + draw.index_count;
    if (end > frame.indices.size()) {
        report(findings, place,
               "must use indices below " + std::to_string(frame.indices.size()) + " (got " +
                   std::to_string(draw.first_index) + ".." + std::to_string(end - 1) + ')');
    }
}

void check_rectangle(const Frame& frame, const DrawRectangle& draw, const Place& place, Findings& findings) {
    const auto check_axis = [&](std::string_view low_name, float low, std::string_view high_name, float high) {
        if (low > high) {
            report(findings, place.field(high_name), "must be >= " + std::string(low_name) + got(high));
        }
        for (const auto& [name, value] : {std::pair{low_name, low}, std::pair{high_name, high}}) {
            if (std::abs(value) > static_cast<float>(kMaxRectangleCoordinate)) {
                report(findings, place.field(name),
                       "must lie within " + std::to_string(kMaxRectangleCoordinate) + " pixels of 0" + got(value));
            }
        }
    };
    check_axis("x0", draw.x0, "x1", draw.x1);
    check_axis("y0", draw.y0, "y1", draw.y1);
    if (draw.depth < 0.0f || draw.depth > 1.0f) {
        report(findings, place.field("depth"), "must lie within 0..1" + got(draw.depth));
    }
    for (std::size_t i = 0; i < draw.uv.size(); ++i) {
        const Size size       = bound_size(frame, draw.textures[i]);
        const UvRect& uv      = draw.uv[i];
        const auto is_too_far = [](float coordinate, std::int32_t texels) {
            return std::abs(coordinate) * static_cast<float>(texels) > static_cast<float>(kMaxRectangleTexel);
        };
        if (is_too_far(uv.u0, size.width) || is_too_far(uv.u1, size.width) || is_too_far(uv.v0, size.height) ||
            is_too_far(uv.v1, size.height)) {
            report(findings, place.entry("uv", i),
                   "must stay within " + std::to_string(kMaxRectangleTexel) + " texels of the texture's origin");
        }
    }
}

void check_copy(const Frame& frame, const Pass& pass, const CopyRectangle& copy, const Place& place,
                Findings& findings) {
    const Target* source = find_target(frame, copy.source);
    const Target* target = find_target(frame, pass.color);
    const Place at       = place.field("source");
    if (!pass.color) report(findings, place, "must have a colour target to copy to: the pass names none");
    if (!copy.source) report(findings, at, "must refer to a colour target");
    if (source == nullptr || target == nullptr) return;
    if (is_depth(source->format)) report(findings, at, "must be a colour target" + got(source->format));
    if (copy.source == pass.color) report(findings, at, "must not be the target that the pass draws to");
    if (copy.halve && !keeps_bytes(source->format) && source->format != TargetFormat::R6G6B6A6) {
        report(findings, place.field("halve"), "must be false for a source of this format" + got(source->format));
    }
    if (copy.halve && copy.channels != CopyChannels::All) {
        report(findings, place.field("channels"), "must be ALL for what is halved" + got(copy.channels));
    }
    const PixelRect& from = copy.from;
    if (from.x0 < 0 || from.y0 < 0 || from.x0 >= from.x1 || from.y0 >= from.y1 || from.x1 > source->width ||
        from.y1 > source->height) {
        report(findings, place.field("from"), "must be a part of the source, and not empty");
        return;
    }
    if (copy.halve && ((from.x0 | from.y0 | from.x1 | from.y1) & 1) != 0) {
        report(findings, place.field("from"), "must have even corners to be halved");
    }
    const int step  = copy.halve ? 2 : 1;
    const auto fits = [](std::int32_t first, std::int32_t size, std::int32_t limit) {
        return first >= 0 && size <= limit && first <= limit - size;
    };
    if (!fits(copy.x, (from.x1 - from.x0) / step, target->width) ||
        !fits(copy.y, (from.y1 - from.y0) / step, target->height)) {
        report(findings, place, "must lie within the target that the pass draws to");
    }
}

}  // namespace

bool is_power_of_two(std::int32_t size) {
    return size > 0 && std::has_single_bit(static_cast<std::uint32_t>(size));
}

const Target* find_target(const Frame& frame, TargetId id) {
    return is_in_range(frame, id) ? &frame.targets[static_cast<std::size_t>(id.index)] : nullptr;
}

const Texture* find_texture(const Frame& frame, TextureId id) {
    return is_in_range(frame, id) ? &frame.textures[static_cast<std::size_t>(id.index)] : nullptr;
}

bool reads_texture(const PipelineState& state, int index) {
    if (index >= stage_count(state)) return false;
    const auto reads = [](TextureOp op, const TextureArg& arg1, const TextureArg& arg2) {
        if (op == TextureOp::Disable) return false;
        if (op == TextureOp::BlendTextureAlpha) return true;
        return (op != TextureOp::SelectArg2 && arg1.source == ArgSource::Texture) ||
               (op != TextureOp::SelectArg1 && arg2.source == ArgSource::Texture);
    };
    const TextureStage& stage = state.stages[static_cast<std::size_t>(index)];
    return reads(stage.color_op, stage.color_arg1, stage.color_arg2) ||
           reads(stage.alpha_op, stage.alpha_arg1, stage.alpha_arg2);
}

void check_draws(const Frame& frame, const Pass& pass, const Place& place, Findings& findings) {
    const auto is_copy = [](const Draw& draw) { return std::holds_alternative<CopyRectangle>(draw); };
    const auto copies  = std::count_if(pass.draws.begin(), pass.draws.end(), is_copy);
    if (copies != 0 && copies != std::ssize(pass.draws)) {
        report(findings, place.field("draws"), "must be copies all, or none of them");
    }
    if (copies != 0) {
        PipelineState limits;
        limits.viewport = pass.state.viewport;
        limits.scissor  = pass.state.scissor;
        if (pass.state != limits) {
            report(findings, place.field("state"),
                   "must be left out but for viewport and scissor: copies know no state");
        }
    }
    for (std::size_t i = 0; i < pass.draws.size(); ++i) {
        const Place here = place.entry("draws", i);
        if (const auto* triangles = std::get_if<DrawTriangles>(&pass.draws[i])) {
            if (!pass.camera) report(findings, here, "must have a camera: the pass names none");
            check_triangles(frame, *triangles, here, findings);
            check_bindings(frame, pass, triangles->textures, here, findings);
        } else if (const auto* rectangle = std::get_if<DrawRectangle>(&pass.draws[i])) {
            check_rectangle(frame, *rectangle, here, findings);
            check_bindings(frame, pass, rectangle->textures, here, findings);
        } else if (const auto* window = std::get_if<DrawWindowTriangles>(&pass.draws[i])) {
            check_triangles(frame, *window, here, findings);
            check_bindings(frame, pass, window->textures, here, findings);
        } else {
            check_copy(frame, pass, std::get<CopyRectangle>(pass.draws[i]), here, findings);
        }
    }
}

}  // namespace pipeline
