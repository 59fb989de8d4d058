// SPDX-License-Identifier: MIT
#include "tests/peers/gl_geometry.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "tests/peers/gl_lighting.h"
#include "tests/peers/gl_names.h"
#include "tests/peers/gl_stages.h"
#include "tests/peers/gl_state.h"

namespace peers {

using namespace pipeline;

namespace {

double fog_factor(const FogState& fog, const Vec4& camera_position) {
    const glm::dvec4 p(camera_position);
    const double distance = fog.range ? std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z) : std::abs(p.z);
    const double depth    = fog.density * distance;
    switch (fog.mode) {
        case FogMode::None:
            return 1.0;
        case FogMode::Linear:
            if (fog.start == fog.end) return 0.0;
            return std::clamp((fog.end - distance) / (static_cast<double>(fog.end) - fog.start), 0.0, 1.0);
        case FogMode::Exp:
            return std::clamp(std::exp(-depth), 0.0, 1.0);
        case FogMode::Exp2:
            return std::exp(-depth * depth);
    }
    return 1.0;
}

void load_matrix(GLenum which, const glm::dmat4& matrix) {
    glMatrixMode(which);
    glLoadMatrixd(&matrix[0][0]);
}

glm::dmat4 opengl_projection(const Mat4& projection) {
    glm::dmat4 window(1.0), mirror(1.0);
    window[1][1] = -1.0;  // y down
    window[2][2] = 2.0;   // depth 0..1 to -1..1
    window[3][2] = -1.0;
    mirror[2][2] = -1.0;
    return window * glm::dmat4(projection) * mirror;
}

}  // namespace

std::vector<Corner> corners_of(const Frame& frame, const Pass& pass, const DrawTriangles& draw) {
    const Mat4 object_to_camera = frame.cameras[pass.camera.index].view * draw.world;
    std::vector<Corner> corners(draw.index_count);
    for (std::uint32_t i = 0; i < draw.index_count; ++i) {
        const Vertex& vertex = frame.vertices[frame.indices[draw.first_index + i]];
        const float fog =
            static_cast<float>(fog_factor(pass.state.fog, object_to_camera * Vec4(vertex.position, 1.0f)));
        Corner& corner = corners[i];
        corner         = {.position = vertex.position,
                          .normal   = vertex.normal,
                          .diffuse  = vertex.diffuse,
                          .specular = vertex.specular,
                          .fog      = fog,
                          .uv       = {}};
        // Flat shading takes the fog of the first vertex too, which OpenGL does not know.
        if (pass.state.shade == ShadeMode::Flat && i % 3 != 0) corner.fog = corners[i - i % 3].fog;
        for (int stage = 0; stage < kTextureStages; ++stage)
            corner.uv[stage] = pass.state.stages[stage].coords == CoordSource::Vertex1 ? vertex.uv1 : vertex.uv0;
    }
    return corners;
}

std::array<Corner, 4> corners_of(const DrawRectangle& draw) {
    std::array<Corner, 4> corners;
    for (int i = 0; i < 4; ++i) {
        const bool right = i == 1 || i == 2, bottom = i >= 2;
        Corner& corner  = corners[i];
        corner.position = {right ? draw.x1 : draw.x0, bottom ? draw.y1 : draw.y0, draw.depth};
        corner.diffuse  = draw.color;
        corner.specular = {0};
        for (int stage = 0; stage < kTextureStages; ++stage) {
            const UvRect& uv = draw.uv[stage];
            corner.uv[stage] = {right ? uv.u1 : uv.u0, bottom ? uv.v1 : uv.v0};
        }
    }
    return corners;
}

