// SPDX-License-Identifier: MIT
#include "pipeline/emit/gs_triangles.h"

#include <bit>
#include <cmath>
#include <stdexcept>

#include "pipeline/emit/gs_sprites.h"
#include "pipeline/validate/check_pass.h"

namespace pipeline {

namespace {

// What the vertices of a draw have besides a colour and a place. scale_s, scale_t: a texture's size over the power of two that
// TEX0 names, 1 for most.
struct VertexForm {
    bool textured = false, fogged = false, fog_by_itself = false;
    double scale_s = 1.0, scale_t = 1.0;
};

std::uint64_t window_register(float pixels) {
    const std::int64_t value = window_sixteenths(pixels) + kGsWindowOrigin;
    if (value < 0 || value > 0xffff)
        throw std::invalid_argument("a triangle's corner lies at " + std::to_string(pixels) +
                                    " pixels, where the Graphics Synthesizer's registers hold -2048..2047.9375");
    return static_cast<std::uint64_t>(value);
}

std::uint32_t bits_of(float value) {
    return std::bit_cast<std::uint32_t>(value);
}

// Rounded once more where the scale is not one.
std::uint32_t scaled_bits(float value, double scale) {
    return bits_of(scale == 1.0 ? value : static_cast<float>(value * scale));
}

void emit_vertex(const WindowVertex& vertex, std::uint32_t depth, const VertexForm& form, GsBuilder& out) {
    const float s = vertex.uv0.x * vertex.rhw, t = vertex.uv0.y * vertex.rhw, q = vertex.uv0.z * vertex.rhw;
    const std::uint32_t color = vertex.diffuse.value, fog = vertex.specular.value >> 24;
    if (form.textured) out.write(GsReg::St, {{"S", scaled_bits(s, form.scale_s)}, {"T", scaled_bits(t, form.scale_t)}});
    out.write(GsReg::Rgbaq, {{"R", color >> 16 & 255},
                             {"G", color >> 8 & 255},
                             {"B", color & 255},
                             {"A", color >> 24},
                             {"Q", form.textured ? bits_of(q) : bits_of(1.0f)}});
    const std::uint64_t x = window_register(vertex.x), y = window_register(vertex.y);
    if (form.fogged && !form.fog_by_itself) {
        out.write(GsReg::Xyzf2, {{"X", x}, {"Y", y}, {"Z", depth}, {"F", fog}});
        return;
    }
    if (form.fogged) out.write(GsReg::Fog, {{"F", fog}});
    out.write(GsReg::Xyz2, {{"X", x}, {"Y", y}, {"Z", depth}});
}

}  // namespace

void emit_triangles(const Frame& frame, const GsMemory& memory, const Pass& pass, const DrawWindowTriangles& draw,
                    GsBuilder& out) {
    const std::optional<GsFunction> function = texture_function(pass.state);
    const Target* depth                      = find_target(frame, pass.depth);
    VertexForm form{.textured = function.has_value(), .fogged = pass.state.fog.mode != FogMode::None};
    // XYZF2 holds 24 bits of depth.
    form.fog_by_itself = depth != nullptr && depth->format == TargetFormat::D32;
    if (function) {
        const TextureStage& stage = pass.state.stages[0];
        const GsTexture texture   = bound_texture(frame, memory, draw.textures[0]);
        set_texture(texture, *function, stage.filter == TextureFilter::Linear, stage.address_u == TextureAddress::Wrap,
                    stage.address_v == TextureAddress::Wrap, out);
        form.scale_s = std::ldexp(texture.surface.width, -static_cast<int>(log2_size(texture.surface.width)));
        form.scale_t = std::ldexp(texture.surface.height, -static_cast<int>(log2_size(texture.surface.height)));
    }
    constexpr std::uint64_t kTriangle = 3;
    out.write(GsReg::Prim, {{"PRIM", kTriangle},
                            {"IIP", 1},
                            {"TME", form.textured},
                            {"FGE", form.fogged},
                            {"ABE", blends(pass.state.gs_blend)}});
    for (std::uint32_t i = draw.first_index; i < draw.first_index + draw.index_count; ++i) {
        const WindowVertex& vertex = frame.window_vertices[frame.indices[i]];
        emit_vertex(vertex, depth_units(frame, pass, vertex.z), form, out);
    }
}

}  // namespace pipeline
