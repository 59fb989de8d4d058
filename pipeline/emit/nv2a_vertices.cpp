// SPDX-License-Identifier: MIT
#include <algorithm>

#include "pipeline/emit/nv2a_draw.h"
#include "pipeline/emit/nv2a_lighting.h"

namespace pipeline {
namespace {

struct Attribute {
    std::uint16_t slot;
    std::string_view name;
    std::uint32_t size, stride, address;  // numbers or bytes of one; bytes; of vertex 0
    bool is_color = false;
};

// The layouts of vertex_bytes: offsets in bytes.
constexpr std::uint32_t kVertexStride = 48, kNormal = 12, kDiffuse = 24, kSpecular = 28, kCoords[] = {32, 40};
constexpr std::uint32_t kWindowStride = 56, kWindowDiffuse = 16, kWindowSpecular = 20, kWindowCoords[] = {24, 40};
constexpr std::uint32_t kColorsStride = 8;

void append_floats(std::vector<std::uint8_t>& bytes, std::initializer_list<float> values) {
    for (const float value : values) append_float(bytes, value);
}

void set_arrays(Nv2aStream& out, const std::vector<Attribute>& attributes) {
    for (std::uint16_t slot = 0; slot < nv097::kAttributes; ++slot) {
        const auto found = std::find_if(attributes.begin(), attributes.end(),
                                        [&](const Attribute& attribute) { return attribute.slot == slot; });
        if (found == attributes.end()) {
            out.set(nv097::SET_VERTEX_DATA_ARRAY_FORMAT, slot,
                    {pack(nv097::VERTEX_DATA_ARRAY_FORMAT_TYPE, nv097::TYPE_F)}, "none");
            continue;
        }
        const Attribute& a = *found;
        out.set(nv097::SET_VERTEX_DATA_ARRAY_FORMAT, slot,
                {pack(nv097::VERTEX_DATA_ARRAY_FORMAT_TYPE, a.is_color ? nv097::TYPE_UB_D3D : nv097::TYPE_F) |
                 pack(nv097::VERTEX_DATA_ARRAY_FORMAT_SIZE, a.size) |
                 pack(nv097::VERTEX_DATA_ARRAY_FORMAT_STRIDE, a.stride)},
                std::string(a.name) + ": " + (a.is_color ? "UB_D3D x " : "F x ") + std::to_string(a.size) + ", every " +
                    std::to_string(a.stride) + " bytes");
        out.set(nv097::SET_VERTEX_DATA_ARRAY_OFFSET, slot, {a.address}, a.name);
    }
}

// The first `count` triangles' indices in a draw are within `least` .. `greatest`.
struct IndexRange {
    std::span<const std::uint32_t> indices;
    std::uint32_t least = 0, greatest = 0;
};

IndexRange range_of(const Frame& frame, std::uint32_t first, std::uint32_t count) {
    IndexRange range{.indices = std::span(frame.indices).subspan(first, count / 3 * 3)};
    if (range.indices.empty()) return range;
    const auto [least, greatest] = std::minmax_element(range.indices.begin(), range.indices.end());
    range.least                  = *least;
    range.greatest               = *greatest;
    return range;
}

// Indices count from the least, where the arrays begin; two go in a word where they have 16 bits.
void draw_triangles(Nv2aStream& out, const IndexRange& range) {
    out.act(nv097::SET_BEGIN_END, nv097::OP_TRIANGLES, "TRIANGLES");
    const auto index       = [&](std::size_t i) { return range.indices[i] - range.least; };
    const std::size_t size = range.indices.size(), paired = range.greatest - range.least > 0xffff ? 0 : size / 2 * 2;
    std::vector<std::uint32_t> words;
    words.reserve(paired / 2);
    for (std::size_t i = 0; i < paired; i += 2) words.push_back(index(i) | index(i + 1) << 16);
    out.feed(nv097::ARRAY_ELEMENT16, words, std::to_string(paired) + " indices");
    words.clear();
    for (std::size_t i = paired; i < size; ++i) words.push_back(index(i));
    out.feed(nv097::ARRAY_ELEMENT32, words, std::to_string(words.size()) + " indices");
    out.act(nv097::SET_BEGIN_END, nv097::OP_END, "END");
}

// Does the stage's texture take the vertex's coordinates?
bool reads_coordinates(const Nv2aDraw& draw, std::size_t stage) {
    if (texels_of(draw)[stage] == Nv2aTexel::Nothing) return false;
    return draw.triangles() == nullptr || draw.state().stages[stage].coords != CoordSource::CameraPosition;
}

void draw_object(Nv2aStream& out, const Nv2aDraw& draw) {
    const DrawTriangles& triangles = *draw.triangles();
    const IndexRange range         = range_of(draw.frame, triangles.first_index, triangles.index_count);
    if (range.indices.empty()) return;
    const LightingState& lighting = draw.state().lighting;
    const std::uint32_t base      = draw.arrays.vertices + range.least * kVertexStride;
    const bool on_chip            = lights_on_chip(lighting);
    std::vector<Attribute> attributes{{nv097::ATTR_POSITION, "position", 3, kVertexStride, base}};
    std::uint32_t colors = base + kDiffuse, colors_stride = kVertexStride;
    if (on_chip) attributes.push_back({nv097::ATTR_NORMAL, "normal", 3, kVertexStride, base + kNormal});
    if (lighting.enabled && !on_chip) {
        const std::uint32_t count = range.greatest - range.least + 1;
        colors                    = draw.memory.add(lit_colors(draw, range.least, count),
                                                    draw.name + ": colours of " + std::to_string(count) + " vertices from " +
                                                        std::to_string(range.least) + " on, lit by the program");
        colors_stride             = kColorsStride;
        out.note("Lit by the program: the sources give no sure rule for what this lighting uses.");
    }
    attributes.push_back({nv097::ATTR_DIFFUSE, "diffuse", 4, colors_stride, colors, true});
    const bool needs_second =
        on_chip ? lighting.diffuse_source == ColorSource::Color2 : reads_second_color(draw.state());
    if (needs_second)
        attributes.push_back(
            {nv097::ATTR_SPECULAR, "specular", 4, colors_stride, colors + (kSpecular - kDiffuse), true});
    for (std::uint16_t stage = 0; stage < kTextureStages; ++stage) {
        if (!reads_coordinates(draw, stage)) continue;
        const bool is_second = draw.state().stages[stage].coords == CoordSource::Vertex1;
        attributes.push_back({static_cast<std::uint16_t>(nv097::ATTR_TEXTURE0 + stage), is_second ? "uv1" : "uv0", 2,
                              kVertexStride, base + kCoords[is_second ? 1 : 0]});
    }
    set_arrays(out, attributes);
    draw_triangles(out, range);
}

std::vector<Attribute> window_attributes(const Nv2aDraw& draw, std::uint32_t base) {
    std::vector<Attribute> attributes{{nv097::ATTR_POSITION, "position", 4, kWindowStride, base},
                                      {nv097::ATTR_DIFFUSE, "diffuse", 4, kWindowStride, base + kWindowDiffuse, true}};
    if (reads_second_color(draw.state()) || draw.has_fog())
        attributes.push_back({nv097::ATTR_SPECULAR, "specular", 4, kWindowStride, base + kWindowSpecular, true});
    for (std::uint16_t stage = 0; stage < kTextureStages; ++stage)
        if (reads_coordinates(draw, stage))
            attributes.push_back({static_cast<std::uint16_t>(nv097::ATTR_TEXTURE0 + stage), "coordinates", 4,
                                  kWindowStride, base + kWindowCoords[stage]});
    return attributes;
}

void draw_window(Nv2aStream& out, const Nv2aDraw& draw) {
    const DrawWindowTriangles& triangles = *draw.window_triangles();
    const IndexRange range               = range_of(draw.frame, triangles.first_index, triangles.index_count);
    if (range.indices.empty()) return;
    set_arrays(out, window_attributes(draw, draw.arrays.window_vertices + range.least * kWindowStride));
    draw_triangles(out, range);
}

// Clockwise from the top left.
std::vector<WindowVertex> corners(const DrawRectangle& rectangle) {
    std::vector<WindowVertex> vertices;
    for (const auto& [right, low] : {std::pair{false, false}, {true, false}, {true, true}, {false, true}}) {
        const auto coords = [&](const UvRect& uv) { return Vec3(right ? uv.u1 : uv.u0, low ? uv.v1 : uv.v0, 1.0f); };
        vertices.push_back({.x       = right ? rectangle.x1 : rectangle.x0,
                            .y       = low ? rectangle.y1 : rectangle.y0,
                            .z       = rectangle.depth,
                            .rhw     = 1.0f,
                            .diffuse = rectangle.color,
                            .uv0     = coords(rectangle.uv[0]),
                            .uv1     = coords(rectangle.uv[1])});
    }
    return vertices;
}

void draw_quad(Nv2aStream& out, const Nv2aDraw& draw) {
    const std::vector<WindowVertex> vertices = corners(*draw.rectangle());
    const std::uint32_t base                 = draw.memory.add(vertex_bytes(vertices), draw.name + ": rectangle");
    set_arrays(out, window_attributes(draw, base));
    out.act(nv097::SET_BEGIN_END, nv097::OP_QUADS, "QUADS");
    out.act(nv097::DRAW_ARRAYS, pack(nv097::DRAW_ARRAYS_START_INDEX, 0) | pack(nv097::DRAW_ARRAYS_COUNT, 3),
            "4 vertices from 0 on");
    out.act(nv097::SET_BEGIN_END, nv097::OP_END, "END");
}

}  // namespace

std::vector<std::uint8_t> vertex_bytes(const std::vector<Vertex>& vertices) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(vertices.size() * kVertexStride);
    for (const Vertex& v : vertices) {
        append_floats(bytes, {v.position.x, v.position.y, v.position.z, v.normal.x, v.normal.y, v.normal.z});
        append_word(bytes, v.diffuse.value);
        append_word(bytes, v.specular.value);
        append_floats(bytes, {v.uv0.x, v.uv0.y, v.uv1.x, v.uv1.y});
    }
    return bytes;
}

std::vector<std::uint8_t> vertex_bytes(const std::vector<WindowVertex>& vertices) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(vertices.size() * kWindowStride);
    for (const WindowVertex& v : vertices) {
        const double w = 1.0 / v.rhw;
        append_floats(bytes, {static_cast<float>(v.x * w), static_cast<float>(v.y * w), static_cast<float>(v.z * w),
                              static_cast<float>(w)});
        append_word(bytes, v.diffuse.value);
        append_word(bytes, v.specular.value);
        for (const Vec3& uv : {v.uv0, v.uv1}) append_floats(bytes, {uv.x, uv.y, 0.0f, uv.z});
    }
    return bytes;
}

void set_arrays_and_draw(Nv2aStream& out, const Nv2aDraw& draw) {
    if (draw.triangles() != nullptr) draw_object(out, draw);
    if (draw.window_triangles() != nullptr) draw_window(out, draw);
    if (draw.rectangle() != nullptr) draw_quad(out, draw);
}

}  // namespace pipeline