void set_arrays(std::uintptr_t corners, int stages) {
    const auto at = [&](std::size_t offset) { return reinterpret_cast<const void*>(corners + offset); };
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glEnableClientState(GL_SECONDARY_COLOR_ARRAY);
    glEnableClientState(GL_FOG_COORD_ARRAY);
    glVertexPointer(3, GL_FLOAT, sizeof(Corner), at(offsetof(Corner, position)));
    glNormalPointer(GL_FLOAT, sizeof(Corner), at(offsetof(Corner, normal)));
    glColorPointer(GL_BGRA, GL_UNSIGNED_BYTE, sizeof(Corner), at(offsetof(Corner, diffuse)));
    glSecondaryColorPointer(GL_BGRA, GL_UNSIGNED_BYTE, sizeof(Corner), at(offsetof(Corner, specular)));
    glFogCoordPointer(GL_FLOAT, sizeof(Corner), at(offsetof(Corner, fog)));
    for (int stage = 0; stage < kTextureStages; ++stage) {
        glClientActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + stage));
        if (stage < stages) {
            glEnableClientState(GL_TEXTURE_COORD_ARRAY);
            glTexCoordPointer(2, GL_FLOAT, sizeof(Corner),
                              at(offsetof(Corner, uv) + static_cast<std::size_t>(stage) * sizeof(Vec2)));
        } else {
            glDisableClientState(GL_TEXTURE_COORD_ARRAY);
        }
    }
}

int set_triangle_state(const Frame& frame, const Pass& pass, const TextureBindings& textures, const GlMemory& memory) {
    const Camera& camera     = frame.cameras[pass.camera.index];
    const PixelRect viewport = area_of(frame, pass).viewport;
    glViewport(viewport.x0, viewport.y0, viewport.x1 - viewport.x0, viewport.y1 - viewport.y0);
    if (pass.state.lighting.enabled)
        set_lighting(pass.state.lighting, camera);
    else
        set_no_lighting(pass.state.lighting.specular_enable);
    const int stages = set_stages(pass.state, textures, memory, true);
    set_fog(pass.state.fog);
    set_culling(pass.state.cull);
    load_matrix(GL_PROJECTION, opengl_projection(camera.projection));
    return stages;
}

void set_world(const Frame& frame, const Pass& pass, const Mat4& world) {
    load_matrix(GL_MODELVIEW, glm::dmat4(opengl_view(frame.cameras[pass.camera.index])) * glm::dmat4(world));
}

int set_rectangle_state(const Frame& frame, const Pass& pass, const TextureBindings& textures, const GlMemory& memory) {
    const Target& target = frame.targets[(pass.color ? pass.color : pass.depth).index];
    glViewport(0, 0, target.width, target.height);
    set_no_lighting(false);
    const int stages = set_stages(pass.state, textures, memory, false);
    set_fog({});
    set_culling(CullMode::None);
    // Pixels to -1..1, depth 0..1 likewise.
    glm::dmat4 projection(1.0);
    projection[0][0] = 2.0 / target.width;
    projection[1][1] = 2.0 / target.height;
    projection[2][2] = 2.0;
    projection[3]    = glm::dvec4(-1.0, -1.0, -1.0, 1.0);
    load_matrix(GL_PROJECTION, projection);
    load_matrix(GL_MODELVIEW, glm::dmat4(1.0));
    return stages;
}

void draw_triangles(const Frame& frame, const Pass& pass, const DrawTriangles& draw, const GlMemory& memory) {
    const std::vector<Corner> corners = corners_of(frame, pass, draw);
    if (corners.empty()) return;
    const int stages = set_triangle_state(frame, pass, draw.textures, memory);
    set_world(frame, pass, draw.world);
    set_arrays(reinterpret_cast<std::uintptr_t>(corners.data()), stages);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size()));
}

void draw_rectangle(const Frame& frame, const Pass& pass, const DrawRectangle& draw, const GlMemory& memory) {
    const std::array<Corner, 4> corners = corners_of(draw);
    const int stages                    = set_rectangle_state(frame, pass, draw.textures, memory);
    set_arrays(reinterpret_cast<std::uintptr_t>(corners.data()), stages);
    glDrawArrays(GL_QUADS, 0, static_cast<GLsizei>(corners.size()));
}

}  // namespace peers
