// SPDX-License-Identifier: MIT
#include "pipeline/execute/window_triangles.h"

#include <algorithm>

#include "pipeline/execute/vertex_stage.h"

namespace pipeline {

namespace {

WindowVertex window_vertex(const raster::Vertex& vertex) {
    const auto uv = [&](int i) { return Vec3(vertex.uv[i].s, vertex.uv[i].t, vertex.uv[i].q); };
    return {.x        = vertex.x,
            .y        = vertex.y,
            .z        = vertex.z,
            .rhw      = vertex.rhw,
            .diffuse  = {vertex.diffuse},
            .specular = {vertex.specular},
            .uv0      = uv(0),
            .uv1      = uv(1)};
}

// Keeps the vertices that triangles name, in their order.
class MeshBuilder {
  public:
    explicit MeshBuilder(const raster::Draw& draw) : draw_(draw), place_(draw.vertices.size(), kNone) {}

    void add(const raster::TriangleCorners& corners) {
        if (draw_.flat) {
            for (const raster::Vertex& vertex : triangle_of(draw_, corners)) mesh_.indices.push_back(append(vertex));
            return;
        }
        for (const std::uint32_t corner : corners) {
            if (place_[corner] == kNone) place_[corner] = append(draw_.vertices[corner]);
            mesh_.indices.push_back(place_[corner]);
        }
    }
    WindowMesh take() { return std::move(mesh_); }

  private:
    static constexpr std::uint32_t kNone = 0xffffffff;

    std::uint32_t append(const raster::Vertex& vertex) {
        mesh_.vertices.push_back(window_vertex(vertex));
        return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
    }

    const raster::Draw& draw_;
    std::vector<std::uint32_t> place_;
    WindowMesh mesh_;
};

}  // namespace

WindowMesh to_window_triangles(const Frame& frame, const Pass& pass, const DrawTriangles& draw,
                               const PixelRect& viewport, float guard_band) {
    raster::Draw drawn;
    VertexStageDraw stage_draw{
        .pass = &pass, .draw = &draw, .viewport = viewport, .guard_band = guard_band, .out = &drawn, .counts = {}};
    VertexStage().run(frame, {&stage_draw, 1});
    MeshBuilder mesh(drawn);
    for (const raster::TriangleCorners& corners : drawn.triangles) mesh.add(corners);
    return mesh.take();
}

}  // namespace pipeline
