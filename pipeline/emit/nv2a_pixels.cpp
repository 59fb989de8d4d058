// SPDX-License-Identifier: MIT
#include "pipeline/emit/nv2a_pixels.h"

#include <algorithm>

#include "pipeline/check/target_use.h"
#include "pipeline/emit/nv2a_values.h"
#include "pipeline/legalize/window_map.h"

namespace pipeline {
namespace {

const Target& target_of(const Frame& frame, TargetId id) {
    return frame.targets[static_cast<std::size_t>(id.index)];
}

PixelRect whole(const Target& target) {
    return {0, 0, target.width, target.height};
}

// From the first to the last, both of them pixels of the part.
std::uint32_t span_of(const Nv2aField& first, const Nv2aField& last, std::int32_t from, std::int32_t to) {
    return pack(first, static_cast<std::uint32_t>(from)) | pack(last, static_cast<std::uint32_t>(to - 1));
}

std::string span_text(std::string_view axis, std::int32_t from, std::int32_t to) {
    return std::string(axis) + ' ' + std::to_string(from) + ".." + std::to_string(to - 1);
}

// The format that stands beside the other where the pass has no such target: as many bits a pixel.
TargetFormat color_beside(TargetFormat zeta) {
    return zeta == TargetFormat::D16 ? TargetFormat::R5G6B5 : TargetFormat::A8R8G8B8;
}
TargetFormat zeta_beside(TargetFormat color) {
    return color == TargetFormat::R5G6B5 ? TargetFormat::D16 : TargetFormat::D24;
}

void set_clear_rect(Nv2aStream& out, const PixelRect& part) {
    out.set(nv097::SET_CLEAR_RECT_HORIZONTAL, {span_of(nv097::CLEAR_RECT_MIN, nv097::CLEAR_RECT_MAX, part.x0, part.x1)},
            span_text("x", part.x0, part.x1));
    out.set(nv097::SET_CLEAR_RECT_VERTICAL, {span_of(nv097::CLEAR_RECT_MIN, nv097::CLEAR_RECT_MAX, part.y0, part.y1)},
            span_text("y", part.y0, part.y1));
}

std::uint32_t zeta_flags(TargetFormat format) {
    return format == TargetFormat::D16 ? nv097::CLEAR_SURFACE_Z : nv097::CLEAR_SURFACE_Z | nv097::CLEAR_SURFACE_STENCIL;
}

// Does the pass need what is in the target?
bool reads(const Pass& pass, TargetId id) {
    bool found = false;
    for_each_texture(
        pass, [&](std::size_t, std::size_t, const TextureBinding& binding) { found = found || binding.target == id; });
    return found || std::any_of(pass.draws.begin(), pass.draws.end(), [&](const Draw& draw) {
               const auto* copy = std::get_if<CopyRectangle>(&draw);
               return copy != nullptr && copy->source == id;
           });
}

bool needs_zeros(const Frame& frame, TargetId id) {
    for (const Pass& pass : frame.passes) {
        if (reads(pass, id)) return true;
        if (pass.color != id && pass.depth != id) continue;
        const bool clears = pass.color == id ? pass.clear.color.has_value() : pass.clear.depth.has_value();
        return !clears || drawn_part(frame, pass) != whole(target_of(frame, id));
    }
    return id == frame.output;
}

}  // namespace

void set_surfaces(Nv2aStream& out, const Frame& frame, const Nv2aMemory& memory, TargetId color, TargetId depth) {
    const Target& size              = target_of(frame, color ? color : depth);
    const TargetFormat color_format = color ? target_of(frame, color).format : color_beside(size.format);
    const TargetFormat zeta_format  = depth ? target_of(frame, depth).format : zeta_beside(size.format);
    const Nv2aValue color_value = nv2a_surface_color(color_format), zeta_value = nv2a_surface_zeta(zeta_format);
    const Nv2aPlace& either = memory.of(color ? color : depth);
    const Nv2aPlace no_color{0, either.pitch, "no colour target: masked"},
        no_zeta{0, either.pitch, "no depth target: no test, masked"};
    const Nv2aPlace &color_place = color ? memory.of(color) : no_color,
                    &zeta_place  = depth ? memory.of(depth) : no_zeta;

    const auto extent = [&](const Nv2aMethod& method, std::int32_t pixels, std::string_view what) {
        out.set(
            method,
            {pack(nv097::SURFACE_CLIP_FIRST, 0) | pack(nv097::SURFACE_CLIP_SIZE, static_cast<std::uint32_t>(pixels))},
            std::to_string(pixels) + std::string(what));
    };
    extent(nv097::SET_SURFACE_CLIP_HORIZONTAL, size.width, " pixels from x = 0 on");
    extent(nv097::SET_SURFACE_CLIP_VERTICAL, size.height, " pixels from y = 0 on");
    out.set(nv097::SET_SURFACE_FORMAT,
            {pack(nv097::SURFACE_FORMAT_COLOR, color_value.value) | pack(nv097::SURFACE_FORMAT_ZETA, zeta_value.value) |
             pack(nv097::SURFACE_FORMAT_TYPE, nv097::SURFACE_FORMAT_TYPE_PITCH)},
            std::string(color_value.name) + ", " + std::string(zeta_value.name) + ", PITCH, one sample a pixel");
    out.set(nv097::SET_SURFACE_PITCH,
            {pack(nv097::SURFACE_PITCH_COLOR, color_place.pitch) | pack(nv097::SURFACE_PITCH_ZETA, zeta_place.pitch)},
            "colour " + std::to_string(color_place.pitch) + " bytes, zeta " + std::to_string(zeta_place.pitch));
    out.set(nv097::SET_SURFACE_COLOR_OFFSET, {color_place.address}, color_place.what);
    out.set(nv097::SET_SURFACE_ZETA_OFFSET, {zeta_place.address}, zeta_place.what);
    out.set(nv097::SET_CONTROL0, {pack(nv097::CONTROL0_TEXTURE_PERSPECTIVE_ENABLE, 1)},
            "depth is fixed and linear, no stencil; textures in perspective");
    const float greatest[] = {nv2a_greatest_depth(zeta_format)}, least[] = {0.0f};
    out.set_floats(nv097::SET_CLIP_MIN, 0, least, "depth units");
    out.set_floats(nv097::SET_CLIP_MAX, 0, greatest, "depth units");
    if (color && depth && bytes_per_pixel(color_format) != bytes_per_pixel(zeta_format))
        out.note("Not known: whether colour and depth of different bits a pixel go together.");
}

PixelRect drawn_part(const Frame& frame, const Pass& pass) {
    const PixelRect viewport = viewport_of(frame, pass), &scissor = pass.state.scissor;
    if (scissor == PixelRect{}) return viewport;
    const PixelRect part = {std::max(viewport.x0, scissor.x0), std::max(viewport.y0, scissor.y0),
                            std::min(viewport.x1, scissor.x1), std::min(viewport.y1, scissor.y1)};
    return part.x0 < part.x1 && part.y0 < part.y1 ? part : PixelRect{};
}

void set_window_clip(Nv2aStream& out, const PixelRect& part) {
    const std::uint32_t x = span_of(nv097::WINDOW_CLIP_MIN, nv097::WINDOW_CLIP_MAX, part.x0, part.x1),
                        y = span_of(nv097::WINDOW_CLIP_MIN, nv097::WINDOW_CLIP_MAX, part.y0, part.y1);
    out.set(nv097::SET_WINDOW_CLIP_TYPE, {0}, "inclusive");
    out.set(nv097::SET_WINDOW_CLIP_HORIZONTAL, {x, x, x, x, x, x, x, x}, span_text("x", part.x0, part.x1));
    out.set(nv097::SET_WINDOW_CLIP_VERTICAL, {y, y, y, y, y, y, y, y}, span_text("y", part.y0, part.y1));
}

void clear(Nv2aStream& out, const Frame& frame, const Pass& pass, const PixelRect& part) {
    std::uint32_t flags = 0;
    std::string what;
    if (pass.clear.color) {
        out.set(nv097::SET_COLOR_CLEAR_VALUE,
                {nv2a_clear_color(target_of(frame, pass.color).format, *pass.clear.color)},
                hex(pass.clear.color->value) + " (ARGB) in the target's format");
        flags |= nv097::CLEAR_SURFACE_COLOR;
        what = "red, green, blue, alpha";
    }
    if (pass.clear.depth) {
        const TargetFormat format = target_of(frame, pass.depth).format;
        const float depth[]       = {*pass.clear.depth};
        out.set(nv097::SET_ZSTENCIL_CLEAR_VALUE, {nv2a_clear_depth(format, depth[0])},
                "depth " + numbers(depth) + (format == TargetFormat::D16 ? "" : ", stencil 0"));
        flags |= zeta_flags(format);
        what += what.empty() ? "depth" : ", depth";
    }
    if (flags == 0) return;
    set_clear_rect(out, part);
    out.act(nv097::CLEAR_SURFACE, flags, what);
}

void set_unused_state(Nv2aStream& out) {
    out.set(nv097::SET_TRANSFORM_EXECUTION_MODE,
            {pack(nv097::TRANSFORM_EXECUTION_MODE_RANGE_MODE, nv097::RANGE_MODE_PRIV)}, "fixed function");
    out.set(nv097::SET_SKIN_MODE, {0}, "off");
    for (const Nv2aMethod& method :
         {nv097::SET_DITHER_ENABLE, nv097::SET_STENCIL_TEST_ENABLE, nv097::SET_LOGIC_OP_ENABLE,
          nv097::SET_POINT_PARAMS_ENABLE, nv097::SET_POINT_SMOOTH_ENABLE, nv097::SET_LINE_SMOOTH_ENABLE,
          nv097::SET_POLY_SMOOTH_ENABLE, nv097::SET_POLY_OFFSET_FILL_ENABLE})
        out.set_flag(method, false);
    out.set(nv097::SET_ANTI_ALIASING_CONTROL, {nv097::ANTI_ALIASING_CONTROL_OFF}, "off");
    out.set(nv097::SET_FRONT_POLYGON_MODE, {nv097::POLYGON_MODE_V_FILL}, "FILL");
    out.set(nv097::SET_BACK_POLYGON_MODE, {nv097::POLYGON_MODE_V_FILL}, "FILL");
    out.set(nv097::SET_ZMIN_MAX_CONTROL, {nv097::ZMIN_MAX_CONTROL_CULL_NEAR_FAR},
            "what is nearer or farther than CLIP_MIN..CLIP_MAX is dropped");
}

void set_pixel_state(Nv2aStream& out, const Pass& pass) {
    const PipelineState& state = pass.state;
    out.set_flag(nv097::SET_BLEND_ENABLE, state.blend != kReplace);
    out.set(nv097::SET_BLEND_FUNC_SFACTOR, nv2a_blend_factor(state.blend.source));
    out.set(nv097::SET_BLEND_FUNC_DFACTOR, nv2a_blend_factor(state.blend.dest));
    out.set(nv097::SET_BLEND_EQUATION, {nv097::BLEND_EQUATION_V_FUNC_ADD}, "FUNC_ADD");

    const ColorMask mask = pass.color ? state.color_mask : ColorMask{false, false, false, false};
    out.set(
        nv097::SET_COLOR_MASK,
        {pack(nv097::COLOR_MASK_BLUE_WRITE_ENABLE, mask.blue) | pack(nv097::COLOR_MASK_GREEN_WRITE_ENABLE, mask.green) |
         pack(nv097::COLOR_MASK_RED_WRITE_ENABLE, mask.red) | pack(nv097::COLOR_MASK_ALPHA_WRITE_ENABLE, mask.alpha)},
        std::string("writes ") + (mask.alpha ? "A" : "-") + (mask.red ? "R" : "-") + (mask.green ? "G" : "-") +
            (mask.blue ? "B" : "-"));

    const bool meets_depth = state.depth.func != CompareFunc::Always || state.depth.write;
    out.set_flag(nv097::SET_DEPTH_TEST_ENABLE, meets_depth);
    out.set(nv097::SET_DEPTH_FUNC, nv2a_compare(state.depth.func));
    out.set_flag(nv097::SET_DEPTH_MASK, state.depth.write);

    out.set_flag(nv097::SET_ALPHA_TEST_ENABLE, state.alpha_test.func != CompareFunc::Always);
    out.set(nv097::SET_ALPHA_FUNC, nv2a_compare(state.alpha_test.func));
    out.set(nv097::SET_ALPHA_REF, {state.alpha_test.reference}, std::to_string(state.alpha_test.reference));

    out.set(nv097::SET_SHADE_MODE, nv2a_shade_mode(state.shade));
    out.set(nv097::SET_PROVOKING_VERTEX, {1}, "FIRST");
}

void set_culling(Nv2aStream& out, CullMode cull) {
    out.set_flag(nv097::SET_CULL_FACE_ENABLE, cull != CullMode::None);
    if (cull == CullMode::None) return;
    out.set(nv097::SET_FRONT_FACE, {nv097::FRONT_FACE_V_CW}, "CW");
    const Nv2aValue face = nv2a_culled_face(cull);
    out.set(nv097::SET_CULL_FACE, {face.value},
            std::string(face.name) + (cull == CullMode::Clockwise ? ": drops clockwise" : ": drops counterclockwise"));
}

void clear_to_zeros(Nv2aStream& out, const Frame& frame, const Nv2aMemory& memory) {
    bool is_first = true;
    for (std::size_t i = 0; i < frame.targets.size(); ++i) {
        const TargetId id{static_cast<std::int32_t>(i)};
        if (!needs_zeros(frame, id)) continue;
        if (is_first) out.section("targets that begin with zeros");
        is_first             = false;
        const Target& target = frame.targets[i];
        const bool is_zeta   = is_depth(target.format);
        set_surfaces(out, frame, memory, is_zeta ? TargetId{} : id, is_zeta ? id : TargetId{});
        set_window_clip(out, whole(target));
        set_clear_rect(out, whole(target));
        out.set(nv097::SET_COLOR_CLEAR_VALUE, {0}, "zero");
        out.set(nv097::SET_ZSTENCIL_CLEAR_VALUE, {0}, "zero");
        out.act(nv097::CLEAR_SURFACE, is_zeta ? zeta_flags(target.format) : nv097::CLEAR_SURFACE_COLOR,
                memory.of(id).what);
    }
}

void copy(Nv2aStream& out, const Frame& frame, const Nv2aMemory& memory, const CopyRectangle& copy, TargetId to) {
    const Nv2aPlace &source = memory.of(copy.source), &dest = memory.of(to);
    const auto pair = [](std::int32_t low, std::int32_t high) {
        return pack(nv09f::LOW, static_cast<std::uint32_t>(low)) | pack(nv09f::HIGH, static_cast<std::uint32_t>(high));
    };
    const auto point      = [](std::int32_t x, std::int32_t y) { return std::to_string(x) + ", " + std::to_string(y); };
    const PixelRect& from = copy.from;
    const Nv2aValue format = nv2a_blit_format(target_of(frame, to).format);
    out.act(nv062::SET_COLOR_FORMAT, format.value, format.name);
    out.act(nv062::SET_PITCH, pack(nv062::PITCH_SOURCE, source.pitch) | pack(nv062::PITCH_DESTIN, dest.pitch),
            "from rows of " + std::to_string(source.pitch) + " bytes to rows of " + std::to_string(dest.pitch));
    out.act(nv062::SET_OFFSET_SOURCE, source.address, source.what);
    out.act(nv062::SET_OFFSET_DESTIN, dest.address, dest.what);
    out.act(nv09f::SET_OPERATION, nv09f::OPERATION_SRCCOPY, "SRCCOPY");
    out.act(nv09f::CONTROL_POINT_IN, pair(from.x0, from.y0), "from " + point(from.x0, from.y0));
    out.act(nv09f::CONTROL_POINT_OUT, pair(copy.x, copy.y), "to " + point(copy.x, copy.y));
    out.act(nv09f::SIZE, pair(from.x1 - from.x0, from.y1 - from.y0),
            point(from.x1 - from.x0, from.y1 - from.y0) + " pixels");
}

}  // namespace pipeline
