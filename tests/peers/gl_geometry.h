// SPDX-License-Identifier: MIT
// A pass's draws. Triangles go through OpenGL's own transform, clipping and lighting; the projection is changed to
// its conventions: depth -1..1 before the viewport, z of camera space negated (gl_lighting.h), and y down, since row
// 0 of all memory here is the top row.
// Fog is Direct3D's vertex fog: the factor of each vertex, here from the C library's functions in double, is handed
// to OpenGL as a fog coordinate, with linear fog that ends at 0 and starts at 1, so that OpenGL only interpolates it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "pipeline/frame/frame.h"
#include "tests/peers/gl_memory.h"

namespace peers {

// A corner of a triangle or rectangle, as OpenGL's arrays read it.
struct Corner {
    pipeline::Vec3 position;
    pipeline::Vec3 normal = pipeline::Vec3(0.0f);
    pipeline::Argb diffuse, specular;
    float fog = 1.0f;
    std::array<pipeline::Vec2, pipeline::kTextureStages> uv;
};

// One for each index; of a rectangle clockwise from the top left.
std::vector<Corner> corners_of(const pipeline::Frame& frame, const pipeline::Pass& pass,
                               const pipeline::DrawTriangles& draw);
std::array<Corner, 4> corners_of(const pipeline::DrawRectangle& draw);

// Where the arrays are: an address, or an offset into the buffer that is bound to GL_ARRAY_BUFFER.
void set_arrays(std::uintptr_t corners, int stages);

// All state of a draw beyond its pass's, but for the world matrix of triangles. Returns how many stages are in use. The
// pass's targets are bound, its area and fragment state set.
int set_triangle_state(const pipeline::Frame& frame, const pipeline::Pass& pass,
                       const pipeline::TextureBindings& textures, const GlMemory& memory);
int set_rectangle_state(const pipeline::Frame& frame, const pipeline::Pass& pass,
                        const pipeline::TextureBindings& textures, const GlMemory& memory);
void set_world(const pipeline::Frame& frame, const pipeline::Pass& pass, const pipeline::Mat4& world);

// The same, and the draw itself.
void draw_triangles(const pipeline::Frame& frame, const pipeline::Pass& pass, const pipeline::DrawTriangles& draw,
                    const GlMemory& memory);
void draw_rectangle(const pipeline::Frame& frame, const pipeline::Pass& pass, const pipeline::DrawRectangle& draw,
                    const GlMemory& memory);

}  // namespace peers
