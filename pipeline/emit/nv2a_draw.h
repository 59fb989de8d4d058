// SPDX-License-Identifier: MIT
// What the writers of one draw's methods share, and those writers: textures and combiners, transform and lights, vertices.
#pragma once

#include <variant>

#include "pipeline/emit/nv2a_combiners.h"
#include "pipeline/emit/nv2a_memory.h"
#include "pipeline/emit/nv2a_stream.h"

namespace pipeline {

// Where vertices that are not the draw's own lie. Zero if the frame has none.
struct Nv2aVertexArrays {
    std::uint32_t vertices = 0, window_vertices = 0;
};

struct Nv2aDraw {
    const Frame& frame;
    const Pass& pass;
    const Draw& draw;
    Nv2aMemory& memory;
    const Nv2aVertexArrays& arrays;
    std::string name;  // "pass 3 'composite', draw 0"

    const DrawTriangles* triangles() const { return std::get_if<DrawTriangles>(&draw); }
    const DrawWindowTriangles* window_triangles() const { return std::get_if<DrawWindowTriangles>(&draw); }
    const DrawRectangle* rectangle() const { return std::get_if<DrawRectangle>(&draw); }
    const PipelineState& state() const { return pass.state; }
    bool has_fog() const { return state().fog.mode != FogMode::None && rectangle() == nullptr; }
    // A depth of 1, in units of the pass's depth buffer.
    float greatest_depth() const;
};

// By stage; nothing where a stage is off, reads none or has none bound.
Nv2aTexels texels_of(const Nv2aDraw& draw);

// Does the stage's texture take coordinates in texels?
bool has_texel_coordinates(const Nv2aDraw& draw, std::size_t stage);

void set_combiners(Nv2aStream& out, const Nv2aDraw& draw);
void set_textures(Nv2aStream& out, const Nv2aDraw& draw);

// Matrices, generated coordinates, fog.
void set_transform(Nv2aStream& out, const Nv2aDraw& draw);

// Writes the vertices that the draw has for itself to memory, and all the primitives.
void set_arrays_and_draw(Nv2aStream& out, const Nv2aDraw& draw);

// What frames have of vertices, as the arrays that the draws read: 48 bytes each, position, normal, two colours, two pairs of
// coordinates; and 56 bytes each, (x, y, z, 1) times w, two colours, two times (s, t, 0, q).
std::vector<std::uint8_t> vertex_bytes(const std::vector<Vertex>& vertices);
std::vector<std::uint8_t> vertex_bytes(const std::vector<WindowVertex>& vertices);

}  // namespace pipeline
