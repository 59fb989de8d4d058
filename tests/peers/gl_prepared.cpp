// SPDX-License-Identifier: MIT
#include "tests/peers/gl_prepared.h"

#include <map>
#include <stdexcept>
#include <string>

#include "tests/peers/gl_geometry.h"
#include "tests/peers/gl_state.h"

namespace peers {

using namespace pipeline;

namespace {

GLuint filled_buffer(GLenum target, std::size_t bytes, const void* data) {
    GLuint name = 0;
    glGenBuffers(1, &name);
    glBindBuffer(target, name);
    glBufferData(target, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
    return name;
}

struct Mesh {
    std::vector<Corner> corners;
    std::vector<std::uint32_t> indices;
};

// Vertices in the order of their first use, each once; but corner by corner where flat shading gives a vertex its
// triangle's fog.
Mesh mesh_of(const Frame& frame, const Pass& pass, const DrawTriangles& draw) {
    Mesh mesh;
    const std::vector<Corner> corners = corners_of(frame, pass, draw);
    const bool own_fog                = pass.state.shade == ShadeMode::Flat && pass.state.fog.mode != FogMode::None;
    std::map<std::uint32_t, std::uint32_t> known;
    for (std::uint32_t i = 0; i < draw.index_count; ++i) {
        const auto next           = static_cast<std::uint32_t>(mesh.corners.size());
        const std::uint32_t key   = own_fog ? i : frame.indices[draw.first_index + i];
        const auto [found, first] = known.try_emplace(key, next);
        if (first) mesh.corners.push_back(corners[i]);
        mesh.indices.push_back(found->second);
    }
    return mesh;
}

}  // namespace

GlPreparedFrame::GlPreparedFrame(const Frame& frame) : frame_(frame), memory_(frame) {
    for (const Pass& pass : frame.passes) {
        std::vector<Arrays>& draws = arrays_.emplace_back();
        for (const Draw& draw : pass.draws) draws.push_back(prepare(pass, draw));
    }
    glBindVertexArray(0);
}

GlPreparedFrame::~GlPreparedFrame() {
    glBindVertexArray(0);
    for (const std::vector<Arrays>& draws : arrays_)
        for (const Arrays& arrays : draws) {
            glDeleteVertexArrays(1, &arrays.object);
            glDeleteBuffers(1, &arrays.vertices);
            glDeleteBuffers(1, &arrays.indices);
        }
}

GlPreparedFrame::Arrays GlPreparedFrame::make_arrays(const std::vector<Corner>& corners,
                                                     const std::vector<std::uint32_t>& indices, int stages) {
    Arrays arrays{.vertex_count = static_cast<GLuint>(corners.size()),
                  .index_count  = static_cast<GLsizei>(indices.size())};
    glGenVertexArrays(1, &arrays.object);
    glBindVertexArray(arrays.object);
    arrays.vertices = filled_buffer(GL_ARRAY_BUFFER, corners.size() * sizeof(Corner), corners.data());
    set_arrays(0, stages);
    arrays.indices = filled_buffer(GL_ELEMENT_ARRAY_BUFFER, indices.size() * sizeof(std::uint32_t), indices.data());
    return arrays;
}

GlPreparedFrame::Arrays GlPreparedFrame::prepare(const Pass& pass, const Draw& draw) const {
    if (const auto* rectangle = std::get_if<DrawRectangle>(&draw)) {
        const std::array<Corner, 4> corners = corners_of(*rectangle);
        Arrays arrays    = make_arrays({corners.begin(), corners.end()}, {0, 1, 2, 3}, stage_count(pass.state));
        arrays.primitive = GL_QUADS;
        return arrays;
    }
    if (const auto* triangles = std::get_if<DrawTriangles>(&draw)) {
        const Mesh mesh = mesh_of(frame_, pass, *triangles);
        return make_arrays(mesh.corners, mesh.indices, stage_count(pass.state));
    }
    return {};
}

void GlPreparedFrame::draw_pass(const Pass& pass, const std::vector<Arrays>& draws) {
    memory_.bind(pass.color, pass.depth);
    set_scissor(area_of(frame_, pass).scissor);
    clear(pass.clear);
    set_fragment_state(pass.state);
    const Draw* previous = nullptr;
    for (std::size_t i = 0; i < draws.size(); ++i) {
        const Draw& draw = pass.draws[i];
        if (const auto* copy = std::get_if<CopyRectangle>(&draw)) {
            memory_.copy(*copy, pass.color);
            continue;
        }
        const auto* triangles = std::get_if<DrawTriangles>(&draw);
        const bool same_state =
            previous != nullptr && previous->index() == draw.index() && textures_of(*previous) == textures_of(draw);
        const bool same_world =
            same_state && triangles != nullptr && std::get<DrawTriangles>(*previous).world == triangles->world;
        if (!same_state) {
            if (triangles != nullptr)
                set_triangle_state(frame_, pass, triangles->textures, memory_);
            else
                set_rectangle_state(frame_, pass, textures_of(draw), memory_);
        }
        if (triangles != nullptr && !same_world) set_world(frame_, pass, triangles->world);
        previous             = &draw;
        const Arrays& arrays = draws[i];
        if (arrays.index_count == 0) continue;
        glBindVertexArray(arrays.object);
        glDrawRangeElements(arrays.primitive, 0, arrays.vertex_count - 1, arrays.index_count, GL_UNSIGNED_INT, nullptr);
    }
}

void GlPreparedFrame::draw() {
    for (std::size_t i = 0; i < frame_.passes.size(); ++i) draw_pass(frame_.passes[i], arrays_[i]);
    glFinish();
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
        throw std::runtime_error("OpenGL reports error " + std::to_string(error));
}

}  // namespace peers
