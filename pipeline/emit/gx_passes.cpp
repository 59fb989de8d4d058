// SPDX-License-Identifier: MIT
#include "pipeline/emit/gx_passes.h"

#include <algorithm>

#include "pipeline/emit/gx_names.h"
#include "pipeline/profile/profile.h"

namespace pipeline {

namespace {

std::size_t index_of(TargetId id) {
    return static_cast<std::size_t>(id.index);
}

PixelRect whole(const Target& target) {
    return {0, 0, target.width, target.height};
}
PixelRect or_whole(const PixelRect& part, const Target& target) {
    return part == PixelRect{} ? whole(target) : part;
}
PixelRect common(const PixelRect& a, const PixelRect& b) {
    return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}
bool is_empty(const PixelRect& rect) {
    return rect.x0 >= rect.x1 || rect.y0 >= rect.y1;
}

// What viewport and scissor leave of a target.
PixelRect drawn_part(const PipelineState& state, const Target& target) {
    return common(or_whole(state.viewport, target), or_whole(state.scissor, target));
}

std::string boolean(bool value) {
    return value ? "GX_TRUE" : "GX_FALSE";
}

struct Wipe {
    std::optional<Argb> color;
    std::optional<float> depth;
};

void emit_wipe(const BufferSpot& spot, const PixelRect& part, const Wipe& wipe, CText& text) {
    text.call("clear_pixels",
              {c_int(spot.x + part.x0), c_int(spot.y + part.y0), c_int(part.x1 - part.x0), c_int(part.y1 - part.y0),
               boolean(wipe.color.has_value()), c_rgba(wipe.color.value_or(Argb{0})), boolean(wipe.depth.has_value()),
               c_float(wipe.depth.value_or(0.0f))});
}

// Both at once where they lie at the same pixels.
void emit_wipes(const GxFrame& gx, const Pass& pass, const PixelRect& part, const Wipe& wipe, CText& text) {
    const auto spot_of = [&](TargetId id) { return *gx.places.spots[index_of(id)]; };
    if (is_empty(part)) return;
    if (wipe.color && wipe.depth) {
        const BufferSpot color = spot_of(pass.color), depth = spot_of(pass.depth);
        if (color.x == depth.x && color.y == depth.y) return emit_wipe(color, part, wipe, text);
    }
    if (wipe.color) emit_wipe(spot_of(pass.color), part, {wipe.color, {}}, text);
    if (wipe.depth) emit_wipe(spot_of(pass.depth), part, {{}, wipe.depth}, text);
}

// Of a target in the frame buffer, whose memory another may have had until this pass.
const PixelRegion& zeros_of(const GxFrame& gx, std::size_t pass, TargetId id) {
    static const PixelRegion kNone;
    return id && gx.is_in_buffer[index_of(id)] ? gx.zeros[index_of(id)][pass] : kNone;
}

// Where the color or the depth begins so; `wipe` says which.
void emit_zeros(const GxFrame& gx, std::size_t pass, TargetId id, const Wipe& wipe, CText& text) {
    const PixelRegion& zeros = zeros_of(gx, pass, id);
    if (!zeros.empty()) text.comment("pixels begin as zeros");
    for (const PixelRect& part : zeros.parts()) emit_wipe(*gx.places.spots[index_of(id)], part, wipe, text);
}

void emit_clears(const GxFrame& gx, std::size_t index, CText& text) {
    const Pass& pass     = gx.frame.passes[index];
    const Target& target = gx.frame.targets[index_of(pass.color ? pass.color : pass.depth)];
    const PixelRect part = drawn_part(pass.state, target);
    emit_zeros(gx, index, pass.color, {Argb{0}, {}}, text);
    emit_zeros(gx, index, pass.depth, {{}, 0.0f}, text);
    if (!pass.clear.color && !pass.clear.depth) return;
    text.comment("clear");
    emit_wipes(gx, pass, part, {pass.clear.color, pass.clear.depth}, text);
}

void emit_pixel_format(TargetFormat format, std::string_view& current, CText& text) {
    const std::string_view name = gx_pixel_format(format);
    if (name == current) return;
    current = name;
    text.call("GX_SetPixelFmt", {name, "GX_ZC_LINEAR"});
}

void emit_copies(const GxFrame& gx, std::size_t index, std::string_view& pixel_format, CText& text) {
    constexpr std::int32_t kTile = 4, kTileBytes = 64;
    const Pass& pass = gx.frame.passes[index];
    const Target& to = gx.frame.targets[index_of(pass.color)];
    for (const Draw& draw : pass.draws) {
        const auto& copy        = std::get<CopyRectangle>(draw);
        const Target& from      = gx.frame.targets[index_of(copy.source)];
        const BufferSpot spot   = *gx.places.spots[index_of(copy.source)];
        const std::int32_t row  = (to.width + kTile - 1) / kTile;
        const std::int32_t tile = copy.y / kTile * row + copy.x / kTile;
        emit_pixel_format(from.format, pixel_format, text);
        emit_zeros(gx, index, copy.source, {Argb{0}, {}}, text);
        text.comment("target " + c_int(copy.source.index) + " '" + from.name + "' to (" + c_int(copy.x) + ", " +
                     c_int(copy.y) + ")");
        text.call("copy_pixels", {c_int(spot.x + copy.from.x0), c_int(spot.y + copy.from.y0),
                                  c_int(copy.from.x1 - copy.from.x0), c_int(copy.from.y1 - copy.from.y0),
                                  gx_target_name(index_of(pass.color)) + " + " + c_int(std::int64_t{tile} * kTileBytes),
                                  c_int(to.width), c_int(to.height), boolean(copy.halve)});
    }
    text.line("finish_copies();");
}

// State that all draws of a pass share.
void emit_state(const Pass& pass, const BufferSpot& spot, const PixelRect& part, CText& text) {
    const PipelineState& state = pass.state;
    const bool is_blended = state.blend != kReplace, has_color = static_cast<bool>(pass.color);
    const bool tests_depth = pass.depth && (state.depth.func != CompareFunc::Always || state.depth.write);
    const bool tests_alpha = state.alpha_test.func != CompareFunc::Always;
    text.call("GX_SetScissor",
              {c_int(spot.x + part.x0), c_int(spot.y + part.y0), c_int(part.x1 - part.x0), c_int(part.y1 - part.y0)});
    text.call("GX_SetBlendMode", {is_blended ? "GX_BM_BLEND" : "GX_BM_NONE", gx_source_factor(state.blend.source),
                                  gx_dest_factor(state.blend.dest), "GX_LO_COPY"});
    text.call("GX_SetColorUpdate", {boolean(has_color && state.color_mask.red)});
    text.call("GX_SetAlphaUpdate", {boolean(has_color && state.color_mask.alpha)});
    text.call("GX_SetDither", {boolean(state.dither.mode == DitherMode::Flipper2x2)});
    text.call("GX_SetZMode",
              {boolean(tests_depth), gx_compare(state.depth.func), boolean(tests_depth && state.depth.write)});
    text.call("GX_SetZCompLoc", {boolean(!tests_alpha)});
    text.call("GX_SetAlphaCompare",
              {gx_compare(state.alpha_test.func), c_int(state.alpha_test.reference), "GX_AOP_AND", "GX_ALWAYS", "0"});
    if (stage_count(state) > 0) text.call("GX_SetTevColor", {"GX_TEVREG0", c_color(state.texture_factor)});
    if (state.fog.mode != FogMode::None) text.call("GX_SetTevColor", {"GX_TEVREG2", c_color(state.fog.color)});
}

void emit_draws(GxFrame& gx, std::size_t index, CText& text) {
    const Pass& pass      = gx.frame.passes[index];
    const TargetId drawn  = pass.color ? pass.color : pass.depth;
    const Target& target  = gx.frame.targets[index_of(drawn)];
    const BufferSpot spot = *gx.places.spots[index_of(drawn)];
    const PixelRect part  = drawn_part(pass.state, target);
    if (is_empty(part)) return text.comment("nothing: viewport and scissor have no pixel in common");
    emit_state(pass, spot, part, text);
    GxDraws draws(gx, index, spot, text);
    for (std::size_t i = 0; i < pass.draws.size(); ++i) {
        if (const auto* triangles = std::get_if<DrawTriangles>(&pass.draws[i]))
            draws.emit(*triangles, i);
        else
            draws.emit(std::get<DrawRectangle>(pass.draws[i]), i);
    }
}

std::vector<bool> targets_in_buffer(const Frame& frame) {
    const std::vector<TargetFormat>& drawn = find_profile("gamecube")->formats.draw;
    std::vector<bool> is_in_buffer;
    for (const Target& target : frame.targets)
        is_in_buffer.push_back(is_depth(target.format) ||
                               std::find(drawn.begin(), drawn.end(), target.format) != drawn.end());
    return is_in_buffer;
}

}  // namespace

GxFrame::GxFrame(const Frame& of)
    : frame(of),
      is_in_buffer(targets_in_buffer(of)),
      places([&] {
          const ChipLimits& limits = find_profile("gamecube")->limits;
          return place_targets(of, is_in_buffer, limits.frame_buffer_width, limits.copy_from_step);
      }()),
      zeros(of.targets.size()),
      vertices(of) {
    for (std::size_t i = 0; i < zeros.size(); ++i)
        if (is_in_buffer[i]) zeros[i] = pixels_used_as_zeros(of, {static_cast<std::int32_t>(i)});
    for (const Texture& texture : of.textures)
        texels.push_back(data.add("texture '" + texture.name + "', " + std::string(enum_name(texture.format)) + ' ' +
                                      c_int(texture.width) + 'x' + c_int(texture.height),
                                  gx_texels(texture)));
}

std::string gx_target_name(std::size_t index) {
    return "target_" + std::to_string(index);
}

std::uint64_t gx_target_bytes(const Target& target) {
    const auto tiles = [](std::int32_t size) { return static_cast<std::uint64_t>((size + 3) / 4); };
    return tiles(target.width) * tiles(target.height) * 64;
}

void emit_gx_pass(GxFrame& gx, std::size_t index, std::string_view& pixel_format, CText& text) {
    const Pass& pass = gx.frame.passes[index];
    text.line();
    text.comment("pass " + c_int(static_cast<std::int64_t>(index)) + " '" + pass.label + "'");
    if (!pass.draws.empty() && is_copy(pass.draws.front())) return emit_copies(gx, index, pixel_format, text);
    if (pass.color && gx.is_in_buffer[index_of(pass.color)])
        emit_pixel_format(gx.frame.targets[index_of(pass.color)].format, pixel_format, text);
    else if (pixel_format.empty())
        emit_pixel_format(TargetFormat::X8R8G8B8, pixel_format, text);
    emit_clears(gx, index, text);
    if (!pass.draws.empty()) emit_draws(gx, index, text);
}

}  // namespace pipeline
