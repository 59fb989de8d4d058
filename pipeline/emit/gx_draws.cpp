// SPDX-License-Identifier: MIT
// A draw: what it needs of the chip, and its vertices.
#include <algorithm>
#include <set>
#include <stdexcept>

#include "pipeline/emit/gx_passes.h"

namespace pipeline {

namespace {

constexpr std::string_view kNone = "NONE";

// "POSITIONS + 12u * 34u"
std::string array_from(std::string_view name, int stride, std::uint32_t first) {
    if (first == 0) return std::string(name);
    return std::string(name) + " + " + std::to_string(stride) + "u * " + std::to_string(first) + 'u';
}

std::string draw_place(std::size_t pass, std::size_t draw) {
    return "pass " + std::to_string(pass) + ", draw " + std::to_string(draw);
}

}  // namespace

GxDraws::GxDraws(GxFrame& gx, std::size_t pass, const BufferSpot& spot, CText& text)
    : gx_(gx), pass_(gx.frame.passes[pass]), pass_index_(pass), spot_(spot), text_(text) {
    target_ = gx.frame.targets[static_cast<std::size_t>((pass_.color ? pass_.color : pass_.depth).index)];
    viewport_ =
        pass_.state.viewport == PixelRect{} ? PixelRect{0, 0, target_.width, target_.height} : pass_.state.viewport;
}

void GxDraws::write(std::string& last, CText& calls) {
    std::string now = calls.take();
    if (now == last) return;
    last = now;
    for (std::size_t at = 0, end = 0; at < now.size(); at = end + 1) {
        end = now.find('\n', at);
        text_.line(std::string_view(now).substr(at, end - at));
    }
}

TexelKind GxDraws::kind_of(std::size_t stage, const TextureBinding& binding) const {
    if (!reads_texture(pass_.state, static_cast<int>(stage))) return TexelKind::White;
    if (binding.target) return TexelKind::Color;
    if (!binding.texture) return TexelKind::White;
    switch (gx_.frame.textures[static_cast<std::size_t>(binding.texture.index)].format) {
        case TextureFormat::A8:
            return TexelKind::Alpha;
        case TextureFormat::L8:
            return TexelKind::Luminance;
        case TextureFormat::A8R8G8B8:
            return TexelKind::Color;
    }
    return TexelKind::White;
}

TevInputs GxDraws::inputs_of(const TextureBindings& textures) const {
    TevInputs inputs;
    for (std::size_t i = 0; i < textures.size(); ++i) inputs.texels[i] = kind_of(i, textures[i]);
    return inputs;
}

// The vertex's pairs that go to TEX0 and TEX1.
std::vector<int> GxDraws::uv_sets(const TevProgram& program) const {
    std::set<int> sets;
    for (std::size_t i = 0; i < kTextureStages; ++i) {
        const CoordSource coords = pass_.state.stages[i].coords;
        if (program.reads(static_cast<int>(i)) && coords != CoordSource::CameraPosition)
            sets.insert(coords == CoordSource::Vertex0 ? 0 : 1);
    }
    return {sets.begin(), sets.end()};
}

void GxDraws::part(const GxPart& part, const std::string& what, const TevProgram& program,
                   const VertexColorist& colorist, const GxLighting* lighting) {
    const bool is_lit_here    = pass_.state.lighting.enabled && lighting == nullptr;
    const bool has_second     = program.reads_specular || program.reads_fog;
    const bool has_own_second = has_second && (program.reads_fog || pass_.state.lighting.enabled);
    std::string colors0       = array_from("COLORS0", 4, part.first), colors1(kNone);
    if (is_lit_here || has_own_second) {
        std::vector<VertexBytes> colors(part.vertices, VertexBytes{Argb{0}, Argb{0}});
        for (const std::uint16_t index : part.indices)
            colors[index] = colorist(gx_.vertices.vertex(part.first + index));
        const auto add = [&](std::string_view name, Argb VertexBytes::*color) {
            std::vector<std::uint8_t> bytes;
            for (const VertexBytes& of_vertex : colors) put_rgba(bytes, of_vertex.*color);
            return std::to_string(gx_.data.add(std::string(name) + " of " + what, bytes)) + 'u';
        };
        if (is_lit_here) colors0 = add("colours", &VertexBytes::first);
        if (has_own_second) colors1 = add("specular and fog", &VertexBytes::second);
    }
    if (has_second && !has_own_second) {
        colors1          = array_from("COLORS1", 4, part.first);
        gx_.uses_colors1 = true;
    }
    if (!is_lit_here) gx_.uses_colors0 = true;
    if (lighting != nullptr) gx_.uses_normals = true;
    std::array<std::string, 2> tex{std::string(kNone), std::string(kNone)};
    const std::vector<int> sets = uv_sets(program);
    for (std::size_t i = 0; i < sets.size(); ++i) {
        tex[i]                                         = array_from(sets[i] == 0 ? "UV0" : "UV1", 8, part.first);
        gx_.uses_uv[static_cast<std::size_t>(sets[i])] = true;
    }
    CText arrays;
    arrays.call("vertex_arrays", {array_from("POSITIONS", 12, part.first),
                                  lighting != nullptr ? array_from("NORMALS", 12, part.first) : std::string(kNone),
                                  colors0, colors1, tex[0], tex[1]});
    write(last_arrays_, arrays);
    std::vector<std::uint8_t> indices;
    for (const std::uint16_t index : part.indices) put_u16(indices, index);
    text_.call("triangles", {std::to_string(gx_.data.add("indices of " + what, indices)) + 'u',
                             c_int(static_cast<std::int64_t>(part.indices.size()))});
}

void GxDraws::emit(const DrawTriangles& draw, std::size_t index) {
    const std::string what = draw_place(pass_index_, index);
    if (draw.index_count < 3) return;
    const Camera& camera                       = gx_.frame.cameras[static_cast<std::size_t>(pass_.camera.index)];
    const std::optional<GxTransform> transform = gx_transform(camera, draw.world);
    if (!transform)
        throw std::invalid_argument(what + " of '" + pass_.label +
                                    "': GX has no projection whose depth, times w, is not a multiple "
                                    "of w and a constant");
    const auto indices                       = std::span(gx_.frame.indices).subspan(draw.first_index, draw.index_count);
    const std::optional<GxLighting> lighting = chip_lighting(gx_.frame, pass_, draw, indices, *transform);
    const GxLighting* chip                   = lighting ? &*lighting : nullptr;
    const Fog fog                            = fog_of(*transform);
    TevInputs inputs                         = inputs_of(draw.textures);
    inputs.has_vertex_fog                    = fog.is_vertex;
    const TevProgram program                 = tev_program(pass_.state, inputs);
    text_.comment("draw " + c_int(static_cast<std::int64_t>(index)) + ": " + c_int(draw.index_count / 3) +
                  " triangles");
    space_of_triangles(draw, *transform, fog);
    channels(program.reads_specular || program.reads_fog, chip);
    coordinates(program, &draw);
    stages(program, draw.textures);
    const VertexColorist colorist(gx_.frame, pass_, draw);
    for (const GxPart& of_draw : gx_.vertices.parts(draw.first_index, draw.index_count))
        part(of_draw, what, program, colorist, chip);
}

void GxDraws::emit(const DrawRectangle& draw, std::size_t index) {
    TevInputs inputs         = inputs_of(draw.textures);
    inputs.is_rectangle      = true;
    const TevProgram program = tev_program(pass_.state, inputs);
    text_.comment("draw " + c_int(static_cast<std::int64_t>(index)) + ": rectangle");
    space_of_rectangle();
    channels(false, nullptr);
    coordinates(program, nullptr);
    stages(program, draw.textures);
    std::array<std::string, kTextureStages> uv{"NULL", "NULL"};
    std::size_t slot = 0;
    for (std::size_t i = 0; i < kTextureStages; ++i) {
        if (!program.reads(static_cast<int>(i))) continue;
        const UvRect& rect = draw.uv[i];
        uv[slot++] = "(const f32[]){ " + c_float(rect.u0) + ", " + c_float(rect.v0) + ", " + c_float(rect.u1) + ", " +
                     c_float(rect.v1) + " }";
    }
    last_arrays_.clear();  // its own description of vertices
    text_.call("rectangle", {c_float(draw.x0), c_float(draw.y0), c_float(draw.x1), c_float(draw.y1),
                             c_float(draw.depth), c_rgba(draw.color), uv[0], uv[1]});
}

}  // namespace pipeline
