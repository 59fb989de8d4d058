// SPDX-License-Identifier: MIT
#include "tests/peers/gl_window.h"

#include <array>
#include <vector>

#include "pipeline/execute/vertex_stage.h"
#include "tests/peers/gl_lighting.h"
#include "tests/peers/gl_names.h"
#include "tests/peers/gl_stages.h"
#include "tests/peers/gl_state.h"

namespace peers {

using namespace pipeline;

namespace {

struct Corner {
    Vec4 position;  // clip space
    Argb diffuse, specular;
    float fog = 1.0f;
    std::array<Vec4, kTextureStages> uv;
};

float snapped(float pixels) {
    return static_cast<float>(raster::snap_to_subpixels({}, pixels, 0.0f).x) / raster::kSubpixels;
}

Corner corner_of(const raster::Vertex& vertex, WindowTriangles which, const Target& target) {
    const bool is_snapped = which == WindowTriangles::Snapped;
    const double x = is_snapped ? snapped(vertex.x) : vertex.x, y = is_snapped ? snapped(vertex.y) : vertex.y;
    // Row 0 is the top one of all memory here, so y goes down.
    const glm::dvec4 window(2.0 * x / target.width - 1.0, 2.0 * y / target.height - 1.0, 2.0 * vertex.z - 1.0, 1.0);
    Corner corner{.position = Vec4(is_snapped ? window : window / double{vertex.rhw}),
                  .diffuse  = {vertex.diffuse},
                  .specular = {vertex.specular},
                  .fog      = static_cast<float>(vertex.specular >> 24) / 255.0f,
                  .uv       = {}};
    for (std::size_t stage = 0; stage < corner.uv.size(); ++stage) {
        const raster::TexCoord& uv = vertex.uv[stage];
        corner.uv[stage]           = Vec4(uv.s, uv.t, 0.0f, uv.q) * (is_snapped ? vertex.rhw : 1.0f);
    }
    return corner;
}

void draw_corners(const std::vector<Corner>& corners, int stages) {
    glEnableClientState(GL_VERTEX_ARRAY);
    glDisableClientState(GL_NORMAL_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glEnableClientState(GL_SECONDARY_COLOR_ARRAY);
    glEnableClientState(GL_FOG_COORD_ARRAY);
    glVertexPointer(4, GL_FLOAT, sizeof(Corner), &corners[0].position);
    glColorPointer(GL_BGRA, GL_UNSIGNED_BYTE, sizeof(Corner), &corners[0].diffuse);
    glSecondaryColorPointer(GL_BGRA, GL_UNSIGNED_BYTE, sizeof(Corner), &corners[0].specular);
    glFogCoordPointer(GL_FLOAT, sizeof(Corner), &corners[0].fog);
    for (int stage = 0; stage < kTextureStages; ++stage) {
        glClientActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + stage));
        if (stage < stages) {
            glEnableClientState(GL_TEXTURE_COORD_ARRAY);
            glTexCoordPointer(4, GL_FLOAT, sizeof(Corner), &corners[0].uv[stage]);
        } else {
            glDisableClientState(GL_TEXTURE_COORD_ARRAY);
        }
    }
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size()));
}

}  // namespace

void draw_window_triangles(const Frame& frame, const Pass& pass, const DrawTriangles& draw, WindowTriangles which,
                           const GlMemory& memory) {
    const bool culls = which == WindowTriangles::Placed;
    Pass staged      = pass;
    if (culls) staged.state.cull = CullMode::None;
    raster::Draw triangles;
    run_vertex_stage(frame, staged, draw, area_of(frame, pass).viewport, triangles);
    if (triangles.triangles.empty()) return;

    const Target& target = frame.targets[(pass.color ? pass.color : pass.depth).index];
    std::vector<Corner> corners;
    for (const raster::TriangleCorners& triangle : triangles.triangles)
        for (const raster::Vertex& vertex : raster::triangle_of(triangles, triangle))
            corners.push_back(corner_of(vertex, which, target));

    glViewport(0, 0, target.width, target.height);
    set_no_lighting(pass.state.lighting.specular_enable);
    const int stages = set_stages(pass.state, draw.textures, memory, false);
    set_fog(pass.state.fog);
    set_culling(culls ? pass.state.cull : CullMode::None);
    for (const GLenum matrix : {GL_PROJECTION, GL_MODELVIEW}) {
        glMatrixMode(matrix);
        glLoadIdentity();
    }
    draw_corners(corners, stages);
}

DrawRectangle snapped(const DrawRectangle& draw) {
    DrawRectangle result = draw;
    for (float* coordinate : {&result.x0, &result.y0, &result.x1, &result.y1}) *coordinate = snapped(*coordinate);
    return result;
}

}  // namespace peers
